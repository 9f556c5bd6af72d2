// Tables that sort by the heading that is pressed: upwards, downwards, then as they came.

// The number that a cell begins with, after a sign of comparison; none for words.
function numberOf(text) {
  const found = text.replace(/\u2212/g, "-").match(/^[\s~<>=\u2264\u2265]*([-+]?\d*\.?\d+(?:e[-+]?\d+)?)/i);
  return found ? Number(found[1]) : null;
}

// Numbers by size and words by the alphabet; what is empty or "-" comes last in either direction.
function compared(one, other, isNumber, direction) {
  const [a, b] = [one, other].map((text) => (isNumber ? numberOf(text) : /^[-\u2013]?$/.test(text) ? null : text));
  if (a === null || b === null) return (a === null) - (b === null);
  return direction * (isNumber ? a - b : a.localeCompare(b, "en", { numeric: true }));
}

function sortable(table) {
  const body = table.tBodies[0];
  const rows = [...body.rows];
  const headings = [...table.tHead.rows[0].cells];
  if (rows.length < 2 || rows.some((row) => row.cells.length !== headings.length)) return;
  headings.forEach((heading, column) => {
    if (heading.textContent.trim() === "") return;
    const button = element("button", "sort");
    button.type = "button";
    button.title = "Sort by this column";
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => {
      const next = { none: "ascending", ascending: "descending", descending: "none" };
      const order = next[heading.getAttribute("aria-sort") ?? "none"];
      headings.forEach((other) => other.removeAttribute("aria-sort"));
      const direction = { ascending: 1, descending: -1 }[order];
      const text = (row) => row.cells[column].textContent.trim();
      const isNumber = heading.classList.contains("number");
      const sorted = direction
        ? [...rows].sort((one, other) => compared(text(one), text(other), isNumber, direction))
        : rows;
      if (direction) heading.setAttribute("aria-sort", order);
      body.append(...sorted);
    });
  });
}

document.querySelectorAll("table").forEach((table) => table.tHead && sortable(table));
