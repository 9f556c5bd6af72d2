// The explanation of a run: its sentence, its energies, its remedies as buttons.

import { button, made } from "./made.js";
import { SLIDERS } from "./sliders.js";

const cell = (row, text, tag = "td") => {
  const it = made(tag, {}, text);
  row.append(it);
  return it;
};

export const digits = (number) => (number === 0 ? "0" : Math.abs(number) >= 1e5 || Math.abs(number) < 1e-3 ? number.toExponential(1) : String(Number(number.toPrecision(3)))).replaceAll("-", "−");

/** The keys of a remedy with their values. */
export const written = (set) => Object.entries(set).map(([key, it]) => `${key} = ${it}${unit(key)}`).join(", ");

/** The unit of a number in a scene, where a slider has it and does not show the number in another. */
function unit(key) {
  const { scale = 1, whole, unit } = SLIDERS.find((it) => it.key === key) ?? { whole: true };
  return whole || scale !== 1 ? "" : ` ${unit}`;
}

const said = (text) => `${text.replace(/^./, (first) => first.toUpperCase())}.`;

/** What holds a run whose loop is not stable; `bounding` tells the largest force, where the run grows without it. */
function but({ first_contact: first, whole_run: whole }, bounding) {
  const most = bounding();
  const alone = !first || first.to_s < whole.to_s ? "this run does not stay in contact" : "yet this run does not grow";
  return most ? `the largest force of ${digits(most)} N bounds it` : whole.controller ? "the stabilizer holds it" : alone;
}

/** The sentence on a run, where the hint of the command has none. */
function sentence(hint, told, bounding) {
  if (hint) return said(hint);
  const { verdict, spectral_radius: radius } = told;
  const end = radius < 1 || verdict === "too short" ? "" : `; ${but(told, bounding)}`;
  const linear = radius === null ? "" : ` The loop alone is ${radius < 1 ? "" : "not "}stable in contact${end}.`;
  return { settles: "It comes to rest.", swinging: "It stays bounded and does not come to rest.", "too short": "The run is too short to judge." }[verdict] + linear;
}

export function tell(parts, { name, sentence: hint, rows, told, refused }, bounding, take) {
  if (refused) {
    for (const it of Object.values(parts)) it.replaceChildren();
    parts.said.textContent = refused;
    return;
  }
  parts.said.textContent = sentence(hint, told, bounding);
  const { first_contact: first, whole_run: whole } = told;
  const table = parts.energies;
  table.replaceChildren();
  if (first) {
    const head = table.createTHead().insertRow();
    const seconds = (it) => `${digits(it.from_s)} to ${digits(it.to_s)} s`;
    for (const text of ["energy, mJ", `first contact, ${seconds(first)}`, `whole run, ${seconds(whole)}`]) cell(head, text, "th").scope = "col";
    const body = table.createTBody();
    for (const [name, ...energies] of rows) {
      const row = body.insertRow();
      cell(row, name, "th").scope = "row";
      for (const it of energies) cell(row, digits(1e3 * it));
    }
  } else {
    cell(table.createTBody().insertRow(), "The wall is never touched.");
  }
  remedies(parts.remedies, { name, told, hint }, take);
}

function remedies(place, { name, told, hint }, take) {
  place.replaceChildren();
  const note = made("p");
  place.append(note);
  const lack = told.no_remedies;
  if (lack) {
    note.textContent = lack === hint ? "No change of the loop was tried." : said(lack);
    return;
  }
  const settle = told.verdict === "swinging" && told.remedies.every((it) => it.verdict === "settles");
  note.textContent = `Each by itself${name === "none" ? "" : " and without a stabilizer"}; all were run, and ${settle ? "all settle" : "none grows"}.`;
  for (const { set, verdict, peak_force_n: peak, force_error_rms_n: error } of told.remedies) {
    const late = set.servo_rate && told.groups.delay_ticks;
    // Without a wall or a solid there is no force error.
    const off = error === null ? "" : `, off the environment's own force by ${digits(error)} N (rms)`;
    // A word on a motion that is free of the wall says nothing about the remedy.
    const felt = peak ? `${verdict}: peak force ${digits(peak)} N${off}` : "no force acts: the wall is not touched any more";
    const what = `${felt}${late ? `; its delay is then ${digits((1e3 * late) / set.servo_rate)} ms, as many ticks as before` : ""}`;
    const it = Object.assign(button("", () => take(set)), { className: "remedy" });
    it.append(made("b", {}, written(set)), made("span", {}, what));
    place.append(it);
  }
  if (told.remedies.some(({ set }) => /\.damping_cap/.test(written(set)))) {
    place.append(made("p", {}, "A damping_cap here is the first that holds, not the best: see lyapunov tune."));
  }
}
