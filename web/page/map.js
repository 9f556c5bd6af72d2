// The map of verdicts over two sliders, with the place where one stands.

import { made, put } from "./made.js";
import { VERDICTS, font, ink, path, sheet } from "./paint.js";
import { SLIDERS, placeOf, shareOf, unrounded } from "./sliders.js";
import { changed, toml, value } from "./scene.js";

const COUNT = 256;
const [LEFT, FOOT] = [58, 36];
/** Sliders that a map is over: those that the lanes differ in. */
const AXES = SLIDERS.filter((it) => /wall|servo_rate|^device|^operator/.test(it.key));

const axis = ({ key, from, to, log }) => `${key}=${from}..${to}:${COUNT}${log ? ":log" : ""}`;
/** Along a map every axis is even or logarithmic; a slider may be bent. */
const straight = (slider) => ({ ...slider, bend: false, off: undefined });

export class StabilityMap {
  constructor({ canvas, x, y, under, said, legend }, questions, move) {
    Object.assign(this, { canvas, x, y, under, saidPlace: said, questions, move, part: canvas.closest("section") });
    for (const select of [x, y]) for (const it of AXES) select.append(new Option(it.label.toLowerCase(), it.key));
    x.value = "environment.wall.stiffness";
    y.value = "environment.wall.damping";
    this.image = document.createElement("canvas");
    this.image.width = this.image.height = COUNT;
    for (const select of [x, y, under]) select.addEventListener("change", () => this.renew(true));
    canvas.addEventListener("click", (event) => this.step(...this.placeOf(event)));
    canvas.addEventListener("keydown", (event) => this.key(event));
    this.line = made("li", { className: "bound" });
    legend.append(this.line);
    this.asked = "";
  }

  get sliders() {
    return [this.x, this.y].map((select) => straight(AXES.find((it) => it.key === select.value)));
  }

  /** Shows where a scene stands; computes the map again where anything but its two numbers changed. */
  show(tree, names, title) {
    if (names && names.join() !== this.names?.join()) {
      const kept = this.under.value;
      this.names = names;
      this.under.replaceChildren(...names.map((name) => new Option(title(name), name)));
      this.under.value = names.includes(kept) ? kept : "none";
    }
    this.tree = tree;
    this.renew(false);
  }

  renew(always) {
    // A map that is not shown needs no runs.
    if (!this.x.clientWidth) return;
    const [x, y] = this.sliders;
    if (x.key === y.key) {
      // What is still being computed is of other axes.
      this.asked = "";
      this.fail("choose two different sliders");
      return;
    }
    const fixed = changed(changed(this.tree, x.key, undefined), y.key, undefined);
    const asked = `${axis(x)} ${axis(y)} ${this.under.value} ${toml(fixed)}`;
    if (asked !== this.asked || always) {
      this.asked = asked;
      this.limits = null;
      this.saidPlace.textContent = "computing …";
      this.request(x, y);
    }
    this.draw();
  }

  request(x, y) {
    const scene = toml(this.tree);
    const along = x.key.endsWith("wall.stiffness") ? y : y.key.endsWith("wall.stiffness") ? x : null;
    this.upwards = along === x;
    // A point for each pixel: on a logarithmic axis the line is far from straight between a few.
    const points = this.upwards ? this.box.wide : this.box.tall;
    this.places = along ? Array.from({ length: points + 1 }, (_, index) => index / points) : [];
    const curve = this.places.map((place) => toml(changed(this.tree, along.key, unrounded(along, place))));
    const rate = x.key === "servo_rate" ? x.to : y.key === "servo_rate" ? y.to : this.tree.servo_rate;
    this.fade();
    const about = { count: COUNT, ticks: rate * this.tree.duration, curve };
    this.questions.ask("map", { scene, x: axis(x), y: axis(y), name: this.under.value, ...about });
  }

  /** Makes what stands there pale, since it is of the setting before. */
  fade() {
    const context = this.image.getContext("2d");
    Object.assign(context, { globalAlpha: 0.7, fillStyle: ink().card });
    context.fillRect(0, 0, COUNT, COUNT);
  }

  /** Takes what the worker tells. */
  hear({ first, cells, took, limits, refused, beyond }) {
    if (!this.asked) return;
    if (refused) return this.fail(refused.split("\n")[0]);
    if (beyond) return this.send();
    this.part.classList.remove("pale");
    if (cells) {
      const colours = ink();
      const shades = VERDICTS.map((word) => rgb(colours[word]));
      const context = this.image.getContext("2d");
      const rows = Math.ceil(cells.length / COUNT);
      const pixels = context.createImageData(COUNT, rows);
      cells.forEach((verdict, index) => {
        const up = rows - 1 - Math.floor(index / COUNT);
        pixels.data.set([...shades[verdict], 255], 4 * (up * COUNT + (index % COUNT)));
      });
      context.putImageData(pixels, 0, COUNT - first / COUNT - rows);
    }
    if (took !== undefined) {
      this.saidPlace.textContent = `${(COUNT * COUNT).toLocaleString("en")} runs in ${(took / 1e3).toFixed(1)} s on one core`;
    }
    if (limits) this.limits = limits;
    this.draw();
  }

