// The page: one scene, three loops, and everything that follows from them.

import { draw } from "./curves.js";
import { Engine, LIVE, RUN, unpacked } from "./engine.js";
import { Family } from "./family.js";
import { StabilityMap } from "./map.js";
import { ink, onScheme } from "./paint.js";
import { PRESETS } from "./presets.js";
import { address, bare, changed, ofAddress, toml } from "./scene.js";
import { wire } from "./share.js";
import { fill, moved } from "./sliders.js";
import { Stage } from "./stage.js";
import { tell } from "./why.js";
import { work } from "./worker.js";

const $ = (id) => document.getElementById(id);
const CANDIDATES = { "lolc-mass-spring-damper": "the wall's damper", "lolc-device-damping": "the device's damper", "lolc-spring": "a spring" };
const REST = -0.006;
/** How far the hand moves by itself, m. */
const LED = 0.009;
const FAR = 0.15;
const SEEN = 3;

/** What the page shows: the scene, the candidate of LOLC, the loop that is explained, what the curves are of. */
const state = { tree: PRESETS[0].scene, candidate: "lolc-mass-spring-damper", under: "none", look: "live", hand: REST };
let [engine, worker, words, told] = [null, null, [], 0];
const names = () => ["none", "popc", state.candidate];
const TITLES = { none: "no stabilizer", popc: "POPC" };
const title = (name) => TITLES[name] ?? "LOLC";
const colour = (name) => ink()[TITLES[name] ? name : "lolc"];

// The three loops under the hand.

const lanes = [0, 1, 2].map(() => ({ rows: new Float64Array(0), fled: 0, note: "" }));
let [last, carried, handBefore, since] = [0, 0, REST, 0];

/** Puts a loop at `place`, at standstill: not inside the wall, where the first tick would throw it out. */
function grasp(index, place = state.hand) {
  engine.bytes("hold", `${names()[index]}\n${toml(state.tree)}`, index, Math.min(place, -1e-4));
}

/** Puts all loops where the hand is. */
function letGo() {
  since = 0;
  handBefore = state.hand;
  lanes.forEach((lane, index) => {
    Object.assign(lane, { rows: new Float64Array(0), fled: 0, gone: 0 });
    grasp(index);
  });
}

/** Takes the changed scene into the running loops, which go on where they are. */
function regrasp() {
  try {
    lanes.forEach((lane, index) => {
      const place = lane.rows[lane.rows.length - LIVE.width + LIVE.x];
      grasp(index, Math.abs(place) < FAR ? place : state.hand);
      Object.assign(lane, { fled: 0, gone: 0 });
    });
    state.still = false;
  } catch {
    state.still = true;
  }
}

function forward(seconds) {
  const exact = seconds * state.tree.servo_rate + carried;
  const ticks = Math.min(Math.floor(exact), 4000);
  carried = exact - Math.floor(exact);
  if (!ticks || state.still) return;
  if (!state.touched) lead(seconds);
  const began = since;
  since += ticks / state.tree.servo_rate;
  lanes.forEach((lane, index) => {
    if (lane.gone > 0) {
      lane.gone -= seconds;
      if (lane.gone <= 0) grasp(index);
      return;
    }
    const rows = engine.numbers("advance", "", index, ticks, handBefore, state.hand);
    for (let at = 0; at < rows.length; at += LIVE.width) rows[at] = began + (at / LIVE.width) / state.tree.servo_rate;
    const place = rows[rows.length - LIVE.width + LIVE.x];
    if (!(Math.abs(place) < FAR)) Object.assign(lane, { gone: 1.2, fled: lane.fled + 1 });
    lane.rows = joined(lane.rows, rows);
  });
  handBefore = state.hand;
}

/** Until someone takes the hand it presses and lets go by itself. */
function lead(seconds) {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  state.led = (state.led ?? 0) + seconds;
  state.hand = REST + 0.5 * LED * (1 - Math.cos((2 * Math.PI * state.led) / 4));
}

