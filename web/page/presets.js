// Scenes to start from: a desk-top device, and the paper's four figures with its claims.

import { button, made } from "./made.js";

const PAPER = {
  duration: 10, servo_rate: 100,
  operator: { mass: 0.1, damping: 0.2, stiffness: 50 },
  device: { mass: 0.2, damping: 0.001 },
  initial: { position: -0.004 },
};
const wall = (stiffness, damping) => ({ wall: { stiffness, damping } });
const SOFT = { ...PAPER, environment: wall(8000, 2) };
const STIFF = { ...PAPER, environment: wall(50000, 20) };

export const PRESETS = [
  {
    id: "desk", name: "A device on a desk", look: "live",
    said: "A light device at 1 kHz, pressed 3 mm into a wall of 40 kN/m. By itself it runs away; what holds it also shows how well.",
    scene: {
      duration: 2, servo_rate: 1000,
      operator: { mass: 0.1, damping: 1, stiffness: 300, rest: 0.003 },
      device: { mass: 0.2, damping: 0.1 },
      initial: { position: -0.006 },
      environment: wall(40000, 2),
    },
  },
  {
    id: "figure-6", name: "Figure 6", look: "run", shows: "none", scene: SOFT,
    said: "8 kN/m at 100 Hz, nothing watches. The motion leaves its start far behind.",
    claims: [["Unstable without control", "yes: the grey curve grows until it is out of the picture"],
      ["A constant swing", "no: the swing grows, it does not stay"]],
  },
  {
    id: "figure-7", name: "Figure 7", look: "run", shows: "lolc-mass-spring-damper", scene: SOFT,
    said: "The same wall with LOLC, whose candidate credits the wall's own damper.",
    claims: [["The position settles with LOLC", "it stays bounded here; within the paper's ten seconds it hardly rests"],
      ["First force peak near 3 N", "2.96 N in this phase of the clock; another phase gives another peak"],
      ["The controller's force has the opposite sign", "yes, after the first contact"],
      ["The energy never falls below zero", "no: it falls to −2.4 mJ at the end of the first contact"]],
  },
  {
    id: "figure-8", name: "Figure 8", look: "run", shows: "popc", scene: STIFF,
    said: "50 kN/m at 100 Hz. Compare the positions under POPC and under LOLC.",
    claims: [["Both settle", "yes, in this run"],
      ["POPC settles sooner and swings less", "yes, in this run: the blue curve is at rest first"],
      ["LOLC jitters less once settled", "no: neither jitters here"]],
  },
  {
    id: "figure-9", name: "Figure 9", look: "run", shows: "lolc-mass-spring-damper", scene: STIFF,
    said: "The same runs; look at the observed energy.",
    claims: [["POPC's energy is more impulsive, LOLC's smoother", "no: LOLC takes the larger steps"],
      ["LOLC takes less energy", "no: it takes more, as it acts later"]],
  },
];

/** A button for each preset, and the claims of those of the paper; `start` takes a preset, `look` then shows its loops. */
export function list({ buttons, claims }, start, look) {
  for (const preset of PRESETS) {
    buttons.append(Object.assign(button(preset.name, () => start(preset)), { id: preset.id }));
    if (!preset.claims) continue;
    const go = button(`See ${preset.name.toLowerCase()}`, () => {
      start(preset);
      look();
    });
    const said = preset.claims.flatMap(([claim, seen]) => [made("dt", {}, claim), made("dd", {}, seen)]);
    claims.append(made("article", {}, made("h3", {}, preset.name), made("p", {}, preset.said), made("dl", {}, ...said), go));
  }
}
