// Drawing on canvases in the page's colours.

/** The verdicts by their numbers, as the style sheet names their colours. */
export const VERDICTS = ["settles", "swinging", "grows", "short"];

/** Dashes of the curves of the three loops: two curves in one place are both seen, also where their colours look alike. */
export const DASHES = [[], [14, 6], [3, 5]];

let colours = null;

/** The page's colours by name, as the style sheet gives them for light or dark. */
export function ink() {
  if (colours) return colours;
  const style = getComputedStyle(document.documentElement);
  const names = ["paper", "card", "ink", "soft", "line", "none", "popc", "lolc", ...VERDICTS, "wall"];
  colours = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  return colours;
}

/** Calls `then` whenever light and dark change. */
export function onScheme(then) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    colours = null;
    then();
  });
}

/** Whether someone asked for less motion. */
export const isCalm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** The context of a canvas that fills its box with whole pixels of the screen, and the box in CSS pixels. */
export function sheet(canvas) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const ratio = Math.min(devicePixelRatio || 1, 3);
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineJoin = context.lineCap = "round";
  return { context, width, height };
}

export function font(context, size, weight = 400) {
  context.font = `${weight} ${size}px system-ui, sans-serif`;
}

/** A line through points. */
export function path(context, points, colour, thick = 1.5, dash = []) {
  context.setLineDash(dash);
  context.lineCap = dash.length ? "butt" : "round";
  context.beginPath();
  points.forEach(([x, y], index) => (index ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.strokeStyle = colour;
  context.lineWidth = thick;
  context.stroke();
  context.setLineDash([]);
}
