// Curves that are zoomed, read at the cursor and switched on and off. Without this script, and on paper, the drawing
// stands. uPlot gives axes, zoom and cursor; the traces are ours, since its own want one abscissa for all curves.

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const FONT = "12px system-ui, sans-serif";

// A curve as it is read: its finite points, and whether it is one ordinate for each abscissa.
function readable(curve, data) {
  const xs = data.x[curve.x];
  const points = xs.map((x, index) => [x, curve.y[index]]).filter(([x, y]) => x !== null && y !== null);
  const sorted = points.every(([x], index) => index === 0 || points[index - 1][0] <= x);
  const isLine = curve.trace === "line" || curve.trace === "steps";
  return { ...curve, xs, points, isFunction: sorted && isLine, shown: true };
}

// Black would vanish in the dark.
const ink = (colour) => (colour === "#000000" ? css("--ink") : colour);

// The path of a curve in the pixels of the canvas.
function traced(u, { trace, xs, y }) {
  const path = new Path2D();
  const pixel = (value, scale) => Math.max(-1e5, Math.min(1e5, u.valToPos(value, scale, true)));
  let last = null;
  for (let index = 0; index < xs.length; index += 1) {
    if (xs[index] === null || y[index] === null) {
      last = null;
      continue;
    }
    const place = [pixel(xs[index], "x"), pixel(y[index], "y")];
    const isAlone = last === null && (index + 1 === xs.length || y[index + 1] === null);
    if (trace === "dots" || isAlone) {
      path.moveTo(place[0] - 0.01, place[1]);
      path.lineTo(place[0] + 0.01, place[1]);
    } else if (last === null) {
      path.moveTo(...place);
    } else {
      if (trace === "steps") path.lineTo(place[0], last[1]);
      path.lineTo(...place);
    }
    last = place;
  }
  return { stroke: path, fill: null, clip: null, band: null, gaps: null, flags: 0 };
}

// A power of ten: whole ones as such.
function power(exponent) {
  const digits = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
  const raised = (letter) => (letter === "-" ? "\u207b" : digits[Number(letter)]);
  if (Math.abs(exponent - Math.round(exponent)) > 1e-9) return told(10 ** exponent, 4);
  return `10${[...String(Math.round(exponent))].map(raised).join("")}`;
}

// Exponents of round numbers between two exponents, about `most` at most.
function decades(min, max, most) {
  const width = max - min;
  const within = (exponents) => exponents.filter((it) => it >= min - 1e-9 && it <= max + 1e-9);
  const whole = Array.from({ length: Math.ceil(Math.min(width, 700)) + 2 }, (_, index) => Math.floor(min) + index);
  const step = Math.ceil((width + 1) / Math.min(most, 9));
  if (width > 3 || (width > 0.6 && 3 * width > most)) return within(whole.filter((it) => it % step === 0));
  if (width > 0.6) return within(whole.flatMap((it) => [1, 2, 5].map((part) => it + Math.log10(part))));
  const [low, high] = [10 ** min, 10 ** max];
  const power = 10 ** Math.floor(Math.log10((high - low) / 5));
  const even = power * [1, 2, 5, 10].find((part) => (high - low) / (part * power) <= Math.min(most, 6)) ?? 10 * power;
  const first = Math.ceil(low / even);
  return Array.from({ length: 8 }, (_, index) => Math.log10((first + index) * even)).filter((it) => it <= max);
}

// The room that uPlot gives the name of an axis.
const NAME = 20;

// An axis with its name, its numbers or the names of its rows; `roomOf` tells the room of an ordinate from what it needs.
function axis(panel, key, roomOf) {
  const isLog = panel[`${key}Log`];
  const rows = key === "y" ? panel.rows : undefined;
  const written = (value) => (isLog ? power(value) : told(value, 10));
  const measured = (u, texts) => {
    u.ctx.save();
    u.ctx.font = FONT;
    const widest = Math.max(0, ...(texts ?? []).map((text) => u.ctx.measureText(text).width));
    u.ctx.restore();
    // Without a name its room is there for numbers and rows.
    const more = panel.y ? 0 : NAME;
    return roomOf(Math.min(widest + 16, 0.45 * u.width) - more) + more;
  };
  const made = {
    stroke: () => css("--ink"),
    font: FONT,
    labelFont: FONT,
    labelSize: NAME,
    grid: { stroke: () => css("--line"), width: 1 },
    ticks: { stroke: () => css("--line"), width: 1, size: 4 },
    values: (u, splits) => splits.map(written),
  };
  if (panel[key]) made.label = panel[key];
  if (isLog) {
    const room = (u) => (key === "x" ? (u.width - 80) / 60 : (u.height - 50) / 26);
    made.splits = (u, index, min, max) => decades(min, max, Math.max(2, room(u)));
  }
  if (key === "x") return { ...made, size: 28, space: 56 };
  if (rows) {
    made.splits = () => rows.map((_, index) => -index);
    made.values = (u) => rows.map((row) => fitted(u, row));
  }
  return { ...made, space: 24, size: measured };
}

