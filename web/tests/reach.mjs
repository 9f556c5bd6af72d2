// What the page is to someone who does not see it, not all its colours, or does not point with care.

import assert from "node:assert/strict";

import { closed, drop, opened, serious, slide } from "./driver.mjs";

const RIGHT = { button: "right", buttons: 2, clickCount: 1 };

/** Every slider has one label, by which it is called, and which leads to it. */
export async function labels(browser) {
  const page = await opened(browser);
  const inputs = "[...document.querySelectorAll('#sliders input')]";
  const told = await page.value(`${inputs}.map((it) => [...it.labels].map((label) => label.textContent.trim()))`);
  assert.equal(told.length, 13);
  for (const it of told) assert.ok(it.length === 1 && it[0] !== "", JSON.stringify(told));
  const { nodes } = await page.send("Accessibility.getFullAXTree");
  const called = nodes.filter((it) => it.role?.value === "slider").map((it) => it.name.value);
  for (const name of ["Wall stiffness", "Delay", "Start"]) assert.ok(called.includes(name), called.join());
  const text = await page.place("#sliders label span");
  await page.click(text.x, text.y);
  assert.equal(await page.value("document.activeElement.name"), "environment.wall.stiffness");
  await closed(page);
}

/** A word that stands for a run that is too short can be read, in light and dark. */
export async function short(browser) {
  for (const scheme of ["light", "dark"]) {
    const page = await opened(browser, { scheme });
    await drop(page, [["short.toml", `${(await page.value("lyapunov.scene()")).replace(/^duration.*$/m, "duration = 0.008")}`]]);
    await page.until("document.querySelectorAll('#verdicts .word.short').length === 3");
    await page.until("document.querySelectorAll('#members .word.short').length > 10 && !document.querySelector('[inert]')", 60);
    assert.deepEqual(await serious(page), [], scheme);
    await closed(page);
  }
}

/** The hand follows the first button alone, and lets go where the pointer is taken away. */
export async function buttons(browser) {
  const page = await opened(browser);
  const { x, y } = await page.place("#wall");
  const hand = () => page.value("lyapunov.loops.touched && lyapunov.loops.hand");
  await page.mouse("mousePressed", x, y, RIGHT);
  await page.mouse("mouseMoved", x + 50, y, RIGHT);
  await page.mouse("mouseReleased", x + 50, y, RIGHT);
  assert.equal(await hand(), false);
  await page.value("document.querySelector('#wall').addEventListener('pointerdown', (it) => (globalThis.pressed = it.pointerId)); 0");
  await page.mouse("mousePressed", x, y, { button: "left", buttons: 1, clickCount: 1 });
  await page.mouse("mouseMoved", x + 20, y, { button: "left", buttons: 1 });
  await page.value("document.querySelector('#wall').releasePointerCapture(pressed); 0");
  await page.mouse("mouseMoved", x + 21, y, { button: "left", buttons: 1 });
  const held = await hand();
  await page.mouse("mouseMoved", x + 60, y, { button: "left", buttons: 1 });
  assert.equal(await hand(), held);
  await page.mouse("mouseReleased", x + 60, y, { button: "left", clickCount: 1 });
  await closed(page);
}

/** The words on the loops are read out where they change, and not anew on each step of a slider. */
export async function quiet(browser) {
  const page = await opened(browser);
  await page.value(`(() => { globalThis.heard = []; const hear = (all) => heard.push(...all.map(({ target }) => target.className || target.nodeName));
    const all = { childList: true, characterData: true, subtree: true };
    new MutationObserver(hear).observe(document.querySelector('#verdicts'), all); })()`);
  const heard = async (key, place) => {
    await page.value("heard.length = 0; 0");
    await slide(page, key, place);
    return page.value("heard");
  };
  // Nothing in the run follows from where the wall's stiffness stood already.
  await heard("environment.wall.stiffness", 0.5);
  assert.deepEqual(await heard("environment.wall.stiffness", 0.5), []);
  assert.ok((await heard("environment.wall.stiffness", 0.95)).some((it) => it.startsWith("word")));
  await closed(page);
}

/** The curves of the three loops differ in their dashes, and each card carries those of its loop. */
export async function dashes(browser) {
  const page = await opened(browser);
  await page.value(`(() => { globalThis.drawn = new Set(); const { stroke } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.stroke = function () {
      if (this.canvas.id === "curves") drawn.add(this.strokeStyle + " " + this.getLineDash());
      stroke.call(this);
    }; })()`);
  await page.value("document.querySelector('#show-run').click(); 0");
  await page.until("drawn.size >= 4");
  const style = "getComputedStyle(document.documentElement)";
  const colours = await page.value(`['none', 'popc', 'lolc'].map((it) => ${style}.getPropertyValue('--' + it).trim())`);
  const drawn = await page.value("[...drawn]");
  const own = colours.map((colour) => drawn.filter((it) => it.startsWith(`${colour} `)).map((it) => it.split(" ")[1]));
  assert.equal(new Set(own.flat()).size, 3, JSON.stringify(drawn));
  const cards = await page.value("[...document.querySelectorAll('.card h3')].map((it) => getComputedStyle(it, '::before').borderTopStyle)");
  assert.deepEqual(cards, ["solid", "dashed", "dotted"]);
  await closed(page);
}
