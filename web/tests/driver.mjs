// What tests of the page share: the page in a tab, what a person does to it, what the command says.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const [file, program, chromium, tools, ...only] = process.argv.slice(2);
export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
const url = `file://${file}`;
export const folder = mkdtempSync(join(tmpdir(), "lyapunov-web-"));
const axe = readFileSync(join(tools, "node_modules/axe-core/axe.min.js"), "utf8");
export const lyapunov = (...words) => execFileSync(program, words, { encoding: "utf8", cwd: root, maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "inherit"] });
export const opened = async (browser, about = {}, hash = "") => {
  const page = await browser.open(url + hash, about);
  await page.until("document.documentElement.dataset.ready === 'yes'");
  return page;
};
/** The words on the three loops. */
export const verdicts = (page) => page.value("[...document.querySelectorAll('#verdicts .word')].map((it) => it.textContent)");
export const mapped = (page) => page.until("document.querySelector('#map-said').textContent.includes('runs in')", 60);
export const closed = async (page) => {
  assert.deepEqual(page.faults(), []);
  await page.close();
};
/** Moves a slider as a person does: to a place from 0 to 1. */
export const slide = (page, key, place) =>
  page.value(`(() => { const it = document.querySelector('input[name="${key}"]'); it.value = ${place} * it.max; it.dispatchEvent(new Event("input")); })()`);
/** Whether an element comes to be in view. */
export const seen = (page, selector) =>
  page.until(`(({ height, top, bottom }) => height > 0 && top >= 0 && bottom <= innerHeight)(document.querySelector("${selector}").getBoundingClientRect())`);
/** Motions that scenes name. */
export const MOTIONS = ["motion-file.csv"];
/** The verdicts of loops by their names, as the command tells them of a scene. */
export const told = (path, names) => JSON.parse(lyapunov("compare", path, "--stabilizers", names.join(","), "--json")).rows.map((it) => it.verdict);
export const cards = (page) => page.value("[...document.querySelectorAll('#verdicts .card')].map((it) => it.dataset.name)");
/** Chooses an entry of a list. */
export const choose = (page, id, entry) =>
  page.value(`(() => { const it = document.querySelector("#${id}"); it.value = "${entry}"; it.dispatchEvent(new Event("change")); })()`);
/** Chooses the candidate of LOLC. */
export const credit = (page, name) => choose(page, "candidate", name);
/** Drops files, each a name and a text. */
export const drop = (page, files) =>
  page.value(`(() => { const data = new DataTransfer();
    for (const [name, text] of ${JSON.stringify(files)}) data.items.add(new File([text], name));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })); })()`);
/** The text of the file that a button saves. */
export const saved = (page, button) =>
  page.value(`(async () => { const was = URL.createObjectURL; let blob = null;
    URL.createObjectURL = (it) => { blob = it; return was.call(URL, it); };
    document.querySelector("${button}").click(); URL.createObjectURL = was; return blob.text(); })()`);

/** What axe-core finds serious on a page; the pages in its frames are looked at by themselves. */
export async function serious(page) {
  await page.value(`${axe}; 0`);
  return page.value(`axe.run({ exclude: [["iframe"]] }, { iframes: false, preload: false, runOnly: ["wcag2a", "wcag2aa", "wcag21aa", "best-practice"] }).then(({ violations }) =>
    violations.filter((it) => ["serious", "critical"].includes(it.impact)).map((it) => it.id + ": " + it.nodes.map((node) => node.html).slice(0, 4).join(" | ")))`);
}
