// Position, force and observed energy over time, a colour for each loop.

import { font, ink, path, sheet } from "./paint.js";

const PLOTS = [
  { title: "position, mm", of: "x", times: 1e3, least: 1 },
  { title: "force on the device, N", of: "force", times: 1, least: 0.5 },
  { title: "observed energy, mJ", of: "energy", times: 1e3, least: 0.05 },
];
const [LEFT, GAP, TOP, FOOT] = [46, 14, 18, 20];
/** Pixels of a curve in which dashes go on without a break. */
const PIECE = 84;

/** A step of 1, 2 or 5 that divides a range into few parts. */
function step(range, parts) {
  const raw = range / parts;
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((it) => it * power >= raw);
}

/** A number as short as its step allows. */
const short = (number, by) => (Math.abs(number) >= 1e5 ? number.toExponential(0).replace("e+", "e") : number.toFixed(Math.max(0, -Math.floor(Math.log10(by) + 1e-9)))).replace("-", "−");

/** The range that holds nearly all values: a run that grows must not flatten the others, so the widest bounded loop decides. */
export function range(series, of, times, least) {
  const spans = series.map(({ rows, columns, tame }) => {
    let [low, high] = [0, 0];
    for (let at = columns[of]; at < rows.length; at += columns.width) {
      const number = rows[at] * times;
      if (number < low) low = number;
      if (number > high) high = number;
    }
    return { low, high, tame };
  });
  const tame = spans.filter((it) => it.tame);
  const chosen = tame.length ? tame : spans;
  const low = Math.min(...chosen.map((it) => it.low), -least * 0.1);
  const high = Math.max(...chosen.map((it) => it.high), least);
  const wide = high - low;
  const most = Math.min(high + 0.6 * wide, Math.max(...spans.map((it) => it.high), high));
  const fewest = Math.max(low - 0.6 * wide, Math.min(...spans.map((it) => it.low), low));
  const room = 0.08 * (most - fewest);
  return [fewest - room, most + room];
}

/** Draws series over the time from `from` to `to`. */
export function draw(canvas, series, from, to) {
  const { context: c, width, height } = sheet(canvas);
  const colours = ink();
  const tall = (height - FOOT - GAP * PLOTS.length) / PLOTS.length;
  const x = (t) => LEFT + ((t - from) / (to - from)) * (width - LEFT - 8);
  PLOTS.forEach(({ title, of, times, least }, index) => {
    const top = index * (tall + GAP) + TOP;
    const base = top + tall - TOP + GAP - 4;
    const [low, high] = range(series, of, times, least);
    const y = (number) => base - ((number - low) / (high - low)) * (base - top);
    font(c, 11);
    const few = step(high - low, 4);
    const by = Math.floor(high / few) - Math.ceil(low / few) > 1 ? few : step(high - low, 8);
    c.textAlign = "right";
    for (let mark = Math.ceil(low / by) * by; mark <= high; mark += by) {
      const nil = Math.abs(mark) < by / 1e3;
      path(c, [[LEFT, y(mark)], [width - 8, y(mark)]], colours.line, nil ? 1.4 : 0.6);
      c.fillStyle = colours.soft;
      c.fillText(short(nil ? 0 : mark, by), LEFT - 6, y(mark) + 4);
    }
    c.textAlign = "left";
    font(c, 12, 600);
    c.fillStyle = colours.ink;
    c.fillText(title, LEFT, top - 5);
    c.save();
    c.beginPath();
    c.rect(LEFT, top, width - LEFT - 8, base - top);
    c.clip();
    for (const one of series) curve(c, one, of, times, x, y, width);
    c.restore();
  });
  font(c, 11);
  c.fillStyle = colours.soft;
  c.textAlign = "center";
  const by = step(to - from, width < 420 ? 4 : 8);
  for (let mark = Math.ceil(from / by - 1e-9) * by; mark <= to + 1e-9; mark += by) c.fillText(`${short(mark, by)} s`, Math.min(x(mark), width - 18), height - 5);
}

/** One curve: for each column of pixels the lowest and the highest value, so that no peak is lost. */
function curve(c, { rows, columns, colour, dash }, of, times, x, y, width) {
  c.beginPath();
  const pixels = x(1) - x(0);
  let [column, low, high, last, piece] = [null, 0, 0, 0, 0];
  const flush = () => {
    if (column === null) return;
    c.lineTo(column, low);
    if (high !== low) c.lineTo(column, high);
    c.lineTo(column, last);
  };
  const most = 1e5;
  for (let at = 0; at < rows.length; at += columns.width) {
    const time = rows[at];
    const place = Math.round(x(time));
    const value = Math.max(-most, Math.min(most, y(rows[at + columns[of]] * times)));
    if (place < -2 || place > width + 2) continue;
    if (place !== column) {
      flush();
      // Dashes begin anew at times that stay where they are while the picture moves: so they move with it.
      const now = Math.floor((time * pixels) / PIECE);
      if (dash.length && now !== piece && column !== null) c.moveTo(column, last);
      piece = now;
      [column, low, high] = [place, value, value];
    } else {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    last = value;
  }
  flush();
  c.setLineDash(dash);
  c.strokeStyle = colour;
  c.lineWidth = 1.6;
  // Round joins and ends take as long as all else in a frame, and are not seen at this width.
  c.lineJoin = "bevel";
  c.lineCap = "butt";
  c.stroke();
  c.setLineDash([]);
}
