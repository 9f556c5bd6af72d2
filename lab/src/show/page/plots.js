// The panels of a figure as plots: their cursors move together and their abscissae zoom together where they have one name.

const NARROW = 640;
const HINT =
  "Drag to zoom, twice clicked shows all. With a plot in focus: \u2190 \u2192 move the cursor (Shift: faster), + and \u2212 zoom, " +
  "\u2191 \u2193 zoom the ordinate, 0 shows all.";

class Plot {
  constructor(figure, data, panel) {
    Object.assign(this, { figure, panel, exact: null });
    this.curves = panel.curves.map((curve) => readable(curve, data));
    this.steps = [...new Set(this.curves.flatMap((curve) => curve.points.map(([x]) => x)))].sort((a, b) => a - b);
    this.box = element("div", "panel");
    if (panel.title) this.box.append(element("p", "panel-title", panel.title));
    this.legend = element("div", "legend");
    this.at = element("span", "at");
    this.curves.forEach((curve) => this.name(curve));
    this.legend.append(this.at);
    this.frame = element("div", "plot");
    this.frame.tabIndex = 0;
    this.frame.setAttribute("role", "group");
    this.frame.setAttribute("aria-label", `${panel.title || panel.y || data.title}: plot over ${panel.x}`);
    this.frame.addEventListener("keydown", (event) => this.key(event));
    this.box.append(this.legend, this.frame);
  }

  // The entry of a curve: a button that switches it, with the value at the cursor. A curve without a name that shares the
  // colour of one with a name goes with that one.
  name(curve) {
    const isPart = !curve.label && this.curves.some((other) => other.label && other.colour === curve.colour);
    if (isPart) return;
    const button = element("button", "curve");
    button.type = "button";
    button.setAttribute("aria-pressed", "true");
    const swatch = element("span", "swatch");
    const colour = curve.colour === "#000000" ? "var(--ink)" : curve.colour;
    let at = 0;
    const stops = curve.dash.map((part, index) => `${index % 2 ? "#0000" : colour} ${at}px ${(at += part)}px`);
    swatch.style.background = stops.length ? `repeating-linear-gradient(90deg, ${stops})` : colour;
    curve.value = element("span", "value");
    button.append(swatch, element("span", "", curve.label || this.panel.y || this.panel.x || "value"), curve.value);
    button.addEventListener("click", () => this.figure.toggle(curve, !curve.shown));
    curve.button = button;
    this.legend.append(button);
  }

  show(curve, isShown) {
    curve.shown = isShown;
    curve.button?.setAttribute("aria-pressed", String(isShown));
    this.u.setSeries(this.curves.indexOf(curve) + 1, { show: isShown });
    this.read(null);
  }

  draw(width, height) {
    const { panel } = this;
    const home = (range) => ({ time: false, auto: false, min: range[0], max: range[1], range: (_, low, high) => [low, high] });
    const series = this.curves.map((curve) => ({
      stroke: () => ink(curve.colour),
      width: Math.max(1.5, curve.width),
      dash: curve.dash.length ? curve.dash.map((part) => part * devicePixelRatio) : undefined,
      cap: curve.trace === "bars" ? "butt" : "round",
      points: { show: false },
      auto: false,
      paths: (u) => traced(u, curve),
      ...(curve.trace === "dots" ? { width: 5 } : {}),
    }));
    const options = {
      width,
      height,
      legend: { show: false },
      scales: { x: home(panel.xRange), y: home(panel.yRange) },
      axes: [axis(panel, "x"), axis(panel, "y", (own) => this.figure.room(this, own))],
      series: [{}, ...series],
      cursor: {
        points: { show: false },
        drag: { x: true, y: true, uni: 40, dist: 6 },
        bind: {
          dblclick: () => () => this.figure.home(),
          mousemove: (u, target, handler) => (event) => {
            this.exact = null;
            return handler(event);
          },
        },
      },
      hooks: {
        drawAxes: [(u) => drawGuides(u, panel.guides)],
        draw: [(u) => drawGuides(u, panel.guides, this.curves)],
        setCursor: [(u) => this.follow(u)],
        setScale: [(u, key) => key === "x" && this.u && this.figure.link(this)],
      },
    };
    this.u = new uPlot(options, [panel.xRange, ...this.curves.map(() => [null, null])], this.frame);
    this.dots = this.curves.map((curve) => {
      const dot = element("div", "dot");
      dot.style.borderColor = curve.colour === "#000000" ? "var(--ink)" : curve.colour;
      this.u.over.append(dot);
      return dot;
    });
    // One finger along the plot reads it; the page still scrolls.
    const touch = (event) => {
      if (event.pointerType === "mouse") return;
      const box = this.u.over.getBoundingClientRect();
      this.exact = null;
      this.u.setCursor({ left: event.clientX - box.left, top: event.clientY - box.top });
    };
    ["pointerdown", "pointermove"].forEach((kind) => this.u.over.addEventListener(kind, touch));
  }

