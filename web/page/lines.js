// Lines of a control loop for the present setting, to be copied.

import { value } from "./scene.js";

/** What is said of the device's mass where the loops count a mass of the hand, too. */
const USUAL = ": a smaller limit than in the picture, safe without the hand";

/** The numbers of a scene that a loop needs; `limits` has the cap that it writes, if any, and the mass in which that counts. */
export function numbers(tree, limits) {
  const of = (key) => value(tree, key) ?? 0;
  const [, written, counted] = limits;
  const own = of("device.mass");
  // A written cap was found in a loop with its delay and all of its mass.
  const [cap, late, mass, note, more] = written >= 0
    ? [written, 0, Number(counted.toPrecision(15)), "the scene's share of m / T", " and the hand: the scene counts its cap in both"]
    : [0.5, of("effects.delay.ticks"), own, "half of m / T, less where the force is late", USUAL];
  // Behind a link, and without a mass of the hand, both are the device's.
  const whose = `kg, of the device${counted > own ? more : ""}`;
  return {
    cap, late, note, mass, whose,
    period: 1 / tree.servo_rate, damping: of("device.damping"),
    stiffness: of("environment.wall.stiffness"), wall: of("environment.wall.damping"), surface: of("environment.wall.position"),
  };
}

const real = (number, infinite) => (number === Infinity ? infinite : Number.isInteger(number) ? `${number}.0` : String(number));

/** Each stabilizer of the three loops in the library's words. */
function rustCandidate(name, it) {
  switch (name) {
    case "lolc-device-damping": return ["Lolc", `(PortEnergy, Dissipation::of(DAMPING)?)`, "Dissipation, Lolc", [`const DAMPING: f64 = ${real(it.damping)}; // N·s/m, the least that the device surely has`]];
    case "lolc-mass-spring-damper": return ["Lolc", `(PortEnergy, Wall::new(STIFFNESS, WALL_DAMPING)?.at(SURFACE).dissipation())`, "environments::Wall, Lolc", []];
    case "lolc-spring": return ["Lolc", "PortEnergy", "Lolc", []];
    default: return ["Popc", "PortEnergy", "Popc", []];
  }
}

/** Lines of Rust for the numbers of a setting under the stabilizer `name`. */
function rust(it, name) {
  const [type, candidate, uses, own] = rustCandidate(name, it);
  const none = name === "none";
  const names = none ? [] : ["DampingLimit", "PortEnergy", "Stabilizer", ...uses.split(", ")];
  const limit = `DampingLimit::of_mass(${real(it.cap, "f64::INFINITY")}, MASS, PERIOD)?${it.late ? `.delayed(${it.late})` : ""}`;
  const lines = [
    `use lyapunov::{${["ParameterError", "Reading", "Readings", ...names].sort((a, b) => a.localeCompare(b)).join(", ")}};`, "",
    `const PERIOD: f64 = ${real(it.period)}; // s`,
    ...(none ? [] : [`const MASS: f64 = ${real(it.mass)}; // ${it.whose}`, ...own]),
    `const STIFFNESS: f64 = ${real(it.stiffness)}; // N/m`, `const WALL_DAMPING: f64 = ${real(it.wall)}; // N·s/m`, `const SURFACE: f64 = ${real(it.surface)}; // m`, "",
    "/// Closes the loop for some ticks; `read` tells the position, `motor` pushes with −effort and returns the effort it applied.", 
    "pub fn control(ticks: u32, mut read: impl FnMut() -> f64, mut motor: impl FnMut(f64) -> f64) -> Result<(), ParameterError> {",
    ...(none ? [] : [`    let limit = ${limit}; // ${it.note}`, `    let mut stabilizer = ${type}::new(${candidate}, limit);`]),
    "    let mut readings = Readings::every(PERIOD)?;", "    let mut applied = 0.0;", "    for _ in 0..ticks {",
    "        let sample = readings.read(Reading { position: read(), applied }).sample;",
    "        let depth = sample.position - SURFACE;",
    "        let wall = if depth > 0.0 { (STIFFNESS * depth + WALL_DAMPING * sample.velocity).max(0.0) } else { 0.0 };",
    none ? "        applied = motor(wall);" : "        applied = motor(stabilizer.stabilize(&sample, wall).effort);",
    "    }", "    Ok(())", "}",
  ];
  return `${lines.join("\n")}\n`;
}

