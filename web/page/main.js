// The page: one scene, three loops, and everything that follows from them.

import { draw } from "./curves.js";
import { Engine, LIVE, RUN, inside } from "./engine.js";
import { Family } from "./family.js";
import { opener } from "./files.js";
import { hands } from "./hand.js";
import { Loops, SEEN } from "./loops.js";
import { button, made, put } from "./made.js";
import { StabilityMap } from "./map.js";
import { DASHES, VERDICTS, ink, isCalm, onScheme } from "./paint.js";
import { PRESETS, list } from "./presets.js";
import { Questions } from "./questions.js";
import { address, bare, changed, ofAddress, toml, value } from "./scene.js";
import { wire } from "./share.js";
import { fill, moved, unseen } from "./sliders.js";
import { Stage } from "./stage.js";
import { digits, tell, written } from "./why.js";
import { work } from "./worker.js";

const $ = (id) => document.getElementById(id);
/** The paper's own candidate. */
const OWN = "lolc-mass-spring-damper";
const CANDIDATES = { [OWN]: "the wall's damper", "lolc-device-damping": "the device's damper", "lolc-spring": "a spring" };
/** What the page shows: the scene, the candidate of LOLC, the loop that is explained, what the curves are of. */
const state = { tree: PRESETS[0].scene, candidate: OWN, under: "none", look: "live" };
let [engine, worker, words, open] = [null, null, [], () => {}];
/** An address whose scene cannot run before a motion is dropped: it stays until then. */
let wanted = null;
const names = () => ["none", "popc", state.candidate];
const TITLES = { none: "no stabilizer", popc: "POPC" };
const title = (name) => TITLES[name] ?? "LOLC";
/** Colour and dashes of the curves of a loop. */
const line = (index) => ({ colour: ink()[["none", "popc", "lolc"][index]], dash: DASHES[index] });

// The runs from the start.

const runs = new Map();

function rerun() {
  const scene = toml(state.tree);
  // All of them or none: a refused scene leaves those that are shown.
  const begun = names().map((name) => [name, engine.run(name, scene)]);
  runs.clear();
  for (const [name, run] of begun) runs.set(name, run);
}

function cards() {
  const place = $("verdicts");
  if (!place.children.length) for (let index = 0; index < 3; index += 1) place.append(card(index));
  [...place.children].forEach((it, index) => {
    const name = names()[index];
    const run = runs.get(name);
    const word = it.querySelector("strong");
    put(word, words[run.verdict]);
    word.className = `word ${VERDICTS[run.verdict]}`;
    const rests = run.verdict === 0 && run.settled >= 0 ? `at rest after ${run.settled.toFixed(2)} s, ` : "";
    const force = run.verdict === 2 ? "" : `at most ${digits(run.peak)} N`;
    put(it.querySelector(".told"), run.verdict === 2 ? "the run gets larger and larger" : rests + force);
    it.dataset.name = name;
  });
}

function card(index) {
  const head = made("h3", {}, title(names()[index]));
  const className = `card ${["none", "popc", "lolc"][index]}`;
  const it = made("article", { className }, head, made("strong"), made("p", { className: "told" }));
  if (index === 2) {
    const select = made("select", { id: "candidate" }, ...Object.entries(CANDIDATES).map(([name, text]) => new Option(text, name)));
    select.addEventListener("change", () => choose(select.value));
    it.append(made("label", {}, "credits ", select));
  }
  return it;
}

const choose = (candidate) => take(state.tree, { candidate, under: state.under === state.candidate ? candidate : state.under });

// The frame.

let [stage, loops, place, last, cost, placed] = [null, null, () => {}, 0, 0, 0];