  // Reads this plot at its cursor, and the others of the same abscissa there too.
  follow(u) {
    if (!this.dots) return;
    const { left } = u.cursor;
    const x = left >= 0 ? (this.exact ?? u.posToVal(left, "x")) : null;
    this.read(x);
    this.figure.others(this).forEach((other) => {
      const place = x === null ? -10 : other.u.valToPos(x, "x");
      other.u.setCursor({ left: place, top: -10 }, false);
      other.read(x);
    });
  }

  // Writes the values at the abscissa `x` beside the names of the curves; none clears them.
  read(x) {
    const { u, panel } = this;
    const { left, top } = u.cursor;
    const y = top >= 0 ? u.posToVal(top, "y") : null;
    const real = (value, key) => told(panel[`${key}Log`] ? 10 ** value : value, panel[`${key}Log`] ? 4 : 9);
    let at = null;
    this.curves.forEach((curve, index) => {
      const dot = this.dots[index];
      dot.hidden = true;
      let text = "";
      if (x !== null && curve.shown && curve.trace === "bars") {
        const bar = y === null ? null : barAt(curve, x, y);
        text = bar ? told(bar.length) : "-";
      } else if (x !== null && curve.shown) {
        const point = nearest(u, curve, x, [left, top]);
        const isShown = point && (curve.isFunction || top >= 0);
        text = isShown ? (curve.isFunction ? "" : `${real(point[0], "x")}, `) + real(point[1], "y") : "-";
        if (isShown) {
          dot.hidden = false;
          dot.style.left = `${u.valToPos(point[0], "x")}px`;
          dot.style.top = `${u.valToPos(point[1], "y")}px`;
          if (curve.isFunction) at ??= point[0];
        }
      }
      if (curve.value) curve.value.textContent = text;
    });
    const row = panel.rows && y !== null ? panel.rows[Math.round(-y)] : undefined;
    this.at.textContent = row ?? (x === null ? "" : `${panel.x} ${real(at ?? x, "x")}`);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const faster = event.shiftKey ? 20 : 1;
    const acts = {
      ArrowRight: () => this.step(faster),
      ArrowLeft: () => this.step(-faster),
      "+": () => this.figure.zoom(this, 0.5),
      "=": () => this.figure.zoom(this, 0.5),
      "-": () => this.figure.zoom(this, 2),
      0: () => this.figure.home(),
      ArrowUp: () => this.zoom("y", 0.5),
      ArrowDown: () => this.zoom("y", 2),
    };
    if (!acts[event.key]) return;
    event.preventDefault();
    acts[event.key]();
  }

  // Moves the cursor to the sample that is `count` further, and the shown part with it.
  step(count) {
    const { u, steps } = this;
    if (steps.length === 0) return;
    const { min, max } = u.scales.x;
    const now = this.exact ?? (u.cursor.left >= 0 ? u.posToVal(u.cursor.left, "x") : null);
    const first = steps.findIndex((x) => x >= (now ?? min));
    const index = now === null ? first : (first < 0 ? steps.length - 1 : first) + count;
    this.exact = steps[Math.max(0, Math.min(steps.length - 1, index))];
    if (this.exact < min || this.exact > max) {
      const low = this.exact < min ? this.exact : this.exact - (max - min);
      u.setScale("x", { min: low, max: low + max - min });
    }
    u.setCursor({ left: u.valToPos(this.exact, "x"), top: Math.max(0, u.cursor.top || 0) });
  }

