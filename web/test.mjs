// Looks at the page in a headless Chromium: `node web/test.mjs PAGE LYAPUNOV CHROMIUM TOOLS [CHECK…]`, from anywhere.
//
// The page has to compute what the command LYAPUNOV computes, bit for bit, and to be usable: without a mouse, on a narrow
// screen, in light and dark, without a request, an error or a serious finding of axe-core.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { Browser } from "../scripts/chromium.mjs";
import { range } from "./page/curves.js";
import { thinned } from "./page/loops.js";
import { address } from "./page/scene.js";

const [file, program, chromium, tools, ...only] = process.argv.slice(2);
const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const url = `file://${file}`;
const SHIFT = 8;
const folder = mkdtempSync(join(tmpdir(), "lyapunov-web-"));
const axe = readFileSync(join(tools, "node_modules/axe-core/axe.min.js"), "utf8");
const lyapunov = (...words) => execFileSync(program, words, { encoding: "utf8", cwd: root, maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "inherit"] });

const opened = async (browser, about = {}, hash = "") => {
  const page = await browser.open(url + hash, about);
  await page.until("document.documentElement.dataset.ready === 'yes'");
  return page;
};
/** The words on the three loops. */
const verdicts = (page) => page.value("[...document.querySelectorAll('#verdicts .word')].map((it) => it.textContent)");
const mapped = (page) => page.until("document.querySelector('#map-said').textContent.includes('runs in')", 60);
const closed = async (page) => {
  assert.deepEqual(page.faults(), []);
  await page.close();
};
/** Moves a slider as a person does: to a place from 0 to 1. */
const slide = (page, key, place) =>
  page.value(`(() => { const it = document.querySelector('input[name="${key}"]'); it.value = ${place} * it.max; it.dispatchEvent(new Event("input")); })()`);

/** Motions that scenes name. */
const MOTIONS = ["motion-file.csv"];

/** Every shipped scene: the rows of the page's own engine are those of the command, byte for byte. */
async function rows(browser) {
  const page = await opened(browser);
  const scenes = readdirSync(join(root, "scenes")).filter((name) => name.endsWith(".toml"));
  const text = (name) => readFileSync(join(root, "scenes", name), "utf8");
  for (const name of MOTIONS) await page.value(`lyapunov.engine.text("keep", ${JSON.stringify(`${name}\n${text(name)}`)})`);
  let compared = 0;
  for (const name of scenes) {
    const path = join(root, "scenes", name);
    const here = await page.value(`(() => { try { return lyapunov.engine.text("rows", ${JSON.stringify(text(name))}); } catch (error) { return error.message; } })()`);
    const there = lyapunov("run", path, "--csv", "-", "--quiet");
    assert.ok(here === there, `scenes/${name}: the rows differ`);
    compared += 1;
  }
  assert.ok(compared > 30, `${compared} scenes`);
  console.log(`rows of ${compared} shipped scenes are those of the command, byte for byte`);
  await closed(page);
}

/** The verdicts of loops by their names, as the command tells them of a scene. */
const told = (path, names) => JSON.parse(lyapunov("compare", path, "--stabilizers", names.join(","), "--json")).rows.map((it) => it.verdict);
const cards = (page) => page.value("[...document.querySelectorAll('#verdicts .card')].map((it) => it.dataset.name)");
/** Chooses the candidate of LOLC. */
const credit = (page, name) => page.value(`(() => { const it = document.querySelector("#candidate"); it.value = "${name}"; it.dispatchEvent(new Event("change")); })()`);
/** Drops files, each a name and a text. */
const drop = (page, files) =>
  page.value(`(() => { const data = new DataTransfer();
    for (const [name, text] of ${JSON.stringify(files)}) data.items.add(new File([text], name));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })); })()`);
/** The text of the file that a button saves. */
const saved = (page, button) =>
  page.value(`(async () => { const was = URL.createObjectURL; let blob = null;
    URL.createObjectURL = (it) => { blob = it; return was.call(URL, it); };
    document.querySelector("${button}").click(); URL.createObjectURL = was; return blob.text(); })()`);

