// Heat maps that tell the numbers of the cell under the pointer, and the command that runs just that cell.

// Every heat map of the page by its figure, with the bitmaps of its panels.
const maps = [];
const axesOf = () => JSON.parse(document.getElementById("axes")?.textContent ?? "null");

class Cells {
  constructor(root, data) {
    Object.assign(this, { root, data, kept: false });
    this.panels = data.panels.filter((panel) => panel.heat);
    this.images = [...root.querySelectorAll("image.cells")];
    this.told = element("div", "told");
    this.told.setAttribute("aria-live", "polite");
    this.told.append(element("p", "hint", "Point at a cell, or focus a map and press the arrow keys. A click keeps the cell."));
    root.querySelector("figcaption").before(this.told);
    this.mark = document.createElementNS("http://www.w3.org/2000/svg", "rect");
    this.mark.setAttribute("class", "mark");
    const svg = root.querySelector("svg");
    svg.append(this.mark);
    svg.addEventListener("pointermove", (event) => this.kept || this.point(event));
    svg.addEventListener("click", (event) => {
      this.kept = this.point(event);
    });
    this.images.forEach((image, index) => {
      image.setAttribute("tabindex", "0");
      image.setAttribute("role", "img");
      image.setAttribute("aria-label", `${data.title}, ${this.panels[index].title}: the arrow keys choose a cell`);
      image.addEventListener("keydown", (event) => this.key(event, index));
    });
  }

  // Tells the cell at the pointer, if there is one.
  point(event) {
    const index = this.images.findIndex((image) => {
      const box = image.getBoundingClientRect();
      return event.clientX >= box.left && event.clientX < box.right && event.clientY >= box.top && event.clientY < box.bottom;
    });
    if (index < 0) return false;
    const box = this.images[index].getBoundingClientRect();
    const { columns, rows } = this.panels[index].heat;
    const column = Math.floor(((event.clientX - box.left) / box.width) * columns);
    const row = rows - 1 - Math.floor(((event.clientY - box.top) / box.height) * rows);
    this.tell(index, column, row);
    return true;
  }

  key(event, index) {
    const steps = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    const { columns, rows } = this.panels[index].heat;
    const faster = event.shiftKey ? 10 : 1;
    const [column, row] = this.cell && this.cell[0] === index ? this.cell.slice(1) : [Math.floor(columns / 2) - step[0], Math.floor(rows / 2) - step[1]];
    const within = (value, count) => Math.max(0, Math.min(count - 1, value));
    this.kept = true;
    this.tell(index, within(column + faster * step[0], columns), within(row + faster * step[1], rows));
  }

  tell(index, column, row) {
    this.cell = [index, column, row];
    const image = this.images[index];
    const { columns, rows } = this.panels[index].heat;
    const [left, top, width, height] = ["x", "y", "width", "height"].map((name) => Number(image.getAttribute(name)));
    const place = { x: left + (column * width) / columns, y: top + ((rows - 1 - row) * height) / rows, width: width / columns, height: height / rows };
    Object.entries(place).forEach(([name, value]) => this.mark.setAttribute(name, value));
    const axes = axesOf();
    const list = element("dl");
    const add = (name, value, kind) => {
      const pair = element("div", kind);
      pair.append(element("dt", "", name), element("dd", "", value));
      list.append(pair);
    };
    if (axes) {
      add(axes.x.name, axes.x.values[column], "axis");
      add(axes.y.name, axes.y.values[row], "axis");
    }
    for (const map of maps) {
      const heat = map.panels[index]?.heat;
      if (heat) add(map.data.title, valueOf(heat, row * columns + column));
    }
    this.told.replaceChildren(element("p", "where", this.panels[index].title), list);
    const names = this.panels.map((panel) => panel.title);
    if (axes) this.told.append(command(axes, [names[index], ...names], column, row));
  }
}

// The value of an element, or its class by name; "in map.csv" where the page has no room for it.
function valueOf({ classes, values }, index) {
  if (values.length === 0) return "in map.csv";
  const value = values[index];
  if (value === null) return "-";
  return classes ? classes[value] : told(value);
}

// The command that runs just this cell, with a button that copies it: under the first stabilizer, and under those others whose
// own numbers the axes vary, since these have to take part.
function command({ x, y, command: made, several }, stabilizers, column, row) {
  const at = (axis, index) => `${axis.key}=${axis.values[index]}..${axis.values[index]}:1`;
  const isVaried = (name) => [x, y].some((axis) => axis.key.startsWith(`stabilizer.${name}.`));
  const names = new Set(stabilizers.filter((name, index) => index === 0 || isVaried(name)));
  const text = `${made} --x ${at(x, column)} --y ${at(y, row)} --stabilizers ${[...names]}`;
  const line = element("p", "command");
  const code = element("code", "", text);
  const button = element("button", "", "copy");
  button.type = "button";
  button.addEventListener("click", async () => {
    await copied(text, code);
    button.textContent = "copied";
  });
  line.append(code, " ", button);
  if (several) line.append(element("span", "hint", " A point is several cells: the numbers are their means, the command is that of a middle one."));
  return line;
}

// Copies by the clipboard, or where a page from a file has none, by the selection.
async function copied(text, code) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    getSelection().selectAllChildren(code);
    document.execCommand("copy");
  }
}

for (const root of document.querySelectorAll("figure.cells")) {
  unpacked(root).then((data) => maps.push(new Cells(root, data)));
}