/** The rows of the last seconds. */
function joined(before, after) {
  const from = since - SEEN;
  let first = 0;
  while (first < before.length && before[first] < from) first += LIVE.width;
  const all = new Float64Array(before.length - first + after.length);
  all.set(before.subarray(first));
  all.set(after, before.length - first);
  return all;
}

function lane(index) {
  const { rows, gone, fled } = lanes[index];
  const name = names()[index];
  const from = Math.max(0, rows.length - LIVE.width * Math.ceil(0.12 * state.tree.servo_rate));
  let [low, high, peak] = [Infinity, -Infinity, 0];
  for (let at = from; at < rows.length; at += LIVE.width) {
    low = Math.min(low, rows[at + LIVE.x]);
    high = Math.max(high, rows[at + LIVE.x]);
    if (Math.abs(rows[at + LIVE.force]) > Math.abs(peak)) peak = rows[at + LIVE.force];
  }
  const end = rows.length - LIVE.width;
  const place = end >= 0 ? rows[end + LIVE.x] : state.hand;
  if (!(low <= high)) [low, high] = [place, place];
  const note = gone > 0 ? "ran away" : fled ? `ran away ${fled}×` : "";
  const sound = Number.isFinite(place) ? place : FAR;
  return { name: title(name), colour: colour(name), place: sound, range: [low, high], force: end >= 0 ? rows[end + LIVE.force] : 0, peak, note };
}

// The runs from the start.

const runs = new Map();

function rerun() {
  runs.clear();
  const scene = toml(state.tree);
  for (const name of names()) runs.set(name, engine.run(name, scene));
}

function cards() {
  const place = $("verdicts");
  if (!place.children.length) for (let index = 0; index < 3; index += 1) place.append(card(index));
  [...place.children].forEach((it, index) => {
    const name = names()[index];
    const run = runs.get(name);
    const word = it.querySelector(".word");
    word.textContent = words[run.verdict];
    word.className = `word ${["settles", "swinging", "grows", "short"][run.verdict]}`;
    const rests = run.verdict === 0 ? `at rest after ${run.settled.toFixed(2)} s, ` : "";
    const force = run.verdict === 2 ? "" : `at most ${run.peak.toPrecision(3)} N`;
    it.querySelector(".told").textContent = run.verdict === 2 ? "the run gets larger and larger" : rests + force;
    it.dataset.name = name;
  });
}

function card(index) {
  const it = document.createElement("article");
  it.className = `card ${["none", "popc", "lolc"][index]}`;
  const head = document.createElement("h3");
  head.textContent = title(names()[index]);
  const [word, said] = [document.createElement("strong"), document.createElement("p")];
  said.className = "told";
  it.append(head, word, said);
  word.className = "word";
  if (index === 2) {
    const label = document.createElement("label");
    label.textContent = "credits ";
    const select = document.createElement("select");
    select.id = "candidate";
    for (const [name, text] of Object.entries(CANDIDATES)) select.append(new Option(text, name));
    select.addEventListener("change", () => choose(select.value));
    label.append(select);
    it.append(label);
  }
  return it;
}

function choose(candidate) {
  if (state.under === state.candidate) state.under = candidate;
  state.candidate = candidate;
  $("candidate").value = candidate;
  update();
}

// The frame.

let stage = null;

let cost = 0;

function frame(now) {
  requestAnimationFrame(frame);
  const began = performance.now();
  const seconds = Math.min(0.1, (now - last) / 1e3);
  last = now;
  forward(seconds);
  stage.draw(state.hand, [0, 1, 2].map(lane));
  if (state.look === "live") {
    const columns = LIVE;
    const series = lanes.map(({ rows, gone, fled }, index) => ({ rows, columns, colour: colour(names()[index]), tame: !(gone > 0) && !fled }));
    draw($("curves"), series, since - SEEN, since);
  } else if (state.stale) {
    const series = names().map((name) => ({ rows: runs.get(name).rows, columns: RUN, colour: colour(name), tame: runs.get(name).verdict < 2 }));
    draw($("curves"), series, 0, state.tree.duration);
    state.stale = false;
  }
  cost += 0.05 * (performance.now() - began - cost);
}

