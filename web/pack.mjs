// Packs bytes as `page/lzma.js` reads them: xz chooses what is a match, and its choices are written with better chances.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";

import { Bits, Packed, unpacked } from "./page/lzma.js";

const TOP = 2 ** 24;

/** A stream of xz, whose chances are those of the specification. */
class Chosen {
  constructor(packed) {
    Object.assign(this, { packed, at: 5, range: 0xffffffff, code: packed.readUInt32BE(1), counted: new Map() });
  }

  widen() {
    if (this.range >= TOP) return;
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.packed[this.at]) >>> 0;
    this.at += 1;
  }

  /** Whether the next bit is one, of which `bound` of the range are for zero. */
  split(bound) {
    const one = this.code >= bound ? 1 : 0;
    this.code -= one * bound;
    this.range = one ? this.range - bound : bound;
    this.widen();
    return one;
  }

  bit(model, index) {
    if (!this.counted.has(model)) this.counted.set(model, new Uint16Array(model.alone.of.length).fill(1024));
    const counts = this.counted.get(model);
    const one = this.split((this.range >>> 11) * counts[index]);
    counts[index] += one ? -(counts[index] >> 5) : (2048 - counts[index]) >> 5;
    return one;
  }

  half() {
    this.range >>>= 1;
    const one = this.code >= this.range ? 1 : 0;
    this.code -= one * this.range;
    this.widen();
    return one;
  }
}

/** Writes the choices of a stream anew while they are read. */
class Repacked extends Bits {
  constructor(chosen) {
    super();
    Object.assign(this, { chosen, bytes: [], low: 0, range: 0xffffffff, cache: 0, pending: 1 });
  }

  /** Gives out the highest byte of `low`, once no carry can change it any more. */
  shift() {
    const carry = this.low >= 2 ** 32 ? 1 : 0;
    if (carry || this.low < 0xff000000) {
      for (; this.pending > 0; this.pending -= 1) {
        this.bytes.push((this.cache + carry) & 255);
        this.cache = 255;
      }
      this.cache = (this.low >>> 24) & 255;
    }
    this.pending += 1;
    this.low = (this.low & 0xffffff) * 256;
  }

  narrow() {
    while (this.range < TOP) {
      this.range = (this.range << 8) >>> 0;
      this.shift();
    }
  }

  bit(model, index) {
    const one = this.chosen.bit(model, index);
    const bound = (this.range >>> 16) * model.zero(index, this.before);
    this.low += one * bound;
    this.range = one ? this.range - bound : bound;
    model.learn(index, one);
    this.narrow();
    return one;
  }

  plain(count) {
    let number = 0;
    for (let left = count; left > 0; left -= 1) {
      const one = this.chosen.half();
      this.range >>>= 1;
      this.low += one * this.range;
      this.narrow();
      number = 2 * number + one;
    }
    return number;
  }

  end() {
    for (let left = 5; left > 0; left -= 1) this.shift();
    return Buffer.from(this.bytes);
  }
}

/** How far xz looks is not known to the reader, and the best of some is not known before. */
const WAYS = [80, 92, 100, 108, 116, 124, 132, 144, 160, 192].flatMap((nice) => ["bt4", "bt3"].map((finder) => `nice=${nice},mf=${finder},depth=100`));

/** The packed form of a module. */
export function packed(module) {
  const chosen = (way) => execFileSync("xz", ["--format=raw", `--lzma1=preset=9e,lc=4,lp=0,pb=0,${way}`, "--stdout"], { input: module, maxBuffer: 2 ** 26 });
  const best = WAYS.map(chosen).reduce((least, next) => (next.length < least.length ? next : least));
  const again = new Repacked(new Chosen(best));
  unpacked(again, module.length);
  const short = again.end();
  assert.deepEqual(Buffer.from(unpacked(new Packed(short), module.length)), module);
  return short;
}
