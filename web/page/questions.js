// What the worker is asked, and which of its answers are still of the newest question.

/** How long a question waits for a newer one, ms: a slider that is moved asks often. */
const PAUSE = 120;
/** Where answers stand. */
const PLACES = { explain: ["why-said", "energies", "remedies"], family: ["members"], map: [] };

export class Questions {
  /** `send` takes a question; `first` is done whenever the pause is over. */
  constructor($, send, first) {
    Object.assign(this, { $, send, first, told: 0, newest: {}, unsent: new Map() });
  }

  /** Asks after the pause; questions are sent in the order in which they were asked last. */
  ask(kind, about) {
    this.told += 1;
    this.newest[kind] = this.told;
    this.unsent.delete(kind);
    this.unsent.set(kind, { id: this.told, kind, ...about });
    this.waits(kind, true);
    this.soon();
  }

  soon() {
    clearTimeout(this.later);
    this.later = setTimeout(() => {
      this.first();
      this.unsent.forEach((it) => this.send(it));
      this.unsent.clear();
    }, PAUSE);
  }

  /** Whether an answer is of the newest question of its kind: what was on its way when the scene changed is of the scene before. */
  hears({ id, kind }) {
    const isNew = id === this.newest[kind];
    if (isNew) this.waits(kind, false);
    return isNew;
  }

  /** What stands there until the answer comes is of the setting before: it is pale, and its buttons do nothing. */
  waits(kind, is) {
    for (const it of PLACES[kind]) Object.assign(this.$(it), { ariaBusy: is, inert: is });
  }
}
