// What takes longer than a frame: the family, explanations, maps. Each kind of job drops the one before it.

import { Engine } from "./engine.js";
import { pictured } from "./family.js";

/** Rows of a map between two looks at the messages, at most, and ticks, about. */
const BAND = 16;
const TICKS = 2e7;

/** Cells of a band of a map, whole rows of `count`, each a run of so many ticks. */
export const bandOf = (ticks, count) => count * Math.max(1, Math.min(BAND, Math.floor(TICKS / (ticks * count))));

let engine = null;
const newest = {};
/** Recorded motions that scenes may name. */
const kept = [];
/** Jobs that a map waits for: what they answer is sooner there, and of the very setting. */
const ahead = new Set();
const breath = () => new Promise((done) => setTimeout(done));

const jobs = {
  /** The runs under all stabilizers that fit. */
  async family({ scene }, tell, goes) {
    for (const name of engine.lines("names", scene)) {
      if (!goes()) return;
      try {
        tell({ run: pictured(engine.run(name, scene)) });
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
  async map({ scene, x, y, name, count, ticks, curve }, tell, goes) {
    if (!engine.bytes("chart", `${x}\n${y}\n${name}\n${scene}`).length) return tell({ beyond: true });
    const band = bandOf(ticks, count);
    let took = 0;
    for (let first = 0; first < count * count; first += band) {
      do {
        await breath();
        await Promise.allSettled(ahead);
      } while (ahead.size);
      if (!goes()) return;
      const began = performance.now();
      const cells = engine.bytes("band", "", first, Math.min(band, count * count - first)).slice();
      took += performance.now() - began;
      tell({ first, cells });
    }
    tell({ took });
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
    const job = jobs[data.kind](data, tell, goes);
    if (data.kind !== "map") ahead.add(job);
    try {
      await job;
    } catch (error) {
      tell({ refused: error.message });
      // A trap leaves the instance as it was in the middle of a call.
      if (!(error instanceof WebAssembly.RuntimeError)) return;
      engine = await Engine.of(engine.module);
      kept.forEach((it) => engine.bytes("keep", it));
    } finally {
      ahead.delete(job);
    }
  };
  addEventListener("message", take);
}
