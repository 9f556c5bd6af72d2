// What the page computes is what the command computes.

import assert from "node:assert/strict";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { MOTIONS, cards, closed, credit, drop, folder, lyapunov, opened, root, seen, slide, told, verdicts } from "./driver.mjs";

/** Every shipped scene: the rows of the page's own engine are those of the command, byte for byte. */
export async function rows(browser) {
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

/** Every shipped scene opens where it is dropped, with the command's words; a hand holds it where one mass on a line moves as it says. */
export async function dropped(browser) {
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
    assert.equal(isHeld, !/^\[(space|link|effects\.(friction|jitter|load|pulse))\]/m.test(text), name);
    // Under a hand that stands before the wall, wherever that is.
    if (isHeld) assert.ok(await page.value("lyapunov.loops.letGo(), lyapunov.loops.forward(0.05), lyapunov.loops.lanes.every((it) => !(it.gone > 0))"), name);
  }
  await closed(page);
}

/** Maps under each basic stabilizer: every verdict is the command's. */
export async function maps(browser) {
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

/** Sliders change the words, and the words are those of `compare` on the same scene. */
export async function words(browser) {
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

/** The energies that the page shows are in the table of `explain`, by the same names. */
async function energies(page, path) {
  const text = lyapunov("explain", path);
  const shown = await page.value("[...document.querySelectorAll('#energies tbody tr')].map((it) => [...it.cells].map((cell) => cell.textContent))");
  const mJ = (line) => line.trim().split(/\s{2,}/).slice(-2).map(Number);
  for (const [name, ...energies] of shown) {
    const line = text.split("\n").find((it) => it.includes(name));
    assert.ok(line, `${name} is not in\n${text}`);
    mJ(line).forEach((known, index) => {
      const here = Number(energies[index].replaceAll("−", "-"));
      assert.ok(Math.abs(here - known) <= 6e-3 * Math.abs(known) || Math.abs(here) < 1e-6, `${name}: ${here} instead of ${known}`);
    });
  }
}

/** What is said of a bounded run in a loop that is not stable: what bounds it, or that it leaves the wall, or neither. */
async function bounded(page) {
  const scene = (start, hand, effect) => `servo_rate = 1000\nduration = 2\ninitial = { position = ${start} }\ndevice = { mass = 0.2, damping = 0.1 }
operator = { mass = 0.1, damping = 1, stiffness = 300, rest = 0.003${hand} }\nenvironment.wall = { stiffness = 40000, damping = 2 }\neffects.${effect}\n`;
  const cases = [
    [scene(-0.006, "", "saturation.force = 8"), "the largest force of 8 N bounds it"],
    [scene(-0.006, ', motion = { kind = "step", at = 0.05, to = -0.005 }', "saturation.force = 1e6"), "this run does not stay in contact"],
    [scene(1e-4, "", "friction.coulomb = 5"), "yet this run does not grow"],
  ];
  for (const [index, [text, said]] of cases.entries()) {
    const path = join(folder, "bounded.toml");
    writeFileSync(path, text);
    const { spectral_radius: radius, verdict, first_contact: first } = JSON.parse(lyapunov("explain", path, "--json"));
    assert.ok(radius > 1 && verdict !== "grows" && (first.to_s === 2) === (index === 2), `${text}: ${radius} ${verdict} ${first.to_s}`);
    await drop(page, [["bounded.toml", text]]);
    await page.until(`document.querySelector('#why-said').textContent.endsWith(${JSON.stringify(`not stable in contact; ${said}.`)})`);
  }
}

/** Of a run that is too short nothing is said about what bounds it. */
async function unjudged(page) {
  const text = "servo_rate = 1000\nduration = 0.008\ninitial = { position = 1e-4 }\ndevice = { mass = 0.2, damping = 0.1 }\nenvironment.wall.stiffness = 40000\n";
  await drop(page, [["short.toml", text]]);
  const said = "The run is too short to judge. The loop alone is not stable in contact.";
  await page.until(`document.querySelector('#why-said').textContent === ${JSON.stringify(said)}`);
}

/** Units of the keys that remedies write. */
const UNITS = { servo_rate: " Hz", "environment.wall.stiffness": " N/m", "environment.wall.damping": " N·s/m", "device.damping": " N·s/m" };

/** Of a remedy that keeps the hand from the wall that is said, and no word on the motion that is left. */
async function untouched(page) {
  await page.value("document.querySelector('#figure-7').click(); 0");
  const said = "no force acts: the wall is not touched any more";
  await page.until(`[...document.querySelectorAll('.remedy span')].some((it) => it.textContent === "${said}")`);
}

/** The explanation that the page shows is the one of `explain`; a remedy's button does what it says. */
export async function reasons(browser) {
  const page = await opened(browser);
  await page.until("document.querySelectorAll('#energies tbody tr').length > 3 && document.querySelector('.remedy')");
  const path = join(folder, "why.toml");
  writeFileSync(path, await page.value("lyapunov.scene()"));
  await energies(page, path);
  const remedies = JSON.parse(lyapunov("explain", path, "--json")).remedies;
  const sets = await page.value("[...document.querySelectorAll('.remedy b')].map((it) => it.textContent)");
  assert.deepEqual(sets, remedies.map(({ set }) => Object.entries(set).map(([key, it]) => `${key} = ${it}${UNITS[key] ?? ""}`).join(", ")));
  const felt = await page.value("[...document.querySelectorAll('.remedy span')].map((it) => it.textContent)");
  assert.ok(felt.every((it) => / N \(rms\)$/.test(it)), felt.join("; "));
  await page.value("document.querySelector('.remedy').focus()");
  await page.key("Enter");
  assert.equal((await verdicts(page))[0], remedies[0].verdict);
  await page.until("document.querySelector('#why-said').textContent.length > 1");
  // Where one reads what it wrote, with the way back.
  assert.equal(await page.value("document.activeElement.id"), "said");
  await seen(page, "#said button");
  const calm = 'servo_rate = 1000\nduration = 2\ndevice = { mass = 0.2, damping = 3 }\noperator = { mass = 0.1, stiffness = 50 }\n[environment.wall]\nstiffness = 40000\n';
  writeFileSync(path, calm);
  await drop(page, [["calm.toml", calm]]);
  await page.until("document.querySelector('#why-said').textContent.includes('in balance')");
  const note = lyapunov("run", path).replace(/\s+/g, " ").split(" note ")[1].trim();
  assert.equal((await page.value("document.querySelector('#why-said').textContent")).toLowerCase(), `${note.toLowerCase()}.`);
  await bounded(page);
  await unjudged(page);
  await untouched(page);
  const coarse = 'servo_rate = 1000\nduration = 2\nintegrator = "semi-implicit-euler"\ndevice = { mass = 0.2, damping = 3 }\n[environment.wall]\nstiffness = 2000\n[initial]\nposition = -0.01\nvelocity = 0.2\n';
  writeFileSync(path, coarse);
  await drop(page, [["coarse.toml", coarse]]);
  await page.until("document.querySelector('#energies').textContent.includes('integrator')");
  await energies(page, path);
  await closed(page);
}

/** The presets of the paper: the verdicts and the numbers that the page says, also where another candidate was chosen before. */
export async function paper(browser) {
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
