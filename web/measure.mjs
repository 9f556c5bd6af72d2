// Measures the page in a headless Chromium: `node web/measure.mjs PAGE CHROMIUM`.
//
// Times are processor time of the thread that does the work, as Linux counts it, so that a busy machine changes them little.

import { readFileSync, readdirSync } from "node:fs";
import { resolve } from "node:path";

import { Browser } from "../scripts/chromium.mjs";

const [file, chromium] = process.argv.slice(2);
const MAPS = 3;
const SECONDS = 4;
const RATE = 1000;

/** `read()`, or nothing where the process or thread has ended. */
function still(read) {
  try {
    return read();
  } catch {
    return undefined;
  }
}

const parentOf = (pid) => Number(readFileSync(`/proc/${pid}/stat`, "utf8").replace(/^.*\) \S /s, "").split(" ")[0]);

/** The processes that `pid` started, and those that they started. */
function family(pid) {
  const all = readdirSync("/proc").filter((it) => /^\d+$/.test(it)).map(Number);
  const parents = new Map(all.map((it) => [it, still(() => parentOf(it))]));
  const within = (it) => it === pid || (parents.get(it) !== undefined && within(parents.get(it)));
  return all.filter(within);
}

/** Processor time of the browser's threads that `chosen` is true of, by process, thread and name, ms. */
function spent(browser, chosen) {
  let all = 0;
  for (const pid of family(browser.child.pid)) {
    for (const task of (still(() => readdirSync(`/proc/${pid}/task`)) ?? []).map(Number)) {
      const place = `/proc/${pid}/task/${task}`;
      const name = still(() => readFileSync(`${place}/comm`, "utf8").trim());
      if (name !== undefined && chosen(pid, task, name)) all += still(() => Number(readFileSync(`${place}/schedstat`, "utf8").split(" ")[0]) / 1e6) ?? 0;
    }
  }
  return all;
}

const WORKER = (pid, task, name) => name.startsWith("DedicatedWorker");
// The first thread of a process keeps the name of the program.
const MAIN = (pid, task) => task === pid && readFileSync(`/proc/${pid}/cmdline`, "utf8").includes("--type=renderer");
const browser = new Browser(chromium);
try {
  const page = await browser.open(`file://${resolve(file)}`, { width: 1280, height: 900 });
  await page.until("document.documentElement.dataset.ready === 'yes'", 60);
  const said = "document.querySelector('#map-said').textContent";
  const idle = "document.querySelectorAll('#members tbody tr').length > 10 && document.querySelector('.remedy')";
  await page.until(`${said}.includes('runs in') && ${idle}`, 120);
  const rate = await page.value("lyapunov.state.tree.servo_rate");
  const { duration } = await page.value("lyapunov.state.tree");
  if (rate !== RATE || duration !== 2) throw new Error(`the first scene runs at ${rate} Hz for ${duration} s`);

  // The worker does nothing but a map while one chooses another stabilizer for it.
  for (const name of await page.value("[...document.querySelector('#map-under').options].map((it) => it.value)")) {
    const times = [];
    for (let round = 0; round < MAPS; round += 1) {
      const before = spent(browser, WORKER);
      await page.value(`(() => { const it = document.querySelector('#map-under'); it.value = ${JSON.stringify(name)}; it.dispatchEvent(new Event('change')); })()`);
      await page.until(`${said}.includes('runs in')`, 120);
      times.push(spent(browser, WORKER) - before);
    }
    console.log(`map under ${name}: ${Math.min(...times).toFixed(0)} ms of processor time, the least of ${MAPS} (${times.map((it) => it.toFixed(0)).join(", ")})`);
  }

  const before = spent(browser, MAIN);
  const frames = await page.value(`new Promise((done) => { let n = 0; const began = performance.now(); const one = (now) => { n += 1; if (now - began > ${1e3 * SECONDS}) done(n); else requestAnimationFrame(one); }; requestAnimationFrame(one); })`);
  const each = (spent(browser, MAIN) - before) / frames;
  console.log(`${(frames / SECONDS).toFixed(0)} frames a second; ${each.toFixed(2)} ms of processor time in each, of the 16.7 ms that 60 a second leave`);
  const faults = page.faults();
  if (faults.length) throw new Error(faults.join("\n"));
} finally {
  await browser.close();
}
