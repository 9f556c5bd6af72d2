// All stabilizers that fit a setting, each with a small picture of its run.

import { RUN } from "./engine.js";
import { made } from "./made.js";
import { VERDICTS, ink, path, sheet } from "./paint.js";
import { digits } from "./why.js";

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
    // What grows is out of any picture that holds all of it: there its beginning sets the scale.
    const most = Math.max(this.start, widest(run, run.verdict === 2 ? 40 : Infinity), 1e-6);
    this.runs.push([canvas, run, most]);
    spark(canvas, run, most);
  }

  draw() {
    for (const it of this.runs) spark(...it);
  }
}

/** The largest |x| of the first `count` rows. */
function widest({ rows }, count) {
  let most = 0;
  for (let at = RUN.x; at < Math.min(rows.length, count * RUN.width); at += RUN.width) most = Math.max(most, Math.abs(rows[at]));
  return most;
}

function spark(canvas, { rows, verdict }, most) {
  const { context, width, height } = sheet(canvas);
  const colours = ink();
  const many = rows.length / RUN.width;
  const points = [];
  const by = Math.max(1, Math.floor(many / 400));
  for (let at = 0; at < many; at += by) {
    const y = rows[at * RUN.width + RUN.x] / most;
    points.push([(at / many) * width, height / 2 - Math.max(-1.2, Math.min(1.2, y)) * height * 0.4]);
  }
  path(context, [[0, height / 2], [width, height / 2]], colours.line, 1);
  path(context, points, colours[VERDICTS[verdict]], 1.2);
}
