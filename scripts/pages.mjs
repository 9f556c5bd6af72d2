// Looks at report pages in a headless Chromium: `node scripts/pages.mjs LYAPUNOV [CHROMIUM]`, from the repository.
//
// The program LYAPUNOV makes pages of shipped scenes. Each has to load on a wide and on a narrow screen, in light and dark,
// without an error, a request or anything cut off, and to stay below a megabyte. What the cursor reads is compared with the
// CSV file, and the command of a cell is run.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import assert from "node:assert/strict";

import { Browser } from "./chromium.mjs";

const [program, chromium = "chromium"] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "lyapunov-pages-"));
const MEGABYTE = 1e6;
const SHIFT = 8;

const lyapunov = (...args) => execFileSync(program, args, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });

/** Runs a command with `--out` and returns the path of its file `name`. */
function made(name, ...args) {
  const out = join(folder, name);
  lyapunov(...args, "--quiet", "--out", out);
  return (file) => join(out, file);
}

/** The rows of a CSV file, by the names of their columns. */
function rows(path) {
  const lines = readFileSync(path, "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
  const [head, ...others] = lines.map((line) => line.split(","));
  return others.map((fields) => Object.fromEntries(head.map((name, index) => [name, fields[index]])));
}

const near = (found, expected, share, what) =>
  assert.ok(Math.abs(found - expected) <= share * Math.abs(expected), `${what}: ${found} instead of ${expected}`);

/** Every look of a page: nothing fails, nothing is asked for, nothing sticks out. */
async function looks(browser, path) {
  const size = readFileSync(path).length;
  assert.ok(size < MEGABYTE, `${path}: ${size} bytes`);
  for (const width of [1200, 400]) {
    for (const scheme of ["light", "dark"]) {
      const page = await browser.open(`file://${path}`, { width, scheme });
      await ready(page);
      const [wide, shown] = await page.value("[document.documentElement.scrollWidth, document.documentElement.clientWidth]");
      assert.ok(wide <= shown, `${path}: ${wide} pixels wide on ${shown}`);
      assert.deepEqual(page.faults(), [], path);
      await page.send("Emulation.setEmulatedMedia", { media: "print" });
      const drawings = await page.value("[...document.querySelectorAll('figure svg')].map((it) => it.getBoundingClientRect().height)");
      assert.ok(drawings.every((height) => height > 50), `${path}: a drawing is not printed`);
      assert.equal(await page.value("[...document.querySelectorAll('.plots, .told')].every((it) => it.getBoundingClientRect().height === 0)"), true);
      await page.close();
    }
  }
}

const ready = (page) =>
  page.until("[...document.querySelectorAll('figure')].every((it) => it.matches('.live') || it.querySelector('.told'))");

const at = async (page) => Number((await page.value("document.querySelector('.at').textContent")).split(" ").pop());
const valueOf = (page, label) =>
  page.value(`[...document.querySelectorAll('.curve')].find((it) => it.textContent.startsWith(${JSON.stringify(label)})).querySelector('.value').textContent`);

/** Cursor, keys and zoom of the first plot, against the `known` points of the curve `label`, to a `share`. */
async function curves(browser, path, label, known, share) {
  const page = await browser.open(`file://${path}`);
  await ready(page);
  const check = async (where) => {
    const [t, v] = [await at(page), Number(await valueOf(page, label))];
    const row = known.reduce((best, one) => (Math.abs(one.t - t) < Math.abs(best.t - t) ? one : best));
    near(t, row.t, 1e-8, `${where}: time`);
    near(v, row.v, share, `${where}: value at ${t}`);
    return t;
  };
  const over = await page.place(".u-over");
  const end = known[known.length - 1].t;
  for (const part of [0.2, 0.5, 0.9]) {
    await page.mouse("mouseMoved", over.left + part * over.width, over.y);
    near(await check(`pointer at ${part}`), part * end, 0.02, "place of the pointer");
  }

  await page.value("document.querySelector('.plot').focus()");
  const before = await at(page);
  await page.key("ArrowRight");
  const step = known[1].t - known[0].t;
  near((await check("one to the right")) - before, step, 1e-6, "a step of the cursor");
  await page.key("ArrowLeft", SHIFT);
  near((await check("twenty to the left")) - before, -19 * step, 1e-6, "twenty steps");

  const left = async () => {
    const { left: edge, y } = await page.place(".u-over");
    await page.mouse("mouseMoved", edge + 1, y);
    return check("left edge");
  };
  for (let times = 0; times < 3; times += 1) await page.key("+");
  assert.ok((await left()) > 0.5 * end, "+ does not zoom");
  await page.key("0");
  assert.ok((await left()) < 0.01 * end, "0 does not show all");
  await page.mouse("mouseMoved", over.left + 0.5 * over.width, over.y);
  await page.mouse("mousePressed", over.left + 0.5 * over.width, over.y, { button: "left", buttons: 1, clickCount: 1 });
  await page.mouse("mouseMoved", over.left + 0.75 * over.width, over.y, { button: "left", buttons: 1 });
  await page.mouse("mouseReleased", over.left + 0.75 * over.width, over.y, { button: "left", clickCount: 1 });
  near(await left(), 0.5 * end, 0.01, "drag from the middle");

  const button = await page.place(".curve");
  await page.click(button.x, button.y);
  assert.equal(await page.value("document.querySelector('.curve').getAttribute('aria-pressed')"), "false");
  assert.deepEqual(page.faults(), []);
  await page.close();
}

/** The last column of the first table upwards and downwards, by keyboard, then as it came. */
async function sorting(browser, path) {
  const page = await browser.open(`file://${path}`);
  await ready(page);
  const column = () => page.value("[...document.querySelector('table').tBodies[0].rows].map((it) => it.cells[it.cells.length - 1].textContent)");
  const order = () => page.value("document.querySelector('th:last-child').getAttribute('aria-sort')");
  const came = await column();
  const number = (text) => (text === "-" ? Infinity : Number(text));
  const upwards = [...came].sort((one, other) => number(one) - number(other));
  await page.value("document.querySelector('th:last-child button').focus()");
  await page.key("Enter");
  assert.deepEqual(await column(), upwards);
  assert.equal(await order(), "ascending");
  await page.key("Enter");
  assert.deepEqual((await column()).filter((it) => it !== "-"), upwards.filter((it) => it !== "-").reverse());
  assert.equal(await order(), "descending");
  await page.key("Enter");
  assert.deepEqual(await column(), came);
  assert.equal(await order(), null);
  assert.deepEqual(page.faults(), []);
  await page.close();
}

async function cells(browser, path, csv, [columns, lines]) {
  const page = await browser.open(`file://${path}`);
  await ready(page);
  const known = rows(csv);
  const names = Object.keys(known[0]);
  const told = () =>
    page.value("({ who: document.querySelector('.where').textContent, numbers: Object.fromEntries([...document.querySelectorAll('.told dl')[0].children].map((it) => [it.children[0].textContent, it.children[1].textContent])), command: document.querySelector('.command code').textContent })");
  const check = async (column, line) => {
    const { who, numbers, command } = await told();
    const row = known.find((it, index) => it.stabilizer === who && Math.floor(index / (known.length / (columns * lines))) === line * columns + column);
    const [x, y] = Object.values(numbers);
    assert.deepEqual([Number(x), Number(y)], [Number(row[names[0]]), Number(row[names[1]])]);
    assert.equal(numbers["verdicts on the runs"], row.verdict);
    const force = numbers["peak force, N"];
    if (row.peak_force_n === "") assert.equal(force, "-");
    else near(Number(force), Number(row.peak_force_n), 1e-3, "peak force");
    const [first, ...words] = command.split(" ");
    assert.equal(first, "lyapunov");
    const area = JSON.parse(lyapunov(...words, "--json")).areas.find((it) => it.stabilizer === who);
    assert.equal(area[`${row.verdict.replace(" ", "_")}_cells`], 1, command);
  };
  const image = await page.place("image.cells");
  const point = (column, line) => page.mouse("mouseMoved", image.left + ((column + 0.5) / columns) * image.width, image.top + image.height * (1 - (line + 0.5) / lines));
  for (const [column, line] of [[0, 0], [columns - 1, lines - 1], [1, 2]]) {
    await point(column, line);
    await check(column, line);
  }
  await page.value("document.querySelector('image.cells').focus()");
  await page.key("ArrowRight");
  await page.key("ArrowUp");
  await check(2, 3);
  assert.deepEqual(page.faults(), []);
  await page.close();
}

/** The names of a plot have the dash of their curves: of `run --against` the log is dashed, and the run is not. */
async function dashes(browser, path) {
  const page = await browser.open(`file://${path}`);
  await ready(page);
  const shown = (label) =>
    page.value(`[...document.querySelectorAll('#against .curve')].find((it) => it.textContent.startsWith("${label}")).querySelector('.swatch').style.background`);
  assert.match(await shown("log"), /^repeating-linear-gradient.* 0px, .* 6px, .* 6px, .* 9px\)$/);
  assert.doesNotMatch(await shown("run"), /gradient/);
  assert.deepEqual(page.faults(), []);
  await page.close();
}

