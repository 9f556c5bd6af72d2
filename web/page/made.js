// Elements of the page that are not in its text.

/** An element with these properties and children. */
export function made(tag, about = {}, ...children) {
  const it = Object.assign(document.createElement(tag), about);
  it.append(...children);
  return it;
}

/** Writes a text where another stands: what is written anew is read out anew. */
export function put(it, text) {
  if (it.textContent !== text) it.textContent = text;
}

/** A button that does `press`. */
export function button(textContent, press) {
  const it = made("button", { type: "button", textContent });
  it.addEventListener("click", press);
  return it;
}
