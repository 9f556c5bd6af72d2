// What one does on the page does what it says.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

import { choose, closed, folder, lyapunov, mapped, opened, saved, slide, verdicts } from "./driver.mjs";

const SHIFT = 8;

/** The hand by mouse and by keys, and the loops under it. */
export async function hand(browser) {
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
export async function frames(browser) {
  const page = await opened(browser);
  const many = await page.value("new Promise((done) => { let n = 0; const began = performance.now(); const one = (now) => { n += 1; if (now - began > 2000) done(n / ((now - began) / 1e3)); else requestAnimationFrame(one); }; requestAnimationFrame(one); })");
  const cost = await page.value("lyapunov.cost()");
  console.log(`${many.toFixed(0)} frames a second here, ${cost.toFixed(2)} ms of work in each`);
  await closed(page);
}

/** The map moves the sliders where there is one; where there is none the page claims none, and names the command that makes it. */
export async function steps(browser) {
  const page = await opened(browser);
  await mapped(page);
  const scene = () => page.value("lyapunov.scene()");
  const touch = async (key) => {
    const at = await page.place("#map");
    await page.click(at.x, at.y);
    await page.value("document.querySelector('#map').focus()");
    await page.key(key);
    return scene();
  };
  const before = await scene();
  const moved = await touch("ArrowLeft");
  assert.notEqual(moved, before);
  const same = "document.querySelector('#map-y')";
  await page.value(`${same}.value = document.querySelector('#map-x').value; ${same}.dispatchEvent(new Event("change"))`);
  const parts = () => page.value("[...document.querySelectorAll('#map-part > :is(p:not(#map-said), .frame, .legend)')].map((it) => it.clientHeight > 0)");
  assert.deepEqual(await parts(), [false, false, false], "both axes are the same");
  await page.value(`${same}.value = "environment.wall.damping"; ${same}.dispatchEvent(new Event("change"))`);
  await mapped(page);
  await slide(page, "effects.delay.ticks", 0.2);
  await page.until("document.querySelector('#map-said').textContent.includes('does not map this scene')");
  assert.deepEqual(await parts(), [false, false, false], "there is no map of a late force");
  const path = join(folder, "unmapped.toml");
  writeFileSync(path, await saved(page, "#download"));
  const command = await page.value("document.querySelector('#map-said code').textContent");
  const [name, ...words] = command.replace(" scene.toml ", ` ${path} `).replace(" map", " map --json").replaceAll(":256", ":3").split(" ");
  assert.equal(name, "lyapunov");
  words[words.indexOf("--out") + 1] = join(folder, "unmapped");
  assert.equal(JSON.parse(lyapunov(...words)).areas.length, 1);
  await slide(page, "effects.delay.ticks", 0);
  await mapped(page);
  assert.deepEqual(await parts(), [true, true, true]);
  const back = await scene();
  assert.notEqual(await touch("ArrowRight"), back);
  await closed(page);
}

/** The line on the map is the exact limit at each pixel along it, is named where it is drawn, and says whose limit it is. */
export async function limit(browser) {
  const page = await opened(browser);
  await mapped(page);
  await page.until("lyapunov.map.limits");
  const far = await page.value(`(() => { const { map, engine, scene } = lyapunov; const { limits, places, box: { tall } } = map; let most = 0;
    for (let index = 0; index + 1 < limits.length; index += 7) {
      const damping = 100 * (places[index] + places[index + 1]) / 2;
      const [exact] = engine.numbers("limits", scene().replace(/(\\[environment.wall\\][^[]*damping = ).*/, "$1" + damping));
      const drawn = Math.sqrt(limits[index] * limits[index + 1]);
      most = Math.max(most, Math.abs(Math.log(exact / drawn)));
    }
    return [limits.length > tall, most]; })()`);
  assert.ok(far[0] && far[1] < 0.01, `${far}`);
  const named = () => page.value("(({ hidden, textContent }) => (hidden ? '' : textContent))(document.querySelector('#legend .bound'))");
  assert.equal(await named(), "exact limit of the linear loop");
  await choose(page, "map-under", "popc");
  await page.until("lyapunov.map.limits");
  assert.equal(await named(), "exact limit of the linear loop without a stabilizer");
  await choose(page, "map-x", "device.mass");
  await mapped(page);
  assert.equal(await named(), "");
  await closed(page);
}

/** The family's table holds the rows of the last setting only, however soon the sliders moved. */
export async function family(browser) {
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

/** A cap that a remedy writes stands in the scene: the page says so for as long as it does, and takes it back. */
export async function caps(browser) {
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
