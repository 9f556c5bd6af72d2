// All stabilizers that fit a setting, each with a small picture of its run.

import { RUN } from "./engine.js";
import { made } from "./made.js";
import { VERDICTS, ink, path, sheet } from "./paint.js";
import { digits } from "./why.js";

/** Points of a small picture, at least. */
const POINTS = 400;

export class Family {
  constructor(table, words) {
    Object.assign(this, { table, words });
    this.begin();
  }

  /** Expects the runs of a scene; `start`: how far it begins from its rest, m. */
  begin(start = 0) {
    this.start = start;
    this.runs = [];
    this.fresh = true;
  }

  hear({ run, ends, refused }) {
    if (refused) this.table.replaceChildren();
    if (refused || ends) return;
    if (this.fresh) {
      const names = ["stabilizer", "verdict", "rests after", "largest force", "position"];
      const head = made("tr", {}, ...names.map((name) => made("th", { scope: "col" }, name)));
      this.table.replaceChildren(made("thead", {}, head), made("tbody"));
      this.fresh = false;
    }
    this.row(run);
  }

  row(run) {
    const row = this.table.tBodies[0].insertRow();
    row.append(made("th", { scope: "row" }, run.name));
    if (run.refused) {
      const it = row.insertCell();
      Object.assign(it, { colSpan: 4, textContent: run.refused.split("\n")[0] });
      return;
    }
    row.insertCell().append(made("b", { className: `word ${VERDICTS[run.verdict]}` }, this.words[run.verdict]));
    row.insertCell().textContent = Number.isNaN(run.settled) || run.verdict > 0 ? "–" : `${run.settled.toFixed(2)} s`;
    row.insertCell().textContent = run.verdict === 2 ? "–" : `${digits(run.peak)} N`;
    const canvas = made("canvas", { className: "spark", ariaHidden: "true" });
    row.insertCell().append(canvas);
    const most = Math.max(this.start, run.widest, 1e-6);
    this.runs.push([canvas, run, most]);
    spark(canvas, run, most);
  }

  draw() {
    for (const it of this.runs) spark(...it);
  }
}

/** What a row of the table shows of a run: not the rows of all ticks, which fill the memory where a run is long. */
export function pictured({ name, verdict, settled, peak, rows }) {
  const many = rows.length / RUN.width;
  const place = (row) => rows[row * RUN.width + RUN.x];
  // What grows is out of any picture that holds all of it: there its beginning sets the scale.
  let widest = 0;
  for (let row = 0; row < (verdict === 2 ? Math.min(many, 40) : many); row += 1) widest = Math.max(widest, Math.abs(place(row)));
  const by = Math.max(1, Math.floor(many / POINTS));
  const places = Float64Array.from({ length: Math.ceil(many / by) }, (_, index) => place(index * by));
  return { name, verdict, settled, peak, widest, places };
}

function spark(canvas, { places, verdict }, most) {
  const { context, width, height } = sheet(canvas);
  const colours = ink();
  const y = (place) => height / 2 - Math.max(-1.2, Math.min(1.2, place / most)) * height * 0.4;
  const points = Array.from(places, (place, index) => [(index / places.length) * width, y(place)]);
  path(context, [[0, height / 2], [width, height / 2]], colours.line, 1);
  path(context, points, colours[VERDICTS[verdict]], 1.2);
}
