// What comes in and what is taken along: addresses, files, rows; and what is refused.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { address } from "../page/scene.js";
import { closed, credit, drop, folder, lyapunov, opened, root, saved, seen, slide, verdicts } from "./driver.mjs";

/** A scene goes into the address, a file and back. */
export async function shared(browser) {
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
  await seen(other, "#done");
  await other.value("scrollTo(0, 0)");
  await drop(other, [["broken.toml", "duration = 1\nservo_rate = -1"]]);
  await other.until("document.querySelector('#done').textContent.includes('broken.toml:2:')");
  await seen(other, "#done");
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

/** An address whose scene needs a recorded motion stays until that is dropped, and then its scene opens; of several files one opens. */
export async function awaited(browser) {
  const page = await opened(browser);
  const shipped = (name) => [name, readFileSync(join(root, "scenes", name), "utf8")];
  const [scene, motion, other] = ["motion-file.toml", "motion-file.csv", "friction.toml"].map(shipped);
  await drop(page, [motion, other, scene]);
  const one = "motion-file.toml is open. One file at a time: not opened: friction.toml.";
  await page.until(`document.querySelector('#done').textContent === "${one}"`);
  assert.ok((await page.value("document.querySelector('#said').textContent")).includes("not opened: friction.toml"));
  await new Promise((later) => setTimeout(later, 500));
  await seen(page, "#said");
  await page.until("location.hash.includes('motion')");
  const [hash, tree] = [await page.value("location.hash"), await page.value("lyapunov.scene()")];
  await closed(page);
  const late = await opened(browser, {}, hash);
  assert.match(await late.value("document.querySelector('#fault').textContent"), /motion-file.csv.*drop it here/);
  await late.until("document.querySelector('.remedy')");
  assert.equal(await late.value("location.hash"), hash);
  await drop(late, [motion]);
  await late.until(`lyapunov.scene() === ${JSON.stringify(tree)} && document.querySelector('#fault').textContent === ""`);
  await drop(late, [["other.csv", motion[1]]]);
  await late.until("document.querySelector('#done').textContent.includes('other.csv')");
  await seen(late, "#done");
  await slide(late, "device.mass", 0.4);
  await late.until(`location.hash !== ${JSON.stringify(hash)}`);
  await closed(late);
}

/** What is taken along is the loop that is shown: files, an address under any choice, a scene's own stabilizer. */
export async function taken(browser) {
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

/** What no slider shows is named, for as long as it is there; a cap that no scene writes stays unwritten. */
export async function named(browser) {
  const first = await opened(browser);
  const tree = await first.value("lyapunov.state.tree");
  await closed(first);
  const effects = { saturation: { force: 8 }, delay: { ticks: 2 }, encoder: { resolution: 1e-5 }, friction: { coulomb: 0.5 } };
  const page = await opened(browser, {}, `#${address({ ...tree, effects })}`);
  const said = () => page.value("document.querySelector('#said').textContent");
  const others = "Also in the scene: effects.saturation.force = 8, effects.friction.coulomb = 0.5.";
  assert.equal(await said(), `The scene of this address. ${others}`);
  await slide(page, "device.mass", 0.4);
  assert.equal(await said(), others);
  await page.value("document.querySelector('#desk').click(); 0");
  await slide(page, "device.mass", 0.4);
  assert.equal(await said(), "");
  await drop(page, [["own.toml", `${await page.value("lyapunov.scene()")}\n[stabilizer.popc]\n`]]);
  await page.until("document.querySelector('#done').textContent === 'own.toml is open.'");
  assert.equal(await said(), "The scene of own.toml.");
  assert.ok(!/damping_cap/.test(await saved(page, "#download")));
  await drop(page, [["box.toml", readFileSync(join(root, "scenes/box.toml"), "utf8")]]);
  await page.until("document.querySelector('#said').textContent.includes('environment.box.stiffness = ')");
  assert.match(await said(), /initial.position = \[/);
  await closed(page);
}

/** An address or a file that the page cannot run leaves what it shows, and lines are offered only where they say what runs. */
export async function refused(browser) {
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
  // An address counts, also where what was moved just before is written over it.
  await cut.value("((was) => { location.hash = was.replace('duration=2&', 'duration=4&'); history.replaceState(null, '', was); })(location.hash)");
  await cut.until("lyapunov.state.tree.duration === 4");
  const shipped = (name) => readFileSync(join(root, `scenes/${name}.toml`), "utf8");
  const own = Object.fromEntries(["sphere", "hold", "press-1khz", "filter-cutoff"].map((name) => [name, shipped(name)]));
  const other = { ...own, exact: `velocity = "exact"\n${shipped("paper-8k-none")}` };
  for (const [stem, text] of Object.entries({ ...other, plain: shipped("paper-8k-none"), grip: shipped("grip") })) {
    const [name, isOff] = [`${stem}.toml`, stem in other];
    await drop(cut, [[name, text]]);
    await cut.until(`document.querySelector('#done').textContent.includes('${name} is open')`);
    const off = await cut.value("[...document.querySelectorAll('#lines button')].map((it) => it.disabled && it.title !== '')");
    assert.deepEqual(off, [isOff, isOff, isOff], name);
  }
  // It says so at once, where rows of all ticks would fill the memory.
  await drop(cut, [["long.toml", `${shipped("paper-8k-none").replace(/^duration.*$/m, "duration = 1e5")}`]]);
  await cut.until("document.querySelector('#done').textContent.includes('a million ticks')");
  assert.equal(await cut.value("lyapunov.state.tree.duration === 1e5"), false);
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