/** Lines of C for the same, with the header of bindings/c. */
function c(it, name) {
  const [block, extra] = {
    "lolc-device-damping": ["lolc_f64", [`    parameters.device_damping = ${real(it.damping)}; /* N.s/m, the least that the device surely has */`]],
    "lolc-mass-spring-damper": ["lolc_in_contact_f64", ["    parameters.wall_damping = wall_damping;", "    parameters.surface = surface;"]],
  }[name] ?? ["popc_f64", []];
  const none = name === "none";
  const lines = [
    ...(it.cap === Infinity ? ["#include <math.h>"] : []), "#include <lyapunov.h>", "",
    `static const double period = ${real(it.period)};       /* s */`,
    ...(none ? [] : [`static const double mass = ${real(it.mass)};         /* ${it.whose} */`]),
    `static const double stiffness = ${real(it.stiffness)};    /* N/m */`, `static const double wall_damping = ${real(it.wall)}; /* N.s/m */`, `static const double surface = ${real(it.surface)};      /* m */`, "",
    "/* Closes the loop; `read` tells the position, `motor` pushes with -effort and returns the effort it applied. 0: done. */",
    "int control(int ticks, double (*read)(void), double (*motor)(double))", "{",
    ...(none ? [] : [`    lyapunov_${block} stabilizer;`, `    lyapunov_${block}_parameters parameters = { 0 };`, "    lyapunov_correction_f64 correction;"]),
    "    lyapunov_sample_f64 sample = { 0 };", "    double before = read(), applied = 0.0;", "    int tick;", "",
    ...(none ? [] : [
      `    if (lyapunov_damping_limit_f64_of_mass(${real(it.cap, "HUGE_VAL")}, mass, period, ${it.late}, &parameters.damping_limit).code != LYAPUNOV_OK) return 1;`, ...extra,
      `    if (lyapunov_${block}_init(&stabilizer, &parameters).code != LYAPUNOV_OK) return 1;`]),
    "    sample.period = period;", "    for (tick = 0; tick < ticks; ++tick) {", "        double depth, wall;", "",
    "        sample.position = read();", "        sample.displacement = sample.position - before;", "        sample.velocity = sample.displacement / period;",
    "        sample.applied = applied;", "        sample.work = applied * sample.displacement;", "        before = sample.position;", "        depth = sample.position - surface;",
    "        wall = depth > 0.0 ? stiffness * depth + wall_damping * sample.velocity : 0.0;", "        if (wall < 0.0) wall = 0.0;",
    ...(none ? ["        applied = motor(wall);"] : [`        if (lyapunov_${block}_step(&stabilizer, &sample, wall, &correction) != LYAPUNOV_OK) return 1;`, "        applied = motor(correction.effort);"]),
    "    }", "    return 0;", "}",
  ];
  return `${lines.join("\n")}\n`;
}

/** Lines of Python for the same, with the module of bindings/python. */
function python(it, name) {
  const made = {
    none: [],
    "lolc-device-damping": [`stabilizer = lyapunov.Stabilizer("lolc", limit=limit, damping=${real(it.damping)})  # N·s/m, the least that the device surely has`],
    "lolc-mass-spring-damper": ["", "", "class Credited:", '    """The paper\'s candidate: work, and what the wall\'s damper takes in contact."""', "", "    def decrease(self, sample):", "        contact = sample.position > SURFACE", "        return sample.work + (WALL_DAMPING * sample.velocity**2 * sample.period if contact else 0.0)", "", "", 'stabilizer = lyapunov.Stabilizer("lolc", limit=limit, candidate=Credited())'],
  }[name] ?? ['stabilizer = lyapunov.Stabilizer("popc", limit=limit)'];
  const none = name === "none";
  const lines = [
    "import lyapunov", "", `PERIOD = ${real(it.period)}  # s`, `STIFFNESS = ${real(it.stiffness)}  # N/m`, `WALL_DAMPING = ${real(it.wall)}  # N·s/m`, `SURFACE = ${real(it.surface)}  # m`, "",
    ...(none ? [] : [`MASS = ${real(it.mass)}  # ${it.whose}`, `limit = lyapunov.damping_limit(MASS, PERIOD, cap=${real(it.cap, 'float("inf")')}, delay=${it.late})  # ${it.note}`]), ...made,
    "readings = lyapunov.Readings(PERIOD)", "", "",
    "def control(ticks, read, motor):", '    """Closes the loop; read() tells the position, motor(effort) pushes with -effort and returns the effort it applied."""',
    "    applied = 0.0", "    for _ in range(ticks):", "        sample = readings.read(read(), applied)", "        depth = sample.position - SURFACE",
    "        wall = max(0.0, STIFFNESS * depth + WALL_DAMPING * sample.velocity) if depth > 0 else 0.0",
    none ? "        applied = motor(wall)" : "        applied = motor(stabilizer.stabilize(sample, wall).effort)",
  ];
  return `${lines.join("\n")}\n`;
}

export const LANGUAGES = [{ name: "Rust", lines: rust }, { name: "C", lines: c }, { name: "Python", lines: python }];
