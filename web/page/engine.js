// The Rust side: text or numbers in, text or numbers out.

import { Packed, unpacked } from "./lzma.js";

const text = new TextEncoder();
const words = new TextDecoder();

/** Columns of a row of `trace`, and of a row of `advance`. */
export const RUN = { t: 0, x: 1, wall: 2, control: 3, force: 4, energy: 5, width: 6 };
export const LIVE = { t: 0, x: 1, force: 2, damping: 3, energy: 4, width: 5 };
/** Numbers before the rows of `trace`. */
const HEAD = 7;

/** The module inside the page: its length, and base64 of its packed bytes. */
export async function inside(text) {
  const [length, base64] = text.split(" ");
  const packed = Uint8Array.from(atob(base64), (it) => it.charCodeAt(0));
  return WebAssembly.compile(unpacked(new Packed(packed), Number(length)));
}

/** A refusal of the Rust side, in its words. */
export class Refusal extends Error {}

export class Engine {
  static async of(module) {
    const { exports } = await WebAssembly.instantiate(module, {});
    return new Engine(module, exports);
  }

  constructor(module, exports) {
    this.module = module;
    this.rust = exports;
  }

  /** Calls `name` with an input text; returns the bytes of the output, which are valid until the next call. */
  bytes(name, input, ...numbers) {
    const given = text.encode(input);
    const place = this.rust.input(given.length) >>> 0;
    new Uint8Array(this.rust.memory.buffer, place, given.length).set(given);
    const answer = this.rust[name](...numbers);
    const output = new Uint8Array(this.rust.memory.buffer, this.rust.output() >>> 0, this.rust.output_length());
    if (answer !== 0) throw new Refusal(words.decode(output));
    return output;
  }

  text(name, input, ...numbers) {
    return words.decode(this.bytes(name, input, ...numbers));
  }

  numbers(name, input, ...numbers) {
    const { buffer, byteOffset, byteLength } = this.bytes(name, input, ...numbers);
    return new Float64Array(buffer.slice(byteOffset, byteOffset + byteLength));
  }

  /** The run of a scene under a stabilizer. */
  run(name, scene) {
    const all = this.numbers("trace", `${name}\n${scene}`);
    const [verdict, settled, peak, injected, least, active, count] = all;
    return { name, verdict, settled, peak, injected, least, active, count, rows: all.subarray(HEAD) };
  }

  lines(name, input = "") {
    return this.text(name, input).split("\n");
  }
}
