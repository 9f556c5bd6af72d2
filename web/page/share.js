// What one takes along: the address, the scene, its rows, lines for a loop of one's own.

import { bare, toml, value } from "./scene.js";

const LIMIT_NOTE = "half of m / T, less where the force is late";

/** The numbers of a scene that a loop needs. */
function numbers(tree) {
  const of = (key) => value(tree, key) ?? 0;
  return {
    period: 1 / tree.servo_rate, mass: of("device.mass"), damping: of("device.damping"), delay: of("effects.delay.ticks"),
    stiffness: of("environment.wall.stiffness"), wall: of("environment.wall.damping"), surface: of("environment.wall.position"),
  };
}

const real = (number) => (Number.isInteger(number) ? `${number}.0` : String(number));

/** Each stabilizer of the three loops in the library's words. */
function rustCandidate(name, it) {
  switch (name) {
    case "lolc-device-damping": return ["Lolc", `(PortEnergy, Dissipation::of(DAMPING)?)`, "Dissipation, Lolc", [`const DAMPING: f64 = ${real(it.damping)}; // N·s/m, the least that the device surely has`]];
    case "lolc-mass-spring-damper": return ["Lolc", `(PortEnergy, Wall::new(STIFFNESS, WALL_DAMPING)?.at(SURFACE).dissipation())`, "environments::Wall, Lolc", []];
    case "lolc-spring": return ["Lolc", "PortEnergy", "Lolc", []];
    default: return ["Popc", "PortEnergy", "Popc", []];
  }
}

/** Lines of Rust for the setting under the stabilizer `name`. */
export function rust(tree, name) {
  const it = numbers(tree);
  const [type, candidate, uses, own] = rustCandidate(name, it);
  const none = name === "none";
  const names = none ? [] : ["DampingLimit", "PortEnergy", "Stabilizer", ...uses.split(", ")];
  const limit = `DampingLimit::of_mass(0.5, MASS, PERIOD)?${it.delay ? `.delayed(${it.delay})` : ""}`;
  const lines = [
    `use lyapunov::{${["ParameterError", "Reading", "Readings", ...names].sort((a, b) => a.localeCompare(b)).join(", ")}};`, "",
    `const PERIOD: f64 = ${real(it.period)}; // s`,
    ...(none ? [] : [`const MASS: f64 = ${real(it.mass)}; // kg, the smallest mass that moves`, ...own]),
    `const STIFFNESS: f64 = ${real(it.stiffness)}; // N/m`, `const WALL_DAMPING: f64 = ${real(it.wall)}; // N·s/m`, `const SURFACE: f64 = ${real(it.surface)}; // m`, "",
    "/// Closes the loop for some ticks; `read` tells the position, `motor` pushes with −effort and returns the effort it applied.", 
    "pub fn control(ticks: u32, mut read: impl FnMut() -> f64, mut motor: impl FnMut(f64) -> f64) -> Result<(), ParameterError> {",
    ...(none ? [] : [`    let limit = ${limit}; // ${LIMIT_NOTE}`, `    let mut stabilizer = ${type}::new(${candidate}, limit);`]),
    "    let mut readings = Readings::every(PERIOD)?;", "    let mut applied = 0.0;", "    for _ in 0..ticks {",
    "        let sample = readings.read(Reading { position: read(), applied }).sample;",
    "        let depth = sample.position - SURFACE;",
    "        let wall = if depth > 0.0 { (STIFFNESS * depth + WALL_DAMPING * sample.velocity).max(0.0) } else { 0.0 };",
    none ? "        applied = motor(wall);" : "        applied = motor(stabilizer.stabilize(&sample, wall).effort);",
    "    }", "    Ok(())", "}",
  ];
  return `${lines.join("\n")}\n`;
}

export const LANGUAGES = [{ name: "Rust", file: "control.rs", lines: rust }];

function save(name, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1e3);
}

/** Wires the buttons; `now` tells the scene and the stabilizer, `open` takes a dropped text. */
export function wire({ $, engine, now, open }) {
  const done = (text) => ($("done").textContent = text);
  const copy = async (text, what) => {
    try {
      await navigator.clipboard.writeText(text);
      done(`${what} copied.`);
    } catch {
      done(`${what}: select and copy it below.`);
    }
  };
  const scene = () => {
    const { tree, name } = now();
    return toml(bare(JSON.parse(engine.text("read", `${name}\n${toml(tree)}`))));
  };
  $("copy-address").addEventListener("click", () => copy(location.href, "The address"));
  $("download").addEventListener("click", () => {
    save("scene.toml", scene());
    done("The scene is in scene.toml: lyapunov run scene.toml");
  });
  $("download-rows").addEventListener("click", () => save("rows.csv", engine.text("rows", scene())));
  for (const { name, lines } of LANGUAGES) {
    const button = document.createElement("button");
    Object.assign(button, { type: "button", textContent: `copy the ${name} lines` });
    button.addEventListener("click", () => {
      const text = lines(now().tree, now().name);
      $("code").hidden = false;
      $("code").textContent = text;
      copy(text, `The ${name} lines`);
    });
    $("lines").append(button);
  }
  const read = async (file) => file && open(file.name, await file.text());
  $("open").addEventListener("change", () => read($("open").files[0]));
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    read(event.dataTransfer.files[0]);
  });
}