function frame(now) {
  requestAnimationFrame(frame);
  const began = performance.now();
  loops.forward(Math.min(0.1, (now - last) / 1e3));
  last = now;
  // Often enough for whoever listens while the hand leads by itself.
  if (!loops.touched && now - placed > 500) {
    placed = now;
    place();
  }
  stage.draw(loops.hand, names().map((name, index) => ({ name: title(name), ...line(index), ...loops.seen(index) })));
  if (state.look === "live") {
    const series = loops.lanes.map(({ rows }, index) => ({ rows, columns: LIVE, tame: loops.tame(index), ...line(index) }));
    draw($("curves"), series, loops.since - SEEN, loops.since);
  } else if (state.stale) {
    const series = [...runs.values()].map(({ rows, verdict }, index) => ({ rows, columns: RUN, tame: verdict < 2, ...line(index) }));
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

let [show, family, map, questions] = [() => {}, null, null, null];

const TIP = "Drag, or use the arrow keys.";
/** Keeps the scene, and what is shown of it, in the address. */
function keep() {
  const { tree, candidate, under, look } = state;
  if (!wanted) history.replaceState(null, "", `#${address({ ...tree, page: { candidate, under, look } })}`);
}

const NO_LINES = "There are lines for a wall on a line that answers on every tick, for plain differences, held work and a plain ledger.";

/** Whether the lines that can be copied make the loop of a scene with all its defaults. */
function hasLines({ environment, environment_rate: rate, servo_rate: own, effects, velocity, space, stabilizer }) {
  const [it] = Object.values(stabilizer ?? {});
  const isPlain = !space && !velocity && !effects?.filter && (rate ?? own) === own;
  return environment?.wall && isPlain && (!it || it.work === "held" && it.ledger === "plain");
}

/** Takes away what was copied or observed before. */
function clear() {
  $("code").hidden = true;
  $("done").textContent = "";
}

/** Takes the state to all parts of the page; tells whether its scene runs. */
function update() {
  try {
    rerun();
    $("fault").textContent = "";
    wanted = null;
  } catch (error) {
    $("fault").textContent = error.message;
    return false;
  }
  const scene = toml(state.tree);
  const held = loops.take(names().map((name) => `${name}\n${scene}`), state.tree);
  Object.assign(stage, { surface: loops.surface, hasWall: loops.hasWall });
  $("show-live").disabled = !held;
  $("tip").textContent = held ? TIP : `${loops.refused}. Below are its runs from the start.`;
  $("tip").hidden = held && loops.touched;
  $("wall").parentElement.classList.toggle("pale", !held);
  $("wall").setAttribute("aria-disabled", String(!held));
  if (!held) look("run");
  cards();
  place();
  $("candidate").value = state.candidate;
  clear();
  show(state.tree);
  state.stale = true;
  const isTold = hasLines(shown());
  for (const it of $("lines").children) {
    it.disabled = !isTold;
    it.title = isTold ? "" : NO_LINES;
  }
  for (const it of $("why-of").children) {
    const name = names()[it.dataset.index];
    it.setAttribute("aria-pressed", String(name === state.under));
  }
  questions.soon();
  if (!framed()) {
    questions.ask("explain", { scene, name: state.under });
    const { operator, initial } = state.tree;
    // In a space these are lists: there the runs alone set the scale.
    family.begin(Math.abs((initial?.position ?? 0) - (operator?.rest ?? 0)) || 0);
    questions.ask("family", { scene });
  }
  map.show(state.tree, names(), title);
  return true;
}

/** Takes a scene; one that does not run is told and changes nothing. */
function take(tree, chosen = {}) {
  const before = { ...state };
  Object.assign(state, { tree }, chosen);
  const runs = update();
  if (runs) {
    say("");
    return true;
  }
  Object.assign(state, before);
  // What was moved goes back to what runs.
  show(state.tree);
  $("candidate").value = state.candidate;
  return false;
}

/** Says what was done, what no slider shows, and that a cap in the scene stays; `before`, the state without it, is offered back. */
function say(text, before) {
  const [name] = Object.keys(state.tree.stabilizer ?? {});
  const key = `stabilizer.${name}.damping_cap`;
  const cap = value(state.tree, key);
  const holds = cap === undefined ? "" : `The scene holds ${toml({ damping_cap: cap }).trim()}, which stays when the delay moves.`;
  const all = [text, unseen(state.tree), holds].filter((it) => it).join(" ");
  const said = $("said");
  // Not told anew on each step of a slider.
  if (said.firstChild?.data === all && !before) return;
  said.textContent = all;
  if (!before && cap === undefined) return;
  said.append(" ", button(before ? "undo" : "take it out", () => {
    take(before?.tree ?? changed(state.tree, key, undefined), before);
    said.focus();
  }));
}

/** The loop that a scene names by its stabilizer, and the candidate; the one without where it names another than the three. */
function named({ stabilizer }) {
  const candidate = `lolc-${stabilizer?.lolc?.candidate}`;
  if (CANDIDATES[candidate]) return { candidate, under: candidate };
  return { under: stabilizer?.popc ? "popc" : "none" };
}

/** The scene of the loop that is explained, with every default. */
const shown = () => bare(JSON.parse(engine.text("read", `${state.under}\n${toml(state.tree)}`)));

/** Applies a remedy: keys of the scene; those of a stabilizer choose the loop to look at. */
function remedy(set) {
  const isNamed = Object.keys(set).some((key) => key.startsWith("stabilizer"));
  const before = { ...state };
  let tree = isNamed ? changed(state.tree, "stabilizer", undefined) : state.tree;
  for (const [key, to] of Object.entries(set)) tree = changed(tree, key, to);
  if (take(tree, isNamed ? named(tree) : {})) say(`Written: ${written(set)}.`, before);
  // The button that was pressed is about to vanish, and the focus with it: to where one reads what it did and takes it back.
  $("said").focus();
}

/** The largest force of the scene, where the loop that is explained grows without it. */
function bounding() {
  const key = "effects.saturation.force";
  const most = value(state.tree, key);
  return most && engine.run(state.under, toml(changed(state.tree, key, undefined))).verdict === 2 ? most : 0;
}

function hear({ data }) {
  if (!questions.hears(data)) return;
  if (data.kind === "family") family.hear(data);
  if (data.kind === "map") map.hear(data);
  if (data.kind !== "explain") return;
  tell({ said: $("why-said"), energies: $("energies"), remedies: $("remedies") }, data, bounding, remedy);
}

function start(preset) {
  $("said").textContent = preset.said;
  // What the page says of a figure is of the paper's own candidate.
  Object.assign(state, { tree: preset.scene, under: preset.shows ?? "none" }, preset.claims && { candidate: OWN });
  look(preset.look);
  update();
  loops.letGo();
  place();
}

/** Brings a part of the page into view; at once, since answers that come during a smooth way would move where it ends. */
const sight = (id, block) => $(id).scrollIntoView({ block });

/** Tells of a file, in view: it may have been dropped far from there. */
function done(text, isInView = true) {
  $("done").textContent = text;
  if (isInView) sight("done", "center");
}

/** Keeps a motion for the scenes that name it; tells whether that of the address is one, and is open now. */
function keepMotion(text) {
  engine.bytes("keep", text);
  worker.postMessage({ kept: text });
  if (!wanted) return false;
  share(wanted);
  if (wanted) return false;
  sight("said", "nearest");
  return true;
}

/** Shows what the observer says of a log. */
function openLog({ name, text }, left) {
  clear();
  $("code").textContent = engine.text("observed", `${name}\n${text}`);
  $("code").hidden = false;
  done(`${name} is a log: below is what the observer says of it.${left}`);
}

function openScene({ name, text }, left) {
  clear();
  const tree = bare(JSON.parse(engine.text("read", `\n${text}`)));
  const chosen = named(tree);
  if (!take(tree, chosen)) throw new Error($("fault").textContent);
  look("run");
  loops.letGo();
  const other = Object.keys(tree.stabilizer ?? {}).filter(() => chosen.under === "none");
  say(`The scene of ${name}.${other.map((it) => ` Its stabilizer, ${it}, is in the family below.`).join("")}${left}`);
  $("done").textContent = `${name} is open.${left}`;
  sight("said", "nearest");
}

/** Everything that is drawn once is drawn again where its box or its colours change. */
function redraws() {
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
}

/** The buttons of the loops, and the colours of the words. */
function choices() {
  for (const [index, name] of ["no stabilizer", "POPC", "LOLC"].entries()) {
    const it = button(name, () => {
      state.under = names()[index];
      update();
    });
    it.dataset.index = index;
    $("why-of").append(it);
  }
  for (const [index, word] of VERDICTS.entries()) {
    $("legend").append(made("li", { className: word }, words[index]));
  }
}

/** Takes the scene of an address, if it holds one. */
function share({ hash }) {
  wanted = null;
  let shared = null;
  try {
    shared = ofAddress(hash);
  } catch {
    $("fault").textContent = "The address holds no scene: it may have been cut where it was copied.";
    keep();
  }
  if (!shared) return;
  const { page, ...tree } = shared;
  const candidate = CANDIDATES[page?.candidate] ? page.candidate : state.candidate;
  const under = ["none", "popc", candidate].includes(page?.under) ? page.under : "none";
  if (!take(tree, page ? { candidate, under } : named(tree))) {
    if (/drop it here/.test($("fault").textContent)) wanted = { hash };
    return keep();
  }
  say("The scene of this address.");
  loops.letGo();
  if (page?.look === "run" || page?.look === "live" && loops.held) look(page.look);
}

/** Whether the page stands inside another, as in the book: there it shows the loops and their setting, and nothing else. */
const framed = () => self !== top;

async function begin(module, source) {
  document.documentElement.classList.toggle("framed", framed());
  engine = await Engine.of(module);
  words = engine.lines("verdicts");
  stage = new Stage($("wall"));
  loops = new Loops(engine);
  worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
  worker.addEventListener("message", hear);
  worker.postMessage({ module });
  family = new Family($("members"), words);
  questions = new Questions($, (it) => worker.postMessage(it), keep);
  open = opener({ keep: keepMotion, scene: openScene, log: openLog, done });
  choices();
  const [x, y, under, said] = ["x", "y", "under", "said"].map((it) => $(`map-${it}`));
  map = new StabilityMap({ canvas: $("map"), x, y, under, said, legend: $("legend") }, questions, (moves) =>
    take(moves.reduce((tree, [slider, number]) => moved(tree, slider, number), state.tree)));
  show = fill($("sliders"), (slider, number) => take(moved(state.tree, slider, number)));
  $("alone").addEventListener("click", () => ($("alone").firstChild.href = location.href));
  for (const at of ["live", "run"]) $(`show-${at}`).addEventListener("click", () => keep(look(at)));
  list({ buttons: $("presets"), claims: $("claims") }, start, () => $("stage").scrollIntoView({ behavior: isCalm() ? "auto" : "smooth" }));
  place = hands({ canvas: $("wall"), tip: $("tip"), again: $("again") }, stage, loops);
  wire({ $, engine, now: () => ({ tree: shown(), name: state.under, title: title(state.under) }), open });
  start(PRESETS[0]);
  share(location);
  // Its own address: that of the page may hold the last scene again by now.
  addEventListener("hashchange", ({ newURL }) => share(new URL(newURL)));
  redraws();
  requestAnimationFrame((now) => {
    last = now;
    frame(now);
  });
  document.documentElement.dataset.ready = "yes";
  // What tests ask: the engine that everything above uses, and what it is asked about.
  globalThis.lyapunov = { engine, state, loops, map, scene: () => toml(state.tree), cost: () => cost };
}

if (globalThis.document === undefined) work();
else {
  const source = $("program").textContent;
  inside($("rust").textContent).then((module) => begin(module, source)).catch((error) => {
    $("fault").textContent = `This browser cannot run the page: ${error.message}`;
  });
}