function look(at) {
  state.look = at;
  state.stale = true;
  for (const one of ["live", "run"]) $(`show-${one}`).setAttribute("aria-pressed", String(one === at));
}

// Everything that follows from a scene.

let show = () => {};
let family = null;
let map = null;
let later = 0;

function ask(kind, about) {
  told += 1;
  worker.postMessage({ id: told, kind, ...about });
}

/** Takes the state to all parts of the page. */
function update() {
  try {
    rerun();
    $("fault").textContent = "";
  } catch (error) {
    $("fault").textContent = error.message;
    return;
  }
  regrasp();
  cards();
  show(state.tree);
  state.stale = true;
  const scene = toml(state.tree);
  map.show(state.tree, names());
  for (const button of $("why-of").children) {
    const name = names()[button.dataset.index];
    button.setAttribute("aria-pressed", String(name === state.under));
  }
  clearTimeout(later);
  later = setTimeout(() => {
    history.replaceState(null, "", `#${address(state.tree)}`);
    ask("explain", { scene, name: state.under });
    family.begin();
    ask("family", { scene });
  }, 120);
}

function take(tree) {
  state.tree = tree;
  update();
}

/** Applies a remedy: keys of the scene; those of a stabilizer choose the loop to look at. */
function remedy(set) {
  let tree = state.tree;
  for (const [key, to] of Object.entries(set)) {
    if (!key.startsWith("stabilizer")) tree = changed(tree, key, to);
    else if (key.endsWith("candidate")) state.candidate = `lolc-${to}`;
  }
  const named = Object.keys(set).find((key) => key.startsWith("stabilizer"));
  if (named) {
    tree = changed(tree, "stabilizer", undefined);
    for (const [key, to] of Object.entries(set)) if (key.startsWith("stabilizer")) tree = changed(tree, key, to);
    state.under = named.includes("popc") ? "popc" : state.candidate;
    $("candidate").value = state.candidate;
  }
  take(tree);
}

function hear({ data }) {
  if (data.kind === "family") family.hear(data);
  if (data.kind === "map") map.hear(data);
  if (data.kind !== "explain") return;
  if (data.refused) $("why-said").textContent = data.refused;
  else tell({ said: $("why-said"), energies: $("energies"), remedies: $("remedies") }, data, remedy);
}

function presets() {
  for (const preset of PRESETS) {
    const button = document.createElement("button");
    Object.assign(button, { type: "button", textContent: preset.name, id: preset.id });
    button.addEventListener("click", () => start(preset));
    $("presets").append(button);
    if (!preset.claims) continue;
    const part = document.createElement("article");
    const go = document.createElement("button");
    Object.assign(go, { type: "button", textContent: `See ${preset.name.toLowerCase()}` });
    go.addEventListener("click", () => {
      start(preset);
      $("stage").scrollIntoView({ behavior: "smooth" });
    });
    const head = document.createElement("h3");
    head.textContent = preset.name;
    const said = document.createElement("p");
    said.textContent = preset.said;
    const list = document.createElement("dl");
    for (const [claim, seen] of preset.claims) {
      for (const [tag, text] of [["dt", claim], ["dd", seen]]) list.append(Object.assign(document.createElement(tag), { textContent: text }));
    }
    part.append(head, said, list, go);
    $("claims").append(part);
  }
}

function start(preset) {
  $("said").textContent = preset.said;
  state.under = preset.shows ?? "none";
  look(preset.look);
  state.tree = preset.scene;
  state.hand = REST;
  place();
  update();
  letGo();
}

