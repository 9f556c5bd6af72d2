// What takes longer than a frame: the family, explanations, maps. Each kind of job drops the one before it.

import { Engine } from "./engine.js";

/** Cells of a map between two looks at the messages, and points of the curve of the exact limit. */
const BAND = 4096;

let engine = null;
const newest = {};
/** Recorded motions that scenes may name. */
const kept = [];
const breath = () => new Promise((done) => setTimeout(done));

const jobs = {
  /** The runs under all stabilizers that fit. */
  async family({ scene }, tell, goes) {
    for (const name of engine.lines("names", scene)) {
      if (!goes()) return;
      try {
        tell({ run: engine.run(name, scene) });
      } catch (error) {
        tell({ run: { name, refused: error.message } });
      }
      await breath();
    }
    tell({ ends: true });
  },

  /** The explanation of the run under one stabilizer. */
  async explain({ scene, name }, tell) {
    const text = engine.text("explain", `${name}\n${scene}`);
    const [sentence, energies] = text.split("\n", 2);
    const rows = energies.split("\t").slice(1).map((row) => row.split("|"));
    tell({ name, sentence, rows, told: JSON.parse(text.slice(sentence.length + energies.length + 2)) });
  },

  /** The verdicts over two axes, and the exact limit where the stiffness is one of them. */
  async map({ scene, x, y, name, count, curve }, tell, goes) {
    if (!engine.bytes("chart", `${x}\n${y}\n${name}\n${scene}`).length) return tell({ beyond: true });
    const began = performance.now();
    for (let first = 0; first < count * count; first += BAND) {
      await breath();
      if (!goes()) return;
      const cells = engine.bytes("band", "", first, Math.min(BAND, count * count - first)).slice();
      tell({ first, cells });
    }
    tell({ took: performance.now() - began });
    const limits = curve.map((it) => engine.numbers("limits", it)[0]);
    tell({ limits });
  },
};

export function work() {
  const waiting = [];
  const take = async ({ data }) => {
    if (data.module) {
      engine = await Engine.of(data.module);
      waiting.splice(0).forEach((it) => take({ data: it }));
      return;
    }
    if (data.kind) newest[data.kind] = data.id;
    if (!engine) return void waiting.push(data);
    if (data.kept) {
      kept.push(data.kept);
      engine.bytes("keep", data.kept);
      return;
    }
    const goes = () => newest[data.kind] === data.id;
    const tell = (told) => goes() && postMessage({ id: data.id, kind: data.kind, ...told });
    try {
      await jobs[data.kind](data, tell, goes);
    } catch (error) {
      tell({ refused: error.message });
      // A trap leaves the instance as it was in the middle of a call.
      if (!(error instanceof WebAssembly.RuntimeError)) return;
      engine = await Engine.of(engine.module);
      kept.forEach((it) => engine.bytes("keep", it));
    }
  };
  addEventListener("message", take);
}