const browser = new Browser(chromium);
try {
  const model = made("model", "compare", "scenes/models/van-der-pol.toml");
  const size = [6, 5];
  const map = made("map", "map", "scenes/press-1khz.toml", "--x", `environment.wall.stiffness=100..50000:${size[0]}:log`, "--y", `environment.wall.damping=0..100:${size[1]}`);
  // A number of a stabilizer that is not the one of the first panel.
  const capped = made("capped", "map", "scenes/press-1khz.toml", "--x", "environment.wall.stiffness=100..50000:4:log", "--y", "stabilizer.popc.damping_cap=0.1..1:4", "--stabilizers", "none,popc");
  const paper = made("paper", "paper", "--draws", "2");
  const teleoperation = made("teleoperation", "compare", "scenes/teleoperation/constant-delay.toml");
  const run = made("run", "run", "scenes/paper-50k-popc.toml");
  const bound = made("bound", "bound", "scenes/press-1khz.toml");
  const explain = made("explain", "explain", "scenes/paper-50k-popc.toml");
  const sweep = made("sweep", "map", "scenes/press-1khz.toml", "--x", "environment.wall.stiffness=100..50000:5:log");
  const log = "scenes/logs/mujoco-wall.csv";
  const against = made("against", "run", "scenes/paper-8k-none.toml", "--against", log);
  const observe = made("observe", "observe", log, "--stabilizers", "all", "--scene", "scenes/paper-8k-none.toml");
  const pages = [model, map, paper, teleoperation, run, bound, explain, sweep, against, observe];
  for (const made of pages) await looks(browser, made("report.html"));
  const values = rows(model("van-der-pol.csv")).filter((row) => row.stabilizer === "lolc-decay");
  const shares = values.map(({ t, v }) => ({ t: Number(t), v: Number(v) / Number(values[0].v) }));
  await curves(browser, model("report.html"), "lolc-decay", shares, 1e-3);
  const rowsOfRun = join(folder, "run.csv");
  lyapunov("run", "scenes/paper-50k-popc.toml", "--quiet", "--csv", rowsOfRun);
  const positions = rows(rowsOfRun).map(({ t, x }) => ({ t: Number(t), v: 1e3 * Number(x) }));
  await curves(browser, run("report.html"), "position, mm", positions, 1e-5);
  await dashes(browser, against("report.html"));
  await sorting(browser, model("report.html"));
  await cells(browser, map("report.html"), map("map.csv"), size);
  await cells(browser, capped("report.html"), capped("map.csv"), [4, 4]);
  console.log("the pages load, tell the right numbers and sort");
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