  // Narrows or widens an axis about the cursor, or its middle; it never shows more than at first.
  zoom(key, factor) {
    const { u, panel } = this;
    const { min, max } = u.scales[key];
    const [first, last] = panel[`${key}Range`];
    const place = key === "x" ? u.cursor.left : u.cursor.top;
    const centre = place > 0 ? u.posToVal(place, key) : 0.5 * (min + max);
    const low = centre - factor * (centre - min);
    const high = centre + factor * (max - centre);
    u.setScale(key, { min: Math.max(first, low), max: Math.min(last, high) });
  }
}

class LiveFigure {
  constructor(root, data) {
    Object.assign(this, { root, data, isLinking: false });
    this.plots = data.panels.map((panel) => new Plot(this, data, panel));
    this.grid = element("div", "plots");
    this.grid.append(...this.plots.map((plot) => plot.box));
    this.bar = element("div", "bar");
    this.action("+", "Zoom in", () => this.zoom(this.plots[0], 0.5));
    this.action("\u2212", "Zoom out", () => this.zoom(this.plots[0], 2));
    this.action("all", "Show all", () => this.home());
    const magnified = this.plots.find((plot) => plot.panel.magnified);
    if (magnified) {
      const [min, max] = magnified.panel.magnified;
      this.action("magnified part", "Zoom to the part that the drawing magnifies", () => magnified.u.setScale("x", { min, max }));
    }
    const thinned = data.thinned ? " Long curves are thinned here; their extremes are kept." : "";
    this.bar.append(element("span", "hint", HINT + thinned));
    const title = data.title ? [element("p", "plots-title", data.title)] : [];
    root.querySelector("figcaption").before(...title, this.grid, this.bar);
    root.classList.add("live");
    this.size();
    new ResizeObserver(() => this.size()).observe(root);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.plots.forEach((plot) => plot.u.redraw()));
  }

  action(text, title, act) {
    const button = element("button", "", text);
    Object.assign(button, { type: "button", title });
    button.addEventListener("click", act);
    this.bar.append(button);
  }

  size() {
    this.columns = this.root.clientWidth < NARROW ? 1 : this.data.columns;
    this.grid.style.gridTemplateColumns = `repeat(${this.columns}, minmax(0, 1fr))`;
    this.rooms = [];
    const height = Math.max(110, this.data.height) + 52;
    for (const plot of this.plots) {
      const width = Math.max(160, plot.frame.clientWidth);
      if (!plot.u) plot.draw(width, height);
      else if (plot.u.width !== width) plot.u.setSize({ width, height });
    }
  }

  // The room for the ordinate of a plot: the most that one of its column has needed, so that their frames line up.
  room(plot, own) {
    const column = (it) => this.plots.indexOf(it) % this.columns;
    const at = column(plot);
    if (own > (this.rooms[at] ??= 0)) {
      this.rooms[at] = own;
      const others = this.plots.filter((it) => it !== plot && column(it) === at);
      requestAnimationFrame(() => others.forEach((it) => it.u.redraw(false, true)));
    }
    return this.rooms[at];
  }

  others(plot) {
    return this.plots.filter((other) => other !== plot && other.panel.x === plot.panel.x && !other.panel.rows && !plot.panel.rows);
  }

  toggle(curve, isShown) {
    for (const plot of this.plots) {
      const isSame = (other) => other === curve || (curve.label && other.label === curve.label);
      const named = plot.curves.filter(isSame);
      const parts = plot.curves.filter((other) => !other.button && named.some((one) => one.colour === other.colour));
      [...named, ...parts].forEach((other) => plot.show(other, isShown));
    }
  }

  // Shows of the panels with the same abscissa what this one shows.
  link(plot) {
    if (this.isLinking) return;
    this.isLinking = true;
    const { min, max } = plot.u.scales.x;
    this.others(plot).forEach((other) => other.u?.setScale("x", { min, max }));
    this.isLinking = false;
  }

  zoom(plot, factor) {
    const each = [plot, ...this.plots.filter((other) => other !== plot && !this.others(plot).includes(other))];
    each.forEach((one) => one.zoom("x", factor));
  }

  home() {
    for (const { u, panel } of this.plots) {
      u.setScale("x", { min: panel.xRange[0], max: panel.xRange[1] });
      u.setScale("y", { min: panel.yRange[0], max: panel.yRange[1] });
    }
  }
}

for (const root of document.querySelectorAll("figure.curves")) {
  unpacked(root).then((data) => new LiveFigure(root, data));
}
