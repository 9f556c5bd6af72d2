// Data of the figures of a page, and elements that hold text only.

// The data of a figure: JSON, deflated, in base64.
async function unpacked(figure) {
  const text = figure.querySelector("script.data").textContent;
  const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

// An element of a class with a text; names come from files, so nothing is ever parsed as markup.
function element(tag, name, text) {
  const made = document.createElement(tag);
  if (name) made.className = name;
  if (text !== undefined) made.textContent = text;
  return made;
}

// A number in its shortest form, "-" where there is none.
function told(value, digits = 6) {
  if (!Number.isFinite(value)) return "-";
  const rounded = Number(value.toPrecision(digits));
  return rounded !== 0 && Math.abs(rounded) < 1e-3 ? rounded.toExponential() : String(rounded);
}
