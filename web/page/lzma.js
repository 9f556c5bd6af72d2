// Decoder of what `pack.mjs` packs: the choices of LZMA, in the terms of its specification, with chances of their own.
//
// LZMA counts how often a bit was one in its place. Here that is mixed with how often it was one there behind the same byte, which takes
// three bytes less of a hundred. The chances are of additions, products, quotients and roots alone, which all browsers round alike.

/** Bits of the byte before that choose a byte's model, as `build.mjs` calls the packer. */
const CONTEXT = 4;

const TOP = 2 ** 24;
/** Distances from here on have their middle bits without a model, and from the last on their lowest four in one of their own. */
const [NEAR, MIDDLE] = [4, 14];
const [BYTES, LITERAL] = [256, 0x300];
/** Bits that a chance remembers, alone and behind the same byte; how soon the weights of both follow; bounds of a chance. */
const [ALONE, BEHIND, PACE] = [18, 22, 0.02];
const [RARE, LEAST] = [0.001, 0.0005];

const within = (least, chance) => Math.min(1 - least, Math.max(least, chance));

/** How often a bit was one in each of some places. */
class Chances {
  constructor(count, most) {
    this.most = most;
    this.of = new Float32Array(count).fill(0.5);
    this.seen = new Uint8Array(count).fill(2);
  }

  /** The chance as a number without bounds, to be weighed. */
  spread(index) {
    const even = 2 * this.of[index] - 1;
    return even / Math.sqrt(1 - even * even);
  }

  learn(index, one) {
    const { of, seen } = this;
    of[index] = within(RARE, of[index] + (one - of[index]) / seen[index]);
    if (seen[index] < this.most) seen[index] += 1;
  }
}

/** Models of `count` bits; the packer uses them, too. */
export class Models {
  constructor(count) {
    this.alone = new Chances(count, ALONE);
    this.behind = new Chances(Math.min(count, LITERAL) * BYTES, BEHIND);
    this.weight = this.other = 0.6;
    this.place = 0;
    this.left = this.right = this.one = 0.5;
  }

  /** Of 65536 the parts for a zero at `index`, behind the byte `before`. */
  zero(index, before) {
    // The context of a byte's bits is part of the byte before.
    this.place = (index % LITERAL) * BYTES + before;
    this.left = this.alone.spread(index);
    this.right = this.behind.spread(this.place);
    const sum = this.weight * this.left + this.other * this.right;
    this.one = within(LEAST, 0.5 + (0.5 * sum) / Math.sqrt(1 + sum * sum));
    return Math.floor(65536 * (1 - this.one));
  }

  /** Learns what the bit at `index` was, for which `zero` was asked. */
  learn(index, one) {
    const pace = PACE * (one - this.one);
    this.weight += pace * this.left;
    this.other += pace * this.right;
    this.alone.learn(index, one);
    this.behind.learn(this.place, one);
  }
}

const models = (count) => new Models(count);

/** Bits and numbers of a stream, in which `before` is the byte before. */
export class Bits {
  before = 0;

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

/** A packed stream. */
export class Packed extends Bits {
  constructor(packed) {
    super();
    Object.assign(this, { packed, at: 5, range: 0xffffffff, code: new DataView(packed.buffer, packed.byteOffset).getUint32(1) });
  }

  /** Takes in a byte where the range got narrow. */
  widen() {
    while (this.range < TOP) {
      this.range = (this.range << 8) >>> 0;
      this.code = ((this.code << 8) | this.packed[this.at]) >>> 0;
      this.at += 1;
    }
  }

  /** The next bit, by the model at `index`. */
  bit(model, index) {
    const bound = (this.range >>> 16) * model.zero(index, this.before);
    const one = this.code >= bound ? 1 : 0;
    if (one) {
      this.range -= bound;
      this.code -= bound;
    } else this.range = bound;
    model.learn(index, one);
    this.widen();
    return one;
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

/** The `length` bytes that bits choose, with the contexts above and without positions (lc 4, lp 0, pb 0). */
export function unpacked(bits, length) {
  const out = new Uint8Array(length);
  const literal = models(LITERAL << CONTEXT);
  const [match, again, first, second, third, short] = [12, 12, 12, 12, 12, 12].map(models);
  const [slots, specials, aligned] = [models(4 * 64), models(128), models(16)];
  const [fresh, repeated] = [new Lengths(), new Lengths()];
  let [state, at, far] = [0, 0, [0, 0, 0, 0]];

  const byte = () => {
    const base = LITERAL * (bits.before >> (8 - CONTEXT));
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
    bits.before = at ? out[at - 1] : 0;
    if (!bits.bit(match, state)) byte();
    else for (let left = matching(); left > 0 && at < length; left -= 1, at += 1) out[at] = out[at - far[0] - 1];
  }
  return out;
}