  /** Says in place of the map why there is none. */
  fail(...reason) {
    this.saidPlace.replaceChildren(...reason);
    this.part.classList.add("pale");
  }

  /** Sends to the command. */
  send() {
    const [x, y] = this.sliders.map(axis);
    const command = `lyapunov map scene.toml --x ${x} --y ${y} --stabilizers ${this.under.value} --out map`;
    const why = "The page does not map this scene: it maps a hand and a device before a wall, and nothing more. Download it below, then: ";
    this.fail(why, made("code", {}, command));
  }

  get box() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return { left: LEFT, top: 8, wide: width - LEFT - 10, tall: height - FOOT - 8 };
  }

  placeOf(event) {
    const { left, top, wide, tall } = this.box;
    const edge = this.canvas.getBoundingClientRect();
    const clip = (share) => Math.min(1, Math.max(0, share));
    return [clip((event.clientX - edge.left - left) / wide), clip(1 - (event.clientY - edge.top - top) / tall)];
  }

  step(right, up) {
    const [x, y] = this.sliders;
    const number = (slider, place) => Number(unrounded(slider, place).toPrecision(3));
    this.move([[x, number(x, right)], [y, number(y, up)]]);
  }

  key(event) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
    if (!way) return;
    event.preventDefault();
    const [x, y] = this.here();
    const by = event.shiftKey ? 0.1 : 0.01;
    this.step(Math.min(1, Math.max(0, x + way[0] * by)), Math.min(1, Math.max(0, y + way[1] * by)));
  }

  here() {
    return this.sliders.map((it) => placeOf(it, value(this.tree, it.key) ?? 0));
  }

  draw() {
    const { context: c } = sheet(this.canvas);
    const { left, top, wide, tall } = this.box;
    const colours = ink();
    c.imageSmoothingEnabled = false;
    c.drawImage(this.image, left, top, wide, tall);
    c.strokeStyle = colours.line;
    c.strokeRect(left, top, wide, tall);
    const [x, y] = this.sliders;
    this.marks(c, x, y);
    this.bound(c);
    const [right, up] = this.here();
    const [px, py] = [left + right * wide, top + (1 - up) * tall];
    for (const [colour, thick] of [[colours.card, 5], [colours.ink, 2]]) {
      c.beginPath();
      c.arc(px, py, 8, 0, 2 * Math.PI);
      Object.assign(c, { strokeStyle: colour, lineWidth: thick });
      c.stroke();
    }
  }

  /** Draws the exact limit, and names it where it is in the picture. */
  bound(c) {
    const { left, top, wide, tall } = this.box;
    const stiff = this.sliders[this.upwards ? 1 : 0];
    let [piece, isSeen] = [[], false];
    const pieces = [piece];
    this.limits?.forEach((limit, index) => {
      const along = this.places[index];
      const across = limit > 0 ? shareOf(stiff, limit) : NaN;
      if (Number.isNaN(across)) return void pieces.push((piece = []));
      isSeen ||= across >= 0 && across <= 1;
      const [right, up] = this.upwards ? [along, across] : [across, along];
      piece.push([left + right * wide, top + (1 - up) * tall]);
    });
    this.line.hidden = !isSeen;
    put(this.line, `exact limit of the linear loop${this.under.value === "none" ? "" : " without a stabilizer"}`);
    c.save();
    c.beginPath();
    c.rect(left, top, wide, tall);
    c.clip();
    for (const one of pieces) {
      path(c, one, ink().card, 5);
      path(c, one, ink().ink, 2);
    }
    c.restore();
  }

  marks(c, x, y) {
    const { left, top, wide, tall } = this.box;
    const colours = ink();
    font(c, 11);
    c.fillStyle = colours.soft;
    const near = (slider) => {
      if (!slider.log) return [0, 0.25, 0.5, 0.75, 1].map((place) => slider.from + place * (slider.to - slider.from));
      const powers = [];
      for (let power = Math.ceil(Math.log10(slider.from) - 1e-9); 10 ** power <= slider.to * 1.0001; power += 1) powers.push(10 ** power);
      return powers;
    };
    const text = (number, { scale = 1 }) => (number >= 1e3 ? `${Number((number / 1e3).toPrecision(3))}k` : `${Number((number * scale).toPrecision(3))}`);
    for (const number of near(x)) {
      const px = left + placeOf(x, number) * wide;
      c.textAlign = px > left + wide - 16 ? "right" : "center";
      c.fillText(text(number, x), px, top + tall + 14);
    }
    c.textAlign = "right";
    for (const number of near(y)) c.fillText(text(number, y), left - 6, Math.max(top + 8, top + (1 - placeOf(y, number)) * tall + 4));
    c.textAlign = "center";
    c.fillStyle = colours.ink;
    c.fillText(`${x.label}, ${x.unit}`, left + wide / 2, top + tall + 29);
    c.save();
    c.translate(13, top + tall / 2);
    c.rotate(-Math.PI / 2);
    c.fillText(`${y.label}, ${y.unit}`, 0, 0);
    c.restore();
  }
}

/** The three parts of a colour in the notation #rrggbb. */
const rgb = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
