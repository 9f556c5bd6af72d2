// What stands on the page is of the setting that it shows.

import assert from "node:assert/strict";

import { RUN } from "../page/engine.js";
import { pictured } from "../page/family.js";
import { bandOf } from "../page/worker.js";
import { closed, mapped, opened } from "./driver.mjs";

const PALE = `['#why-said', '#energies', '#remedies', '#members'].map((it) => document.querySelector(it))
  .map(({ inert, ariaBusy }) => inert && ariaBusy === 'true')`;

/** Answers of the setting before are pale and cannot be pressed; the new ones come before the map. */
export async function stale(browser) {
  const page = await opened(browser);
  await mapped(page);
  await page.until(`!document.querySelector('[inert]') && document.querySelector('.remedy')`, 60);
  const [pale, pressed] = await page.value(`(() => { const it = document.querySelector('input[name="device.mass"]');
    it.value = 0.6 * it.max; it.dispatchEvent(new Event("input"));
    document.querySelector('.remedy').focus(); return [${PALE}, document.activeElement.className]; })()`);
  assert.deepEqual([pale, pressed], [[true, true, true, true], ""]);
  const order = await page.value(`new Promise((done) => { const at = document.querySelector('#map-said');
    const rows = () => document.querySelectorAll('#members tbody tr').length;
    const look = () => at.textContent.includes('runs in') && done([${PALE}, rows()]);
    new MutationObserver(look).observe(at, { childList: true, characterData: true, subtree: true }); })`);
  const names = await page.value("lyapunov.engine.lines('names', lyapunov.scene())");
  assert.deepEqual(order, [[false, false, false, false], names.length]);
  await closed(page);
}

/** A long scene: the worker looks at its messages after few ticks of a map, and of each run it sends a small picture, not all rows. */
export async function thrifty() {
  for (const ticks of [10, 2e3, 1e5, 1e6]) {
    const cells = bandOf(ticks, 256);
    assert.ok(cells % 256 === 0 && cells >= 256 && (cells === 256 || cells * ticks <= 5e7), `${cells} cells of ${ticks} ticks`);
  }
  for (const many of [1, 399, 5000, 1e5]) {
    const rows = Float64Array.from({ length: RUN.width * many }, (_, at) => (at % RUN.width === RUN.x ? -Math.floor(at / RUN.width) : 1e9));
    const { places, widest } = pictured({ name: "none", verdict: 0, rows });
    assert.ok(places.length >= Math.min(many, 400) && places.length <= 800, `${places.length} of ${many}`);
    assert.equal(widest, many - 1);
    // The first and the last fill the picture.
    assert.ok(-places[0] <= 0 && -places.at(-1) >= (many - 1) * 0.99 - 1);
  }
}