/** Every shipped scene opens where it is dropped, with the command's words; only on a line a hand holds it. */
async function dropped(browser) {
  const page = await opened(browser);
  const folderOf = join(root, "scenes");
  for (const name of readdirSync(folderOf).filter((it) => it.endsWith(".toml"))) {
    const text = readFileSync(join(folderOf, name), "utf8");
    const files = MOTIONS.filter((it) => text.includes(it)).map((it) => [it, readFileSync(join(folderOf, it), "utf8")]);
    await drop(page, [...files, [name, text]]);
    await page.until(`document.querySelector('#done').textContent === ${JSON.stringify(`${name} is open.`)}`, 20);
    const names = await cards(page);
    const candidate = text.match(/candidate = "(.*)"/)?.[1];
    if (candidate) assert.equal(names[2], `lolc-${candidate}`, name);
    assert.deepEqual(await verdicts(page), told(join("scenes", name), names), name);
    assert.ok(!(await page.value("document.querySelector('#verdicts').textContent.includes('NaN')")), name);
    const isHeld = await page.value("!document.querySelector('#show-live').disabled");
    assert.equal(isHeld, !/^\[space\]/m.test(text), name);
    // Under a hand that stands before the wall, wherever that is.
    if (isHeld) assert.ok(await page.value("lyapunov.loops.letGo(), lyapunov.loops.forward(0.05), lyapunov.loops.lanes.every((it) => !(it.gone > 0))"), name);
  }
  await closed(page);
}