// A name, cut to the room that rows have.
function fitted(u, text) {
  u.ctx.save();
  u.ctx.font = FONT;
  let kept = text;
  while (kept.length > 3 && u.ctx.measureText(kept).width > 0.4 * u.width) kept = kept.slice(0, -1);
  u.ctx.restore();
  return kept === text ? text : `${kept.slice(0, -1)}\u2026`;
}

// Guides, dashed; or their names at an edge, which stand above the `curves` and cover few of their points.
function drawGuides(u, guides, curves) {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = css("--soft");
  ctx.lineWidth = ratio;
  ctx.font = FONT.replace("12", String(11 * ratio));
  ctx.textBaseline = "alphabetic";
  let above = 0;
  for (const [way, at, label] of guides) {
    const place = u.valToPos(at, way === "h" ? "y" : "x", true);
    const [from, length] = way === "h" ? [bbox.top, bbox.height] : [bbox.left, bbox.width];
    if (!(place >= from && place <= from + length)) continue;
    if (curves) {
      const right = bbox.left + bbox.width - 4 * ratio;
      const start = Math.min(place + 4 * ratio, right - ctx.measureText(label).width);
      ctx.textAlign = "left";
      // Names of upright guides stand below each other.
      if (way === "v") above += 13 * ratio;
      const corner = way === "h" ? besideLevel(u, place, label, curves) : [Math.max(start, bbox.left), bbox.top + above];
      ctx.strokeStyle = css("--paper");
      ctx.lineWidth = 3 * ratio;
      ctx.lineJoin = "round";
      ctx.strokeText(label, ...corner);
      ctx.fillText(label, ...corner);
      continue;
    }
    ctx.setLineDash([5 * ratio, 3 * ratio]);
    ctx.beginPath();
    ctx.moveTo(...(way === "h" ? [bbox.left, place] : [place, bbox.top]));
    ctx.lineTo(...(way === "h" ? [bbox.left + bbox.width, place] : [place, bbox.top + bbox.height]));
    ctx.stroke();
  }
  ctx.restore();
}

// The left end of a name's line above or below a level, at the right or the left edge: where it covers fewest points.
function besideLevel(u, level, label, curves) {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  const width = ctx.measureText(label).width;
  const edges = [bbox.left + bbox.width - width - 4 * ratio, bbox.left + 4 * ratio];
  const lines = [level - 4 * ratio, level + 12 * ratio];
  const isWithin = (line) => line - 9 * ratio >= bbox.top && line + 2 * ratio <= bbox.top + bbox.height;
  const kept = lines.some(isWithin) ? lines.filter(isWithin) : lines;
  const places = kept.flatMap((line) => edges.map((left) => [left, line]));
  const shown = curves.filter((curve) => curve.shown).flatMap((curve) => curve.points);
  const points = shown.map(([x, y]) => [u.valToPos(x, "x", true), u.valToPos(y, "y", true)]);
  const covered = ([left, line]) =>
    points.filter(([x, y]) => x >= left && x <= left + width && y <= line + 2 * ratio && y >= line - 11 * ratio).length;
  return places.reduce((best, place) => (covered(place) < covered(best) ? place : best));
}

// The point of a curve that is nearest to the cursor: along the abscissa if the curve is a function of it.
function nearest(u, curve, x, [left, top]) {
  const { points } = curve;
  const height = (point) => Math.abs(u.valToPos(point[1], "y") - top);
  if (points.length === 0) return null;
  if (curve.isFunction) {
    let [low, high] = [0, points.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (points[middle][0] < x) low = middle + 1;
      else high = middle;
    }
    let best = points[Math.min(low, points.length - 1)];
    if (low > 0 && x - points[low - 1][0] < Math.abs(best[0] - x)) best = points[low - 1];
    // Where the curve jumps, several points stand above each other.
    for (let index = low; index < points.length && points[index][0] === best[0]; index += 1) {
      if (height(points[index]) < height(best)) best = points[index];
    }
    return Math.abs(u.valToPos(best[0], "x") - u.valToPos(x, "x")) < 24 ? best : null;
  }
  const away = (point) => Math.hypot(u.valToPos(point[0], "x") - left, height(point));
  return points.reduce((best, point) => (away(point) < away(best) ? point : best));
}

// The bar of a curve in the row of the cursor: its length, and where it ends.
function barAt(curve, x, y) {
  let best = null;
  for (let index = 0; index + 1 < curve.points.length; index += 2) {
    const [[start, row], [end]] = [curve.points[index], curve.points[index + 1]];
    const isNearer = best === null || Math.abs(row - y) < Math.abs(best.row - y);
    if (Math.round(row) === Math.round(y) && isNearer) best = { row, end, length: end - start };
  }
  return best;
}
