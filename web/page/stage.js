// The hand on the wall, as one would sketch it: a lane for each loop.

import { font, ink, path, sheet } from "./paint.js";

/** Millimetres from the left edge to the surface, and across. */
const LEFT = 30;
const ACROSS = 50;
const [BLOCK, REACH, FLAT] = [30, 74, 22];
/** Where the name of a lane begins, behind a piece of its curve. */
const LABEL = 46;

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.surface = 0;
  }

  get scale() {
    return this.canvas.clientWidth / ACROSS;
  }

  /** Pixels of a place in m. */
  at(place) {
    return (LEFT + (place - this.surface) * 1e3) * this.scale;
  }

  /** The place in m, relative to the hand, that a way of pixels is. */
  way(pixels) {
    return pixels / this.scale / 1e3;
  }

  /** Draws the lanes; each has a name, a colour, a place, a force, the largest force of late, and perhaps a note. */
  draw(hand, lanes) {
    const { context: c, width, height } = sheet(this.canvas);
    const colours = ink();
    const tall = height / lanes.length;
    const surface = this.at(this.surface);
    if (this.hasWall) {
      c.fillStyle = colours.wall;
      c.fillRect(surface, 0, width - surface, height);
      hatch(c, surface, width, height, colours.line);
      path(c, [[surface, 0], [surface, height]], colours.ink, 2);
    }
    lanes.forEach((lane, index) => {
      const middle = (index + 0.56) * tall;
      if (index) path(c, [[0, index * tall], [width, index * tall]], colours.line, 1);
      this.lane(c, lane, hand, middle, Math.min(44, tall * 0.46), tall);
    });
  }

  lane(c, lane, hand, middle, size, tall) {
    const colours = ink();
    const front = Math.max(-20, Math.min(this.canvas.clientWidth + 60, this.at(lane.place)));
    const apart = this.at(lane.place) - this.at(hand) + REACH;
    // A spring is pressed flat and no further.
    const grip = front - BLOCK - (apart > 2 * FLAT ? apart : FLAT + FLAT * Math.exp(apart / FLAT - 2));
    font(c, 13, 600);
    c.fillStyle = lane.colour;
    c.textAlign = "left";
    const label = middle - tall * 0.34;
    path(c, [[12, label - 4], [38, label - 4]], lane.colour, 2.5, lane.dash);
    c.fillText(lane.name, LABEL, label);
    if (lane.note) {
      font(c, 12);
      c.fillStyle = colours.grows;
      c.fillText(lane.note, LABEL + c.measureText(lane.name).width + 22, label);
    }
    spring(c, grip + 13, front - BLOCK, middle, colours.ink);
    c.globalAlpha = 0.16;
    blur(c, this, lane, middle, size);
    c.globalAlpha = 1;
    c.fillStyle = lane.colour;
    c.beginPath();
    c.roundRect(front - BLOCK, middle - size / 2, BLOCK, size, 5);
    c.fill();
    palm(c, grip, middle, colours);
    arrow(c, front - BLOCK - 6, middle + size / 2 + 10, lane, colours);
  }
}

/** The places of the last moments, as a shadow of the block. */
function blur(c, stage, lane, middle, size) {
  const [low, high] = lane.range.map((place) => Math.max(-60, Math.min(stage.canvas.clientWidth + 60, stage.at(place))));
  c.fillStyle = lane.colour;
  c.beginPath();
  c.roundRect(low - BLOCK, middle - size / 2, high - low + BLOCK, size, 5);
  c.fill();
}

function hatch(c, left, right, height, colour) {
  c.save();
  c.beginPath();
  c.rect(left, 0, right - left, height);
  c.clip();
  for (let x = left - height; x < right; x += 14) path(c, [[x, height], [x + height, 0]], colour, 1);
  c.restore();
}

function spring(c, from, to, y, colour) {
  const turns = 7;
  const step = (to - from - 16) / (2 * turns);
  const points = [[from, y], [from + 8, y]];
  for (let turn = 0; turn < 2 * turns; turn += 1) points.push([from + 8 + (turn + 0.5) * step, y + (turn % 2 ? 7 : -7)]);
  points.push([to - 8, y], [to, y]);
  path(c, points, colour, 1.6);
}

/** A fist, in a few strokes. */
function palm(c, x, y, colours) {
  c.fillStyle = colours.card;
  c.strokeStyle = colours.ink;
  c.lineWidth = 1.8;
  c.beginPath();
  c.roundRect(x - 15, y - 16, 28, 32, 11);
  c.fill();
  c.stroke();
  for (const dy of [-7, 0, 7]) path(c, [[x - 1, y + dy], [x + 12, y + dy]], colours.ink, 1.3);
  path(c, [[x - 15, y - 7], [x - 34, y - 11]], colours.ink, 1.8);
  path(c, [[x - 15, y + 9], [x - 34, y + 13]], colours.ink, 1.8);
}

/** The force that one would feel; its largest of late stands pale behind it. */
function arrow(c, x, y, lane, colours) {
  const long = (force) => Math.sign(force) * Math.min(150, 34 * Math.sqrt(Math.abs(force)));
  font(c, 12, 600);
  for (const [force, alpha] of [[lane.peak, 0.3], [lane.force, 1]]) {
    if (Math.abs(force) < 0.05) continue;
    // The head stays in the picture.
    const end = Math.max(Math.min(8, x), x - long(force));
    const head = Math.sign(x - end) * Math.min(7, Math.abs(end - x));
    c.globalAlpha = alpha;
    path(c, [[x, y], [end, y], [end + head, y - 4], [end, y], [end + head, y + 4]], colours.ink, 2.4);
  }
  c.globalAlpha = 1;
  if (Math.abs(lane.peak) < 0.05) return;
  c.fillStyle = colours.ink;
  c.textAlign = "right";
  const said = `${Math.abs(lane.peak).toFixed(Math.abs(lane.peak) < 10 ? 1 : 0)} N`;
  const [end, room] = [Math.min(x, x - long(lane.peak), x - long(lane.force)) - 6, c.measureText(said).width + 10];
  c.fillText(said, Math.max(room, end), end < room ? y - 8 : y + 4);
}
