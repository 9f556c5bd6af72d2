// The three loops under the hand.

import { LIVE } from "./engine.js";
import { isCalm } from "./paint.js";

/** Where the hand rests, and how far it moves until someone takes it, m. */
export const REST = -0.006;
const LED = 0.009;
/** Beyond this place a loop has run away, m; it begins anew after a while, s. */
const FAR = 0.15;
const GONE = 1.2;
/** Length of the curves, s, and of what is felt. */
export const SEEN = 3;
const FELT = 0.12;
const MOST = 4000;
/** Groups of rows a second, at most. */
const FINE = 500;

export class Loops {
  constructor(engine) {
    this.engine = engine;
    this.lanes = [0, 1, 2].map(() => ({ rows: new Float64Array(0), fled: 0, gone: 0 }));
    Object.assign(this, { surface: 0, hasWall: true, hand: REST, before: REST, touched: false, led: 0, since: 0, carried: 0 });
  }

  /** Takes the scenes of the loops, as texts of a tree under their stabilizers; the loops go on where they are. False: one cannot be
   *  held, for the reason in `refused`. */
  take(scenes, tree) {
    const [kind, about] = Object.entries(tree.environment ?? {})[0] ?? [""];
    const surface = about?.position ?? 0;
    const moved = surface - this.surface;
    Object.assign(this, { scenes, rate: tree.servo_rate, hasWall: /wall|hunt/.test(kind), surface, hand: this.hand + moved, before: this.before + moved });
    try {
      this.lanes.forEach((lane, index) => {
        const place = lane.rows[lane.rows.length - LIVE.width + LIVE.x];
        this.grasp(index, this.isNear(place) ? place : this.hand);
        Object.assign(lane, { fled: 0, gone: 0 });
      });
      this.held = true;
    } catch (error) {
      Object.assign(this, { held: false, refused: error.message });
    }
    return this.held;
  }

  /** Whether a place is so near the surface that its loop has not run away. */
  isNear(place) {
    return Math.abs(place - this.surface) < FAR;
  }

  /** Puts a loop at `place`, at standstill: not inside the wall, where the first tick would throw it out. */
  grasp(index, place = this.hand) {
    this.engine.bytes("hold", this.scenes[index], index, Math.min(place, this.surface - 1e-4));
  }

  /** Puts all loops where the hand is, and the hand where it rests. */
  letGo() {
    const rest = this.surface + REST;
    Object.assign(this, { hand: rest, before: rest, since: 0 });
    this.lanes.forEach((lane, index) => {
      Object.assign(lane, { rows: new Float64Array(0), fled: 0, gone: 0 });
      if (this.held) this.grasp(index);
    });
  }

  /** Ticks whose rows are thinned to two: a picture of three seconds has fewer columns. */
  get group() {
    return Math.max(2, Math.floor(this.rate / FINE));
  }

  /** Moves the hand to a place, m. */
  reach(to) {
    this.hand = this.surface + Math.max(-0.02, Math.min(0.02, to - this.surface));
    this.touched = true;
  }

  /** Lets some seconds pass. */
  forward(seconds) {
    const exact = seconds * this.rate + this.carried;
    const ticks = Math.min(Math.floor(exact), MOST);
    this.carried = exact - Math.floor(exact);
    if (!ticks || !this.held) return;
    if (!this.touched) this.lead(seconds);
    const began = this.since;
    this.since += ticks / this.rate;
    this.lanes.forEach((lane, index) => {
      if (lane.gone > 0) {
        lane.gone -= seconds;
        if (lane.gone <= 0) this.grasp(index);
        return;
      }
      const rows = this.engine.numbers("advance", "", index, ticks, this.before, this.hand);
      for (let at = 0; at < rows.length; at += LIVE.width) rows[at] = began + at / LIVE.width / this.rate;
      const place = rows[rows.length - LIVE.width + LIVE.x];
      if (!this.isNear(place)) Object.assign(lane, { gone: GONE, fled: lane.fled + 1 });
      lane.rows = joined(lane.rows, thinned(rows, this.group), this.since - SEEN);
    });
    this.before = this.hand;
  }

  /** Until someone takes the hand it presses and lets go by itself. */
  lead(seconds) {
    if (isCalm()) return;
    this.led += seconds;
    this.hand = this.surface + REST + 0.5 * LED * (1 - Math.cos((2 * Math.PI * this.led) / 4));
  }

  /** What is seen of a loop now: its place, the way and the largest force of late. */
  seen(index) {
    const { rows, gone, fled } = this.lanes[index];
    const from = Math.max(0, rows.length - LIVE.width * Math.ceil((2 * FELT * this.rate) / this.group));
    let [low, high, peak] = [Infinity, -Infinity, 0];
    for (let at = from; at < rows.length; at += LIVE.width) {
      low = Math.min(low, rows[at + LIVE.x]);
      high = Math.max(high, rows[at + LIVE.x]);
      if (Math.abs(rows[at + LIVE.force]) > Math.abs(peak)) peak = rows[at + LIVE.force];
    }
    const end = rows.length - LIVE.width;
    const last = end >= 0 ? rows[end + LIVE.x] : this.hand;
    const place = Number.isFinite(last) ? last : this.surface + FAR;
    const note = gone > 0 ? "ran away" : fled ? `ran away ${fled}×` : "";
    return { place, range: low <= high ? [low, high] : [place, place], force: end >= 0 ? rows[end + LIVE.force] : 0, peak, note };
  }

  /** Whether a loop has not run away, so that its curves set the scale. */
  tame(index) {
    const { gone, fled } = this.lanes[index];
    return !(gone > 0) && !fled;
  }
}

/** The rows from a time on, in two pieces put together. */
function joined(before, after, from) {
  let first = 0;
  while (first < before.length && before[first] < from) first += LIVE.width;
  const all = new Float64Array(before.length - first + after.length);
  all.set(before.subarray(first));
  all.set(after, before.length - first);
  return all;
}

/** Of each `group` rows the least and the largest of every column, so that no peak is lost. */
export function thinned(rows, group) {
  const { width } = LIVE;
  const many = rows.length / width;
  if (group <= 2) return rows;
  const kept = new Float64Array(2 * width * Math.ceil(many / group));
  for (let row = 0; row < many; row += 1) {
    const low = 2 * width * Math.floor(row / group);
    for (let column = 0; column < width; column += 1) {
      const number = rows[row * width + column];
      if (row % group === 0) kept[low + column] = kept[low + width + column] = number;
      else if (number < kept[low + column]) kept[low + column] = number;
      else if (number > kept[low + width + column]) kept[low + width + column] = number;
    }
  }
  return kept;
}