/** Maps under each basic stabilizer: every verdict is the command's. */
async function maps(browser) {
  const page = await opened(browser);
  const axes = ["environment.wall.stiffness=100..200000:24:log", "environment.wall.damping=0..100:16"];
  const text = readFileSync(join(root, "scenes/paper-8k-none.toml"), "utf8").replace("servo_rate = 100.0", "servo_rate = 1000.0").replace("duration = 10.0", "duration = 2.0");
  const scene = join(folder, "map.toml");
  writeFileSync(scene, text);
  const names = ["none", "popc", "lolc-spring", "lolc-device-damping", "lolc-mass-spring-damper"];
  const out = join(folder, "map");
  lyapunov("map", scene, "--x", axes[0], "--y", axes[1], "--stabilizers", names.join(","), "--out", out, "--quiet");
  const lines = readFileSync(join(out, "map.csv"), "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
  const head = lines[0].split(",");
  const [who, word] = ["stabilizer", "verdict"].map((name) => head.indexOf(name));
  for (const name of names) {
    const there = lines.slice(1).map((line) => line.split(",")).filter((it) => it[who] === name).map((it) => it[word]);
    assert.equal(there.length, 24 * 16);
    const asked = JSON.stringify(`${axes[0]}\n${axes[1]}\n${name}\n${text}`);
    const here = await page.value(`(() => { const { engine } = lyapunov; const words = engine.lines("verdicts"); engine.bytes("chart", ${asked});
      return [...engine.bytes("band", "", 0, ${24 * 16})].map((it) => words[it]); })()`);
    assert.deepEqual(here, there, `the map under ${name}`);
    if (name === "none") assert.equal(new Set(there).size, 3, "a map with one word shows nothing");
  }
  await closed(page);
}

/** The map moves the sliders where there is one, and not where it is pale. */
async function steps(browser) {
  const page = await opened(browser);
  await mapped(page);
  const scene = () => page.value("lyapunov.scene()");
  const touch = async () => {
    const at = await page.place("#map");
    await page.click(at.x, at.y);
    await page.value("document.querySelector('#map').focus()");
    await page.key("ArrowLeft");
    return scene();
  };
  const before = await scene();
  const moved = await touch();
  assert.notEqual(moved, before);
  const same = "document.querySelector('#map-y')";
  await page.value(`${same}.value = document.querySelector('#map-x').value; ${same}.dispatchEvent(new Event("change"))`);
  assert.equal(await touch(), moved, "both axes are the same");
  await page.value(`${same}.value = "environment.wall.damping"; ${same}.dispatchEvent(new Event("change"))`);
  await mapped(page);
  await slide(page, "effects.delay.ticks", 0.2);
  await page.until("document.querySelector('#map-said').textContent.includes('without further effects')");
  const late = await scene();
  assert.equal(await touch(), late, "there is no map of a late force");
  await closed(page);
}

/** Sliders change the words, and the words are those of `compare` on the same scene. */
async function words(browser) {
  const page = await opened(browser);
  const seen = new Set();
  for (const [key, place] of [["environment.wall.stiffness", 0.2], ["environment.wall.stiffness", 0.95], ["servo_rate", 0.3], ["effects.delay.ticks", 0.2], ["effects.encoder.resolution", 0.7], ["device.mass", 0.9]]) {
    await slide(page, key, place);
    const shown = await verdicts(page);
    const [scene, path] = [await page.value("lyapunov.scene()"), join(folder, "scene.toml")];
    writeFileSync(path, scene);
    assert.deepEqual(shown, told(path, await cards(page)), `${key} at ${place}\n${scene}`);
    shown.forEach((word) => seen.add(word));
  }
  assert.ok(seen.has("grows") && seen.has("settles"), [...seen].join());
  await closed(page);
}

/** The family's table holds the rows of the last setting only, however soon the sliders moved. */
async function family(browser) {
  const page = await opened(browser);
  const rows = "[...document.querySelectorAll('#members tbody tr')].map((it) => it.textContent)";
  for (let moves = 0; moves < 6; moves += 1) {
    await slide(page, "environment.wall.stiffness", 0.3 + 0.1 * moves);
    // Just after the worker was asked, when it is in the middle of the first rows.
    await new Promise((done) => setTimeout(done, 125 + 4 * moves));
  }
  await slide(page, "device.mass", 0.6);
  const names = await page.value("lyapunov.engine.lines('names', lyapunov.scene())");
  await page.until(`${rows}.length >= ${names.length}`, 60);
  await new Promise((done) => setTimeout(done, 500));
  assert.deepEqual((await page.value("[...document.querySelectorAll('#members tbody th')].map((it) => it.textContent)")), names);
  await closed(page);
}

/** The explanation that the page shows is the one of `explain`; a remedy's button does what it says. */
async function reasons(browser) {
  const page = await opened(browser);
  await page.until("document.querySelectorAll('#energies tbody tr').length > 3 && document.querySelector('.remedy')");
  const path = join(folder, "why.toml");
  writeFileSync(path, await page.value("lyapunov.scene()"));
  const text = lyapunov("explain", path);
  const shown = await page.value("[...document.querySelectorAll('#energies tbody tr')].map((it) => [...it.cells].map((cell) => cell.textContent))");
  const mJ = (line) => line.trim().split(/\s{2,}/).slice(-2).map(Number);
  for (const [name, ...energies] of shown) {
    const words = name.replace(/^\w+ /, "");
    const line = text.split("\n").find((it) => it.includes(words));
    assert.ok(line, `${name} is not in\n${text}`);
    mJ(line).forEach((known, index) => {
      const here = Number(energies[index].replaceAll("−", "-"));
      assert.ok(Math.abs(here - known) <= 6e-3 * Math.abs(known) || Math.abs(here) < 1e-6, `${name}: ${here} instead of ${known}`);
    });
  }
  const remedies = JSON.parse(lyapunov("explain", path, "--json")).remedies;
  const sets = await page.value("[...document.querySelectorAll('.remedy b')].map((it) => it.textContent)");
  assert.deepEqual(sets, remedies.map(({ set }) => Object.entries(set).map(([key, it]) => `${key} = ${it}`).join(", ")));
  await page.value("document.querySelector('.remedy').focus()");
  await page.key("Enter");
  assert.equal((await verdicts(page))[0], remedies[0].verdict);
  await page.until("document.querySelector('#why-said').textContent.length > 1");
  assert.equal(await page.value("document.activeElement.id"), "why-said");
  await closed(page);
}

/** A cap that a remedy writes stands in the scene: the page says so for as long as it does, and takes it back. */
async function caps(browser) {
  const page = await opened(browser);
  const cap = "stabilizer.popc.damping_cap = 0.5";
  const said = () => page.value("document.querySelector('#said').textContent");
  const press = () => page.value(`[...document.querySelectorAll('.remedy')].find((it) => it.textContent.startsWith("${cap}")).click()`);
  const back = () => page.value("document.querySelector('#said button').click()");
  const before = await page.value("lyapunov.scene()");
  await page.until("document.querySelector('.remedy')");
  const first = "a damping_cap here is the first that holds, not the best";
  const path = join(folder, "cap.toml");
  writeFileSync(path, before);
  assert.ok(lyapunov("explain", path).includes(first));
  assert.ok((await page.value("document.querySelector('#remedies').textContent.toLowerCase()")).includes(first));
  await press();
  assert.ok((await said()).includes(`${cap}.`) && /stays when the delay moves/.test(await said()), await said());
  await back();
  assert.equal(await page.value("lyapunov.scene()"), before);
  assert.equal(await said(), "");
  await page.until("document.querySelector('.remedy')");
  await press();
  await slide(page, "effects.delay.ticks", 0.15);
  assert.equal((await verdicts(page))[1], "grows");
  assert.ok(/damping_cap = 0.5, which stays/.test(await said()), await said());
  await back();
  assert.equal((await verdicts(page))[1], "swinging");
  await closed(page);
}

/** The hand by mouse and by keys, and the loops under it. */
async function hand(browser) {
  const page = await opened(browser);
  const at = () => page.value("Number(document.querySelector('#wall').getAttribute('aria-valuenow'))");
  // By itself at first.
  await page.until("document.querySelector('#wall').getAttribute('aria-valuetext').endsWith('into the wall')");
  const wall = await page.place("#wall");
  await page.mouse("mouseMoved", wall.x, wall.y);
  await page.mouse("mousePressed", wall.x, wall.y, { button: "left", buttons: 1, clickCount: 1 });
  const before = await at();
  await page.mouse("mouseMoved", wall.x + 100, wall.y, { button: "left", buttons: 1 });
  await page.mouse("mouseReleased", wall.x + 100, wall.y, { button: "left", clickCount: 1 });
  const pressed = await at();
  assert.ok(Math.abs(pressed - (before + (100 / wall.width) * 50)) < 0.2, `${pressed} mm, from ${before} mm`);
  await page.value("document.querySelector('#wall').focus()");
  await page.key("ArrowLeft");
  assert.ok(Math.abs((await at()) - pressed + 0.5) < 0.11, `${await at()} mm`);
  await page.value("document.querySelector('#wall').focus()");
  for (let times = 0; times < 10; times += 1) await page.key("ArrowRight", SHIFT);
  await page.until("lyapunov.loops.seen(0).peak !== 0", 20);
  await closed(page);
}

/** Frames a second with three loops at 1 kHz, as the browser counts them: told and not judged, since a busy machine draws few. */
async function frames(browser) {
  const page = await opened(browser);
  const many = await page.value("new Promise((done) => { let n = 0; const began = performance.now(); const one = (now) => { n += 1; if (now - began > 2000) done(n / ((now - began) / 1e3)); else requestAnimationFrame(one); }; requestAnimationFrame(one); })");
  const cost = await page.value("lyapunov.cost()");
  console.log(`${many.toFixed(0)} frames a second here, ${cost.toFixed(2)} ms of work in each`);
  await closed(page);
}

/** A scene goes into the address, a file and back. */
async function shared(browser) {
  const page = await opened(browser);
  await slide(page, "environment.wall.stiffness", 0.4);
  await slide(page, "effects.delay.ticks", 0.25);
  const scene = await page.value("lyapunov.scene()");
  await page.until("location.hash.includes('delay')");
  const other = await opened(browser, {}, await page.value("location.hash"));
  assert.equal(await other.value("lyapunov.scene()"), scene);
  await drop(other, [["friction.toml", readFileSync(join(root, "scenes/friction.toml"), "utf8")]]);
  await other.until("document.querySelector('#done').textContent.includes('friction.toml')");
  const dropped = join(folder, "dropped.toml");
  writeFileSync(dropped, await other.value("lyapunov.scene()"));
  assert.equal(lyapunov("run", dropped, "--csv", "-", "--quiet"), lyapunov("run", join(root, "scenes/friction.toml"), "--csv", "-", "--quiet"));
  const log = "scenes/logs/mujoco-wall.csv";
  await drop(other, [[log, readFileSync(join(root, log), "utf8")]]);
  await other.until("document.querySelector('#done').textContent.includes('is a log')");
  assert.equal((await other.value("document.querySelector('#code').textContent")).trim(), lyapunov("observe", log).trim());
  await drop(other, [["broken.toml", "duration = 1\nservo_rate = -1"]]);
  await other.until("document.querySelector('#done').textContent.includes('broken.toml:2:')");
  assert.ok(await other.value("document.querySelector('#code').hidden"), "what the observer said of another file stands below");
  await other.value("document.querySelector('#copy-address').click(); 0");
  await other.until("document.querySelector('#done').textContent !== ''");
  await slide(other, "device.mass", 0.4);
  assert.equal(await other.value("document.querySelector('#done').textContent"), "");
  await drop(other, ["motion-file.toml", "motion-file.csv"].map((name) => [name, readFileSync(join(root, "scenes", name), "utf8")]));
  await other.until("document.querySelector('#done').textContent.includes('motion-file.toml is open')");
  await other.until("document.querySelectorAll('#members tbody tr').length > 5 && !document.querySelector('#fault').textContent", 60);
  await drop(other, [["bad.toml", "duration = 1\nservo_rate = -1"]]);
  await other.until("document.querySelector('#done').textContent.includes('bad.toml:2:')");
  await closed(other);
  await closed(page);
}

/** What is taken along is the loop that is shown: files, an address under any choice, a scene's own stabilizer. */
async function taken(browser) {
  const page = await opened(browser);
  await credit(page, "lolc-spring");
  await page.value("document.querySelector('#why-of button[data-index=\"2\"]').click()");
  const path = join(folder, "taken.toml");
  writeFileSync(path, await saved(page, "#download"));
  assert.ok(/candidate = "spring"/.test(readFileSync(path, "utf8")));
  assert.equal(await saved(page, "#download-rows"), lyapunov("run", path, "--csv", "-", "--quiet"));
  await page.until("location.hash.includes('lolc-spring')");
  const [hash, shown] = [await page.value("location.hash"), await verdicts(page)];
  await credit(page, "lolc-mass-spring-damper");
  assert.notDeepEqual(await verdicts(page), shown);
  await page.until("location.hash.includes('lolc-mass-spring-damper')");
  // An address that is pasted into the same tab.
  await page.value(`location.hash = ${JSON.stringify(hash)}; 0`);
  await page.until("document.querySelector('#candidate').value === 'lolc-spring'");
  assert.deepEqual(await verdicts(page), shown);
  // The cap of one stabilizer is that of the other, too.
  const own = { 0.1: "0.1", inf: "f64::INFINITY" };
  for (const [cap, said] of Object.entries(own)) {
    const text = `${readFileSync(join(root, "scenes/paper-8k-none.toml"), "utf8")}\n[stabilizer.lolc]\ncandidate = "device-damping"\ndamping_cap = ${cap}\n`;
    writeFileSync(path, text);
    await drop(page, [["own.toml", text]]);
    await page.until("document.querySelector('#done').textContent === 'own.toml is open.'");
    assert.equal((await verdicts(page))[2], JSON.parse(lyapunov("run", path, "--json")).verdict);
    await page.value("document.querySelector('#lines button').click()");
    assert.ok((await page.value("document.querySelector('#code').textContent")).includes(`of_mass(${said},`), cap);
    await page.value("document.querySelector('#why-of button[data-index=\"1\"]').click(); document.querySelector('#lines button').click()");
    assert.ok((await page.value("document.querySelector('#code').textContent")).includes(`of_mass(${said},`), `popc ${cap}`);
    await page.value("document.querySelector('#why-of button[data-index=\"2\"]').click()");
    const rows = lyapunov("run", path, "--csv", "-", "--quiet");
    writeFileSync(path, await saved(page, "#download"));
    assert.equal(lyapunov("run", path, "--csv", "-", "--quiet"), rows, cap);
  }
  const bare = join(root, "scenes/paper-8k-none.toml");
  const sampled = `${readFileSync(bare, "utf8")}\n[stabilizer.popc]\nwork = "sampled"\n`;
  await drop(page, [["sampled.toml", sampled]]);
  await page.until("document.querySelector('#done').textContent === 'sampled.toml is open.'");
  assert.ok(await page.value("[...document.querySelectorAll('#lines button')].every((it) => it.disabled)"));
  await drop(page, [["bare.toml", readFileSync(bare, "utf8")]]);
  await page.until("document.querySelector('#done').textContent === 'bare.toml is open.'");
  assert.equal(await saved(page, "#download-rows"), lyapunov("run", bare, "--csv", "-", "--quiet"));
  await closed(page);
}

/** The range of the curves holds all of every bounded loop, whatever the others do. */
async function ranges() {
  const columns = { value: 0, width: 1 };
  const bounded = { rows: [-37, 2], columns, tame: true };
  for (const grown of [[0, 1e9], [-1e9, 0], [-1e9, 1e9], [0, 0]]) {
    const [low, high] = range([bounded, { rows: grown, columns, tame: false }], "value", 1, 0.05);
    assert.ok(low < -37 && high > 2 && high - low < 110, `${low} to ${high} beside ${grown}`);
  }
}

/** Rows of a fast loop are thinned, and no peak is lost: the least and the largest of each column are those of all rows. */
async function thin() {
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

/** An address or a file that the page cannot run leaves what it shows, and lines are offered only where they say what runs. */
async function refused(browser) {
  const page = await opened(browser, {}, "#scalar=%22f32%22&duration=1");
  const text = (at) => page.value(`document.querySelector("${at}").textContent`);
  assert.notEqual(await text("#said"), "The scene of this address.");
  assert.equal(await page.value("lyapunov.state.tree.scalar"), undefined);
  await slide(page, "device.mass", 0.5);
  assert.equal(await text("#fault"), "");
  await page.close();
  const cut = await opened(browser, {}, "#duration=%2");
  assert.ok((await cut.value("document.querySelector('#fault').textContent")).includes("cut"));
  assert.equal((await verdicts(cut)).length, 3);
  await cut.until("location.hash.includes('servo_rate')");
  await cut.value("location.hash = '#duration=%2'; 0");
  await cut.until("location.hash.includes('servo_rate') && document.querySelector('#fault').textContent.includes('cut')");
  const exact = `velocity = "exact"\n${readFileSync(join(root, "scenes/paper-8k-none.toml"), "utf8")}`;
  const scenes = ["sphere", "hold", "press-1khz", "filter-cutoff"].map((name) => [`${name}.toml`, readFileSync(join(root, `scenes/${name}.toml`), "utf8"), true]);
  for (const [name, text, isOff] of [["plain.toml", exact.replace(/.*\n/, ""), false], ["exact.toml", exact, true], ["grip.toml", readFileSync(join(root, "scenes/grip.toml"), "utf8"), false], ...scenes]) {
    await drop(cut, [[name, text]]);
    await cut.until(`document.querySelector('#done').textContent.includes('${name} is open')`);
    const off = await cut.value("[...document.querySelectorAll('#lines button')].map((it) => it.disabled && it.title !== '')");
    assert.deepEqual(off, [isOff, isOff, isOff], name);
  }
  await cut.close();
  const stays = await opened(browser);
  await drop(stays, [["link.toml", readFileSync(join(root, "scenes/link.toml"), "utf8")]]);
  await stays.until("document.querySelector('#done').textContent === 'link.toml is open.'");
  const at = () => stays.value("document.querySelector('input[name=\"operator.mass\"]').value");
  const [place, scene] = [await at(), await stays.value("lyapunov.scene()")];
  await slide(stays, "operator.mass", 0);
  assert.notEqual(await stays.value("document.querySelector('#fault').textContent"), "");
  assert.deepEqual([await at(), await stays.value("lyapunov.scene()")], [place, scene]);
  await closed(stays);
}

/** The presets of the paper: the verdicts and the numbers that the page says, also where another candidate was chosen before. */
async function paper(browser) {
  const page = await opened(browser);
  const figures = [["figure-6", "paper-8k", 0], ["figure-7", "paper-8k", 2], ["figure-8", "paper-50k", 1], ["figure-9", "paper-50k", 2]];
  for (const [id, stem, explained] of figures) {
    await credit(page, "lolc-spring");
    await page.value(`document.querySelector("#${id}").click()`);
    const shown = await verdicts(page);
    const known = ["none", "popc", "lolc"].map((name) => JSON.parse(lyapunov("run", `scenes/${stem}-${name}.toml`, "--json")).verdict);
    assert.deepEqual(shown, known, id);
    assert.equal((await cards(page))[2], "lolc-mass-spring-damper", id);
    assert.equal(await page.value("document.querySelector('#why-of [aria-pressed=\"true\"]').dataset.index"), String(explained), id);
  }
  await closed(page);
}

/** Settings whose lines are looked at: the first one, a force that acts late, and a cap that its scene writes. */
const SETTINGS = [{}, { effects: { delay: { ticks: 1 } } }, { effects: { delay: { ticks: 2 } }, stabilizer: { popc: { damping_cap: 0.3 } } }];

/** Lines that the page offers in a language in each setting. */
async function offered(browser, language) {
  const [all, first] = [[], await opened(browser)];
  const tree = await first.value("lyapunov.state.tree");
  await closed(first);
  for (const more of SETTINGS) {
    const page = await opened(browser, {}, `#${address({ ...tree, ...more })}`);
    all.push(...(await offeredHere(page, language)));
    await closed(page);
  }
  for (const text of all) assert.ok(!/undefined|NaN/.test(text), text);
  const held = { Rust: [/of_mass\(0\.5, .*\.delayed\(1\)/, /of_mass\(0\.3, MASS, PERIOD\)\?;/], C: [/of_mass\(0\.5, mass, period, 1,/, /of_mass\(0\.3, mass, period, 0,/], Python: [/cap=0\.5, delay=1\)/, /cap=0\.3, delay=0\)/] };
  for (const limit of held[language]) assert.equal(all.filter((it) => limit.test(it)).length, 4, `${language}: ${limit}`);
  return all;
}

/** Lines that the page offers in a language, under no stabilizer, POPC and LOLC with each candidate. */
async function offeredHere(page, language) {
  const all = [];
  const copied = `(() => { [...document.querySelectorAll('#lines button')].find((it) => it.textContent.includes(" ${language} ")).click(); return document.querySelector('#code').textContent; })()`;
  await credit(page, "lolc-mass-spring-damper");
  for (const index of [0, 1, 2]) {
    await page.value(`document.querySelector('#why-of button[data-index="${index}"]').click()`);
    all.push(await page.value(copied));
  }
  for (const name of ["lolc-device-damping", "lolc-spring"]) {
    await credit(page, name);
    all.push(await page.value(copied));
  }
  assert.ok(new Set(all).size >= 4, `${language}: too few different loops`);
  return all;
}

/** Lines that the page offers: they compile without a warning. */
async function lines(browser) {
  const crate = join(folder, "lines");
  mkdirSync(join(crate, "src"), { recursive: true });
  writeFileSync(join(crate, "Cargo.toml"), `[workspace]\n[package]\nname = "lines"\nversion = "0.0.0"\nedition = "2024"\n[dependencies]\nlyapunov = { path = ${JSON.stringify(root)} }\n`);
  const modules = (await offered(browser, "Rust")).map((text, index) => `mod it${index} {\n${text}}\n`);
  writeFileSync(join(crate, "src/lib.rs"), `//! Lines from the page.\n#![allow(dead_code)]\n${modules.join("")}`);
  const env = { ...process.env, RUSTFLAGS: "-D warnings", CARGO_TARGET_DIR: process.env.CARGO_TARGET_DIR ?? join(root, "target") };
  execFileSync("cargo", ["check", "--quiet", "--manifest-path", join(crate, "Cargo.toml")], { env, stdio: "inherit" });

  const header = process.env.LYAPUNOV_H ?? join(root, "bindings/c/include");
  for (const [index, text] of (await offered(browser, "C")).entries()) {
    const source = join(folder, `control-${index}.c`);
    writeFileSync(source, text);
    if (existsSync(join(header, "lyapunov.h"))) execFileSync("cc", ["-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I", header, source], { stdio: "inherit" });
    else if (index === 0) console.log("SKIPPED: the C lines: there is no bindings/c/include/lyapunov.h");
  }
  for (const text of await offered(browser, "Python")) execFileSync("python3", ["-c", "import sys; compile(sys.stdin.read(), 'control.py', 'exec')"], { input: text });
}

/** Wide and narrow, light and dark: nothing sticks out, nothing is asked for, axe-core finds nothing serious. */
async function looks(browser) {
  for (const width of [1280, 360]) {
    for (const scheme of ["light", "dark"]) {
      const page = await opened(browser, { width, scheme, height: 900 });
      await mapped(page);
      await page.until("document.querySelectorAll('#members tbody tr').length > 10", 60);
      const [wide, shown] = await page.value("[document.documentElement.scrollWidth, document.documentElement.clientWidth]");
      assert.ok(wide <= shown, `${wide} pixels wide on ${shown}`);
      await page.value(`${axe}; 0`);
      const findings = await page.value("axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'best-practice'] }).then(({ violations }) => violations.filter((it) => ['serious', 'critical'].includes(it.impact)).map((it) => `${it.id}: ${it.help}: ${it.nodes.map((node) => node.html).slice(0, 4).join(' | ')}`))");
      assert.deepEqual(findings, [], `${width} ${scheme}`);
      await closed(page);
    }
  }
}

/** The chapters of the book: equations are drawn, the page runs inside, nothing fails, nothing comes from elsewhere. */
async function book(browser) {
  for (const [chapter, equations] of Object.entries({ index: 0, port: 4, ledger: 4, candidate: 4, "your-loop": 2 })) {
    const page = await browser.open(`file://${join(dirname(dirname(file)), "book", `${chapter}.html`)}`, { width: 1100, height: 3000 });
    await page.until("document.querySelector('iframe') !== null");
    assert.ok(await page.value(`document.querySelectorAll('math').length >= ${equations}`), chapter);
    assert.ok(await page.value("!document.querySelector('main, [role=main]').textContent.includes('$')"), chapter);
    const faults = page.faults().filter((it) => !it.startsWith("request: file://"));
    assert.deepEqual(faults, [], chapter);
    await page.close();
  }
}

const browser = new Browser(chromium);
try {
  for (const check of [ranges, thin, words, rows, dropped, maps, steps, family, reasons, caps, hand, frames, shared, taken, refused, paper, lines, looks, book]) {
    if (only.length && !only.includes(check.name)) continue;
    const began = performance.now();
    await check(browser);
    console.log(`${check.name}: done in ${((performance.now() - began) / 1e3).toFixed(1)} s`);
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
