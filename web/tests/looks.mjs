// How the page, the book and the docs look.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";

import { range } from "../page/curves.js";
import { thinned } from "../page/loops.js";
import { closed, file, mapped, opened, serious } from "./driver.mjs";

/** The range of the curves holds all of every bounded loop, whatever the others do. */
export async function ranges() {
  const columns = { value: 0, width: 1 };
  const bounded = { rows: [-37, 2], columns, tame: true };
  for (const grown of [[0, 1e9], [-1e9, 0], [-1e9, 1e9], [0, 0]]) {
    const [low, high] = range([bounded, { rows: grown, columns, tame: false }], "value", 1, 0.05);
    assert.ok(low < -37 && high > 2 && high - low < 110, `${low} to ${high} beside ${grown}`);
  }
}

/** Rows of a fast loop are thinned, and no peak is lost: the least and the largest of each column are those of all rows. */
export async function thin() {
  const rows = Float64Array.from({ length: 5 * 47 }, (_, index) => Math.sin(index * index) * (index % 5 + 1));
  const kept = thinned(rows, 10);
  assert.equal(kept.length, 5 * 10);
  for (let column = 0; column < 5; column += 1) {
    const of = (all) => [...all].filter((_, index) => index % 5 === column);
    for (const end of [Math.min, Math.max]) assert.equal(end(...of(kept)), end(...of(rows)));
    for (const end of [Math.min, Math.max]) assert.equal(end(...of(kept).slice(-2)), end(...of(rows).slice(40)));
  }
  assert.equal(thinned(rows, 2), rows);
}

/** Wide and narrow, light and dark: nothing sticks out, nothing is asked for, axe-core finds nothing serious. */
export async function looks(browser) {
  for (const width of [1280, 360]) {
    for (const scheme of ["light", "dark"]) {
      const page = await opened(browser, { width, scheme, height: 900 });
      await mapped(page);
      await page.until("document.querySelectorAll('#members tbody tr').length > 10", 60);
      const [wide, shown] = await page.value("[document.documentElement.scrollWidth, document.documentElement.clientWidth]");
      assert.ok(wide <= shown, `${wide} pixels wide on ${shown}`);
      assert.deepEqual(await serious(page), [], `${width} ${scheme}`);
      await closed(page);
    }
  }
}

/** The height of what the frame of a chapter shows, and of the frame, once it stays. */
async function heights(page) {
  const { frameTree } = await page.send("Page.getFrameTree");
  const { executionContextId: contextId } = await page.send("Page.createIsolatedWorld", { frameId: frameTree.childFrames[0].frame.id });
  const expression = "document.documentElement.dataset.ready === 'yes' ? [document.querySelector('main').getBoundingClientRect().bottom, innerHeight] : null";
  for (let tries = 0, last = null; tries < 200; tries += 1) {
    const { result } = await page.send("Runtime.evaluate", { expression, contextId, returnByValue: true });
    if (result.value && String(result.value) === last) return result.value;
    last = String(result.value);
    await new Promise((done) => setTimeout(done, 50));
  }
  throw new Error("the page in the frame never began");
}

/** The chapters of the book: equations are drawn, frames show all of a loop, nothing fails or comes from elsewhere, and axe-core finds
 *  nothing serious. */
export async function book(browser) {
  const site = join(dirname(dirname(file)), "site");
  for (const [chapter, equations] of Object.entries({ index: 0, port: 4, ledger: 4, candidate: 4, "your-loop": 2 })) {
    for (const [width, scheme] of [[1100, "light"], [1280, "dark"], [600, "dark"], [360, "light"]]) {
      const at = `${chapter} ${width} ${scheme}`;
      const page = await browser.open(`file://${join(site, "book/chapters", `${chapter}.html`)}`, { width, scheme, height: 3000 });
      await page.until("document.querySelector('iframe') !== null");
      assert.ok(await page.value(`document.querySelectorAll('math').length >= ${equations}`), at);
      assert.ok(await page.value("!document.querySelector('main, [role=main]').textContent.includes('$')"), at);
      await page.place("iframe");
      const [shown, tall] = await heights(page);
      assert.ok(shown > 900 && shown < tall, `${at}: ${shown} pixels in a frame of ${tall}`);
      assert.deepEqual(await serious(page), [], at);
      const faults = page.faults().filter((it) => !it.startsWith("request: file://"));
      assert.deepEqual(faults, [], at);
      await page.close();
    }
  }
}

/** A list or a listing in a paragraph, which Markdown did not see. */
const UNDRAWN = `[...document.querySelectorAll("[role=main] :is(p, li)")]
  .map((it) => it.textContent.match(/\`\`\`.*|^([-*]|\\d+\\.) .*/m)?.[0]).find((it) => it) ?? null`;

/** The docs around it: every page is drawn and no wider than the screen, and axe-core finds nothing serious in some of them,
 *  since all share one template. */
export async function docs(browser) {
  const site = join(dirname(dirname(file)), "site");
  const pages = readdirSync(site, { recursive: true }).filter((it) => it.endsWith(".html") && !/^(book|search)/.test(it)).sort();
  assert.ok(pages.includes("index.html") && pages.length > 100, `${pages.length} pages`);
  for (const [index, at] of pages.entries()) {
    const [width, scheme] = [index % 3 ? 360 : 1100, index % 2 ? "dark" : "light"];
    const page = await browser.open(`file://${join(site, at)}`, { width, scheme });
    await page.until("document.querySelector('[role=main] p') !== null");
    assert.ok(await page.value("document.documentElement.scrollWidth <= innerWidth"), `${at} is too wide`);
    assert.equal(await page.value(UNDRAWN), null, `${at} has Markdown that is not drawn`);
    if (index % 24 === 0) assert.deepEqual(await serious(page), [], at);
    assert.deepEqual(page.faults().filter((it) => !it.startsWith("request: file://")), [], at);
    await page.close();
  }
}

/** The search of the docs, from a disk: sections that have all words, each by a link to a heading that is there. */
export async function searched(browser) {
  const site = join(dirname(dirname(file)), "site");
  for (const [width, scheme] of [[1100, "light"], [360, "dark"]]) {
    const page = await browser.open(`file://${join(site, "search.html")}?q=shortfall`, { width, scheme });
    await page.until("document.querySelectorAll('#mkdocs-search-results article').length > 10");
    const found = await page.value("[...document.querySelectorAll('#mkdocs-search-results a')].map((it) => it.getAttribute('href'))");
    for (const [at, heading] of found.map((it) => it.split("#"))) {
      const text = readFileSync(join(site, at), "utf8");
      assert.ok(/shortfall/i.test(text) && text.includes(`id="${decodeURIComponent(heading)}"`), `${at}#${heading}`);
    }
    assert.ok(await page.value("[...document.querySelectorAll('article')].every((it) => /shortfall/i.test(it.textContent))"));
    assert.deepEqual(await serious(page), [], scheme);
    const asked = (words) => `(() => { const box = document.getElementById("mkdocs-search-query"); box.value = "${words}";
      box.dispatchEvent(new Event("input")); return document.querySelector("#mkdocs-search-results").textContent; })()`;
    assert.match(await page.value(asked("environment.wall.stiffness")), /stiffness/);
    assert.match(await page.value(asked("shortfall of no such word")), /^No section/);
    assert.match(await page.value(asked("*:^~")), /^No section/);
    assert.deepEqual(page.faults().filter((it) => !it.startsWith("request: file://")), []);
    await page.close();
  }
}
