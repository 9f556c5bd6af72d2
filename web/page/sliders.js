// The numbers of a scene that one moves by hand.

import { made } from "./made.js";
import { changed, pairs, toml, value } from "./scene.js";

const STEPS = 400;

/** Key, label, unit, range, spacing; `off`: the table that is taken away at the lowest place; `mm`: shown in mm. */
export const SLIDERS = [
  { key: "environment.wall.stiffness", label: "Wall stiffness", unit: "N/m", from: 100, to: 200000, log: true },
  { key: "environment.wall.damping", label: "Wall damping", unit: "N·s/m", from: 0, to: 100, bend: true },
  { key: "servo_rate", label: "Rate", unit: "Hz", from: 50, to: 10000, log: true },
  { key: "effects.delay.ticks", label: "Delay", unit: "ticks", from: 0, to: 20, whole: true, off: "effects.delay" },
  { key: "effects.encoder.resolution", label: "Encoder step", unit: "µm", scale: 1e6, from: 1e-7, to: 1e-3, log: true, off: "effects.encoder" },
  { key: "device.mass", label: "Device mass", unit: "kg", from: 0.02, to: 2, log: true },
  { key: "device.damping", label: "Device damping", unit: "N·s/m", from: 0, to: 20, bend: true },
  { key: "operator.stiffness", label: "Hand stiffness", unit: "N/m", from: 10, to: 2000, log: true },
  { key: "operator.damping", label: "Hand damping", unit: "N·s/m", from: 0, to: 30, bend: true },
  { key: "operator.mass", label: "Hand mass", unit: "kg", from: 0, to: 1, bend: true },
  { key: "operator.rest", label: "Hand presses to", unit: "mm", scale: 1e3, from: -0.01, to: 0.01 },
  { key: "initial.position", label: "Start", unit: "mm", scale: 1e3, from: -0.01, to: 0.01 },
  { key: "duration", label: "Length of a run", unit: "s", from: 0.5, to: 50, log: true },
];

/** The number at a share from 0 to 1 of a range. */
export const unrounded = ({ from, to, log }, share) => (log ? from * (to / from) ** share : from + (to - from) * share);

/** The share of a range up to a number, the other way round. */
export const shareOf = ({ from, to, log }, number) => (log ? Math.log(number / from) / Math.log(to / from) : (number - from) / (to - from));

/** The number at a place from 0 to 1, rounded as one would say it; null where the effect is off. */
export function numberAt(slider, place) {
  const { bend, whole, off } = slider;
  if (off && place <= 0) return null;
  const number = unrounded(slider, bend ? place * place : place);
  return whole ? Math.round(number) : Number(number.toPrecision(3));
}

/** The place from 0 to 1 of a number. */
export function placeOf(slider, number) {
  const { log, bend, off } = slider;
  if (number === null || number === undefined) return 0;
  const share = shareOf(slider, number);
  const place = bend ? Math.sqrt(Math.max(0, share)) : share;
  return Math.min(1, Math.max(off && !log ? 0.5 / STEPS : 0, place));
}

/** The scene with a slider's number; null takes its effect away. */
export function moved(tree, slider, number) {
  if (number === null || (slider.whole && number === 0)) return changed(tree, slider.off, undefined);
  const to = changed(tree, slider.key, number);
  return slider.key === "servo_rate" ? changed(to, "environment_rate", undefined) : to;
}

/** What a scene holds that no slider shows, nor another part of the page: not the cap and candidate, nor what is usual. */
export function unseen(tree) {
  const others = pairs(tree).filter(([key, it]) => it !== 0 && (Array.isArray(it) || !SLIDERS.some((slider) => slider.key === key)));
  const lines = others.map(([key, it]) => toml({ [key]: it }).trim());
  const told = lines.filter((it) => !/damping_cap|candidate|"(held|plain)"$/.test(it));
  return told.length ? `Also in the scene: ${told.join(", ")}.` : "";
}

/** A number with its unit. */
export function said(slider, number) {
  if (number === null || number === undefined) return slider.off ? "none" : `0 ${slider.unit}`;
  const shown = Number((number * (slider.scale ?? 1)).toPrecision(4));
  const unit = slider.whole && shown === 1 ? slider.unit.slice(0, -1) : slider.unit;
  return `${shown.toLocaleString("en", { maximumFractionDigits: 6 }).replace("-", "−")} ${unit}`;
}

/** Fills a form with the sliders; `move` is called with a slider and its number. */
export function fill(form, move) {
  const rows = SLIDERS.map((slider) => {
    // An <output> would take the label for itself; the number is told by the slider's own value.
    const shown = made("b", { ariaHidden: "true" });
    const input = made("input", { type: "range", min: 0, max: slider.whole ? slider.to : STEPS, step: 1, name: slider.key });
    input.addEventListener("input", () => move(slider, numberAt(slider, input.value / input.max)));
    const row = made("label", {}, made("span", {}, slider.label), shown, input);
    form.append(row);
    return { slider, row, shown, input };
  });
  return (tree) => {
    for (const { slider, row, shown, input } of rows) {
      const has = !slider.key.startsWith("environment.wall") || tree.environment?.wall !== undefined;
      const number = value(tree, slider.key) ?? (slider.off ? null : 0);
      row.hidden = !has || typeof number === "object" && number !== null;
      const place = Math.round(placeOf(slider, number) * input.max);
      if (Math.abs(place - input.value) > 0) input.value = place;
      shown.textContent = said(slider, number);
      input.setAttribute("aria-valuetext", said(slider, number));
    }
  };
}