function open(name, text) {
  try {
    if (!/^\s*duration\s*=/m.test(text) && /[,;\t]/.test(text.split("\n", 1)[0])) {
      $("code").hidden = false;
      $("code").textContent = engine.text("observed", `${name}\n${text}`);
      $("done").textContent = `${name} is a log: below is what the observer says of it.`;
      return;
    }
    state.tree = bare(JSON.parse(engine.text("read", `\n${text}`)));
    look("run");
    update();
    letGo();
    $("done").textContent = `${name} is open.`;
  } catch (error) {
    $("done").textContent = error.message;
  }
}

// The hand.

function place() {
  const mm = state.hand * 1e3;
  const text = `${Math.abs(mm).toFixed(1)} mm ${mm > 0 ? "into" : "before"} the wall`;
  for (const [key, to] of [["aria-valuenow", mm.toFixed(1)], ["aria-valuetext", text]]) $("wall").setAttribute(key, to);
}

function reach(to) {
  state.hand = Math.max(-0.02, Math.min(0.02, to));
  state.touched = true;
  $("tip").hidden = true;
  place();
}

function hands() {
  const canvas = $("wall");
  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = { x: event.clientX, hand: state.hand };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => held && reach(held.hand + stage.way(event.clientX - held.x)));
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (held = null));
  canvas.addEventListener("keydown", (event) => {
    const by = event.shiftKey ? 0.002 : 0.0005;
    const to = { ArrowRight: state.hand + by, ArrowUp: state.hand + by, ArrowLeft: state.hand - by, ArrowDown: state.hand - by, Home: -0.02, End: 0.02 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    reach(to);
  });
  $("again").addEventListener("click", () => {
    reach(REST);
    letGo();
  });
}

async function begin(module, source) {
  engine = await Engine.of(module);
  words = engine.lines("verdicts");
  stage = new Stage($("wall"));
  worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
  worker.addEventListener("message", hear);
  worker.postMessage({ module });
  family = new Family($("members"), words);
  map = new StabilityMap({ canvas: $("map"), x: $("map-x"), y: $("map-y"), under: $("map-under"), said: $("map-said") }, ask, (moves) =>
    take(moves.reduce((tree, [slider, number]) => moved(tree, slider, number), state.tree)));
  show = fill($("sliders"), (slider, number) => take(moved(state.tree, slider, number)));
  for (const [index, name] of ["no stabilizer", "POPC", "LOLC"].entries()) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
    button.dataset.index = index;
    button.addEventListener("click", () => {
      state.under = names()[index];
      update();
    });
    $("why-of").append(button);
  }
  for (const [index, word] of ["settles", "swinging", "grows"].entries()) {
    const it = Object.assign(document.createElement("li"), { textContent: words[index] });
    it.className = word;
    $("legend").append(it);
  }
  $("legend").append(Object.assign(document.createElement("li"), { className: "bound", textContent: "exact limit of the linear loop" }));
  for (const at of ["live", "run"]) $(`show-${at}`).addEventListener("click", () => look(at));
  presets();
  hands();
  wire({ $, engine, now: () => ({ tree: state.tree, name: state.under }), open });
  const shared = ofAddress(location.hash);
  start(PRESETS[0]);
  if (shared) {
    $("said").textContent = "The scene of this address.";
    take(shared);
    letGo();
  }
  new ResizeObserver(() => {
    state.stale = true;
    map.draw();
    family.draw();
  }).observe(document.body);
  onScheme(() => {
    state.stale = true;
    map.renew(true);
    family.draw();
  });
  requestAnimationFrame((now) => {
    last = now;
    frame(now);
  });
  document.documentElement.dataset.ready = "yes";
  // What tests ask: the engine that everything above uses, and what it is asked about.
  globalThis.lyapunov = { engine, state, lane, scene: () => toml(state.tree), cost: () => cost };
}

if (globalThis.document === undefined) work();
else {
  const source = $("program").textContent;
  unpacked($("rust").textContent).then((module) => begin(module, source)).catch((error) => {
    $("fault").textContent = `This browser cannot run the page: ${error.message}`;
  });
}
