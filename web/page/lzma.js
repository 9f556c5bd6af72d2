// Decoder of a stream of LZMA without a header, in the terms of its specification: a range coder over adaptive bits.

/** The parameters of the stream: bits of the byte before that choose a byte's model, as `build.mjs` packs it. */
const CONTEXT = 4;

const TOP = 2 ** 24;
const HALF = 1024;
/** Distances from here on have their middle bits without a model, and from the last on their lowest four in one of their own. */
const [NEAR, MIDDLE] = [4, 14];
const [BYTES, LITERAL] = [256, 0x300];

const models = (count) => new Uint16Array(count).fill(HALF);

class Bits {
  constructor(packed) {
    Object.assign(this, { packed, at: 5, range: 0xffffffff, code: new DataView(packed.buffer, packed.byteOffset).getUint32(1) });
  }

  /** Takes in a byte where the range got narrow. */
  widen() {
    if (this.range >= TOP) return;
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.packed[this.at]) >>> 0;
    this.at += 1;
  }

  /** The next bit, by the model at `index`. */
  bit(model, index) {
    const bound = (this.range >>> 11) * model[index];
    const one = this.code >= bound;
    if (one) {
      this.range -= bound;
      this.code -= bound;
      model[index] -= model[index] >> 5;
    } else {
      this.range = bound;
      model[index] += (2048 - model[index]) >> 5;
    }
    this.widen();
    return one ? 1 : 0;
  }

  /** So many bits without a model, the highest first. */
  plain(count) {
    let number = 0;
    for (let left = count; left > 0; left -= 1) {
      this.range >>>= 1;
      const one = this.code >= this.range;
      if (one) this.code -= this.range;
      number = number * 2 + (one ? 1 : 0);
      this.widen();
    }
    return number;
  }

  /** A number of `count` bits from a tree of models that begins at `base`, the highest bit first. */
  tree(model, base, count) {
    let node = 1;
    for (let left = count; left > 0; left -= 1) node = 2 * node + this.bit(model, base + node);
    return node - 2 ** count;
  }

  /** The same, the lowest bit first. */
  reversed(model, base, count) {
    let [node, number] = [1, 0];
    for (let index = 0; index < count; index += 1) {
      const one = this.bit(model, base + node);
      node = 2 * node + one;
      number += one << index;
    }
    return number;
  }
}

class Lengths {
  constructor() {
    Object.assign(this, { choice: models(2), low: models(8), middle: models(8), high: models(256) });
  }

  next(bits) {
    if (!bits.bit(this.choice, 0)) return 2 + bits.tree(this.low, 0, 3);
    if (!bits.bit(this.choice, 1)) return 10 + bits.tree(this.middle, 0, 3);
    return 18 + bits.tree(this.high, 0, 8);
  }
}

/** The `length` bytes that are packed in a stream with the contexts above and without positions (lc 4, lp 0, pb 0). */
export function unpacked(packed, length) {
  const bits = new Bits(packed);
  const out = new Uint8Array(length);
  const literal = models(LITERAL << CONTEXT);
  const [match, again, first, second, third, short] = [12, 12, 12, 12, 12, 12].map(models);
  const [slots, specials, aligned] = [models(4 * 64), models(128), models(16)];
  const [fresh, repeated] = [new Lengths(), new Lengths()];
  let [state, at, far] = [0, 0, [0, 0, 0, 0]];

  const byte = () => {
    const before = at ? out[at - 1] : 0;
    const base = LITERAL * (before >> (8 - CONTEXT));
    let node = 1;
    if (state >= 7) {
      let matched = out[at - far[0] - 1];
      while (node < BYTES) {
        const known = (matched >> 7) & 1;
        matched <<= 1;
        const one = bits.bit(literal, base + ((1 + known) << 8) + node);
        node = 2 * node + one;
        if (one !== known) break;
      }
    }
    while (node < BYTES) node = 2 * node + bits.bit(literal, base + node);
    out[at] = node;
    at += 1;
    state = state < 4 ? 0 : state - (state < 10 ? 3 : 6);
  };

  const distance = (long) => {
    const slot = bits.tree(slots, 64 * Math.min(long - 2, 3), 6);
    if (slot < NEAR) return slot;
    const low = (slot >> 1) - 1;
    const base = (2 | (slot & 1)) * 2 ** low;
    if (slot < MIDDLE) return base + bits.reversed(specials, base - slot, low);
    return base + bits.plain(low - 4) * 16 + bits.reversed(aligned, 0, 4);
  };

  /** How long the next match is; its distance comes first in `far`. */
  const matching = () => {
    if (!bits.bit(again, state)) {
      const long = fresh.next(bits);
      far = [distance(long), ...far.slice(0, 3)];
      state = state < 7 ? 7 : 10;
      return long;
    }
    if (!bits.bit(first, state)) {
      if (!bits.bit(short, state)) {
        state = state < 7 ? 9 : 11;
        return 1;
      }
    } else {
      const which = !bits.bit(second, state) ? 1 : 2 + bits.bit(third, state);
      far.unshift(...far.splice(which, 1));
    }
    state = state < 7 ? 8 : 11;
    return repeated.next(bits);
  };

  while (at < length) {
    if (!bits.bit(match, state)) byte();
    else for (let left = matching(); left > 0 && at < length; left -= 1, at += 1) out[at] = out[at - far[0] - 1];
  }
  return out;
}
