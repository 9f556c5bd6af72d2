// A headless Chromium on a pipe, for scripts that look at pages: nothing but node and the browser.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

/** A browser that speaks the DevTools protocol over file descriptors 3 and 4. */
export class Browser {
  constructor(program) {
    this.profile = mkdtempSync(join(tmpdir(), "pages-"));
    const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--no-first-run",
      "--disable-background-networking", "--force-device-scale-factor=1", `--user-data-dir=${this.profile}`];
    this.child = spawn(program, flags, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.last = 0;
    this.waiting = new Map();
    this.heard = [];
    let rest = "";
    this.child.stdio[4].setEncoding("utf8");
    this.child.stdio[4].on("data", (text) => {
      const parts = (rest + text).split("\0");
      rest = parts.pop();
      parts.forEach((part) => this.hear(JSON.parse(part)));
    });
  }

  hear(message) {
    if (message.id === undefined) return this.heard.push(message);
    const { done, fail } = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    return message.error ? fail(new Error(message.error.message)) : done(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    this.last += 1;
    const id = this.last;
    const answer = new Promise((done, fail) => this.waiting.set(id, { done, fail }));
    this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return answer;
  }

  /** A tab that shows `url`, `width` pixels wide, in `scheme` light or dark. */
  async open(url, { width = 1200, height = 900, scheme = "light" } = {}) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
    await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 600 });
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
    await page.send("Page.navigate", { url });
    await page.until("document.readyState === 'complete'");
    return page;
  }

  async close() {
    await this.send("Browser.close").catch(() => {});
    await new Promise((done) => (this.child.exitCode === null ? this.child.on("exit", done) : done()));
    rmSync(this.profile, { recursive: true, force: true });
  }
}

class Page {
  constructor(browser, session, target) {
    Object.assign(this, { browser, session, target });
  }

  send(method, params) {
    return this.browser.send(method, params, this.session);
  }

  /** The value of an expression on the page. */
  async value(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(condition, seconds = 20) {
    for (let tries = 0; tries < 50 * seconds; tries += 1) {
      if (await this.value(condition)) return;
      await new Promise((done) => setTimeout(done, 20));
    }
    throw new Error(`never came true: ${condition}`);
  }

  mouse(type, x, y, more = {}) {
    return this.send("Input.dispatchMouseEvent", { type, x, y, ...more });
  }

  async click(x, y) {
    for (const type of ["mousePressed", "mouseReleased"]) await this.mouse(type, x, y, { button: "left", clickCount: 1 });
  }

  async key(key, modifiers = 0) {
    const text = key.length === 1 ? key : key === "Enter" ? "\r" : undefined;
    const code = { Enter: 13, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 }[key];
    await this.send("Input.dispatchKeyEvent", { type: text ? "keyDown" : "rawKeyDown", key, text, modifiers, windowsVirtualKeyCode: code });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, modifiers, windowsVirtualKeyCode: code });
  }

  /** The middle of the first element of a selector, scrolled into view. */
  place(selector) {
    return this.value(`(() => { const it = document.querySelector(${JSON.stringify(selector)}); it.scrollIntoView({ block: "center" });
      const b = it.getBoundingClientRect(); return { x: b.left + b.width / 2, y: b.top + b.height / 2, left: b.left, top: b.top, width: b.width, height: b.height }; })()`);
  }

  /** What went wrong so far: errors, warnings, and requests for anything but the page itself. */
  faults() {
    const own = this.browser.heard.filter((message) => message.sessionId === this.session);
    const told = (method, words) => own.filter((message) => message.method === method).map((message) => words(message.params));
    const requests = told("Network.requestWillBeSent", ({ request, type }) => (type === "Document" || /^(data|blob):/.test(request.url) ? "" : `request: ${request.url}`));
    return [
      ...told("Runtime.exceptionThrown", ({ exceptionDetails }) => exceptionDetails.exception?.description ?? exceptionDetails.text),
      ...told("Log.entryAdded", ({ entry }) => `${entry.level}: ${entry.text}`),
      ...told("Runtime.consoleAPICalled", ({ type, args }) => `console.${type}: ${args.map((it) => it.value ?? it.description).join(" ")}`),
      ...requests,
    ].filter(Boolean);
  }

  async picture(isWhole = true) {
    const { data } = await this.send("Page.captureScreenshot", { captureBeyondViewport: isWhole });
    return Buffer.from(data, "base64");
  }

  async printed() {
    const { data } = await this.send("Page.printToPDF", { printBackground: true, paperWidth: 8.27, paperHeight: 11.69 });
    return Buffer.from(data, "base64");
  }

  close() {
    return this.browser.send("Target.closeTarget", { targetId: this.target });
  }
}
