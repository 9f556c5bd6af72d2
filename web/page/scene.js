// A scene as a tree of tables, and its forms: a TOML file, an address.

/** Values that need not be written. */
const DEFAULTS = { velocity: "backward-difference", scalar: "f64", integrator: "exact" };
const ZERO = ["operator", "device", "initial"];

/** The value at a dotted key, or undefined. */
export function value(tree, key) {
  return key.split(".").reduce((table, name) => table?.[name], tree);
}

/** A copy of the tree with `to` at a dotted key; undefined takes the key away, and the tables that are left empty. */
export function changed(tree, key, to) {
  const [name, ...rest] = key.split(".");
  const copy = { ...tree };
  copy[name] = rest.length ? changed(tree[name] ?? {}, rest.join("."), to) : to;
  const empty = rest.length && to === undefined && Object.keys(copy[name]).length === 0;
  if (copy[name] === undefined || empty) delete copy[name];
  return copy;
}

const isTable = (it) => typeof it === "object" && it !== null && !Array.isArray(it);

/** All pairs of dotted key and value. */
export function pairs(tree, above = "") {
  return Object.entries(tree).flatMap(([name, it]) => (isTable(it) ? pairs(it, `${above}${name}.`) : [[above + name, it]]));
}

/** The tree of these pairs. */
export const treeOf = (list) => list.reduce((tree, [key, it]) => changed(tree, key, it), {});

/** The tree without what every scene has by default. JSON has no infinity and says null instead. */
export function bare(tree) {
  const said = pairs(tree).filter(([key, it]) => {
    const table = key.slice(0, key.lastIndexOf("."));
    return DEFAULTS[key] !== it && !(it === 0 && ZERO.includes(table));
  });
  return treeOf(said.map(([key, it]) => [key, it ?? Infinity]));
}

/** The scene as a TOML file. */
export function toml(tree) {
  const written = (it) => (it === Infinity ? "inf" : JSON.stringify(it));
  const lines = [];
  const write = (table, path) => {
    const entries = Object.entries(table);
    const own = entries.filter(([, it]) => !isTable(it));
    if (path && (own.length || !entries.length)) lines.push("", `[${path}]`);
    for (const [key, it] of own) lines.push(`${key} = ${written(it)}`);
    for (const [key, it] of entries) if (isTable(it)) write(it, path ? `${path}.${key}` : key);
  };
  write(tree, "");
  return `${lines.join("\n").trim()}\n`;
}

/** The scene, or any tree, as the part of an address after `#`. */
export const address = (tree) => pairs(tree).map(([key, it]) => `${key}=${encodeURIComponent(JSON.stringify(it))}`).join("&");

/** The scene in the part of an address after `#`; none where it holds none. */
export function ofAddress(hash) {
  const parts = hash.replace(/^#/, "").split("&").filter((part) => part.includes("="));
  if (!parts.length) return null;
  const read = (part) => {
    const at = part.indexOf("=");
    return [part.slice(0, at), JSON.parse(decodeURIComponent(part.slice(at + 1))) ?? Infinity];
  };
  return treeOf(parts.map(read));
}
