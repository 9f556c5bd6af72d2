// Looks at the page in a headless Chromium: `node web/test.mjs PAGE LYAPUNOV CHROMIUM TOOLS [CHECK…]`, from anywhere.
//
// The page has to compute what the command LYAPUNOV computes, bit for bit, and to be usable: without a mouse, on a narrow
// screen, in light and dark, without a request, an error or a serious finding of axe-core.

import { rmSync } from "node:fs";

import { Browser } from "../scripts/chromium.mjs";
import { chromium, folder, only } from "./tests/driver.mjs";
import { stale, thrifty } from "./tests/fresh.mjs";
import { lines } from "./tests/lines.mjs";
import { book, docs, looks, ranges, searched, thin } from "./tests/looks.mjs";
import { buttons, dashes, labels, quiet, short } from "./tests/reach.mjs";
import { dropped, maps, paper, reasons, rows, words } from "./tests/same.mjs";
import { awaited, named, refused, shared, taken } from "./tests/share.mjs";
import { caps, family, frames, hand, limit, steps } from "./tests/use.mjs";

const CHECKS = [
  ranges, thin, thrifty, words, rows, dropped, maps, steps, limit, family, reasons, stale, caps, hand, frames,
  labels, buttons, quiet, dashes, short, shared, awaited, taken, named, refused, paper, lines, looks, book, docs, searched,
];

const browser = new Browser(chromium);
try {
  for (const check of CHECKS) {
    if (only.length && !only.includes(check.name)) continue;
    const began = performance.now();
    await check(browser);
    console.log(`${check.name}: done in ${((performance.now() - began) / 1e3).toFixed(1)} s`);
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
