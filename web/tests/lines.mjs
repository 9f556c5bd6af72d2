// The lines that the page offers for a loop of one's own.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { address } from "../page/scene.js";
import { closed, credit, folder, opened, root } from "./driver.mjs";

const [SMALLER, BOTH] = [": a smaller limit than in the picture", " and the hand"];
const LATE = { delay: { ticks: 2 } };
const CAP = { popc: { damping_cap: 0.3 } };
/** Settings whose lines are looked at, each with cap, delay and mass of the limit, and what is said of the mass. The hand has 0.1 kg, the
 *  device 0.2 kg: a cap that the scene writes counts in both, but for a link, and has the delay in it. */
const SETTINGS = [
  [{}, "0.5", 0, "0.2", SMALLER],
  [{ effects: LATE }, "0.5", 2, "0.2", SMALLER],
  [{ effects: LATE, stabilizer: CAP }, "0.3", 0, "0.3", BOTH],
  [{ stabilizer: { popc: { damping_cap: 0.5 } } }, "0.5", 0, "0.3", BOTH],
  [{ stabilizer: CAP, link: { stiffness: 3000, damping: 2 } }, "0.3", 0, "0.2", ""],
];

/** Lines that the page offers in a language in each setting. */
async function offered(browser, language) {
  const [all, first] = [[], await opened(browser)];
  const tree = await first.value("lyapunov.state.tree");
  await closed(first);
  for (const [more, cap, late, mass, said] of SETTINGS) {
    const page = await opened(browser, {}, `#${address({ ...tree, ...more })}`);
    const here = await offeredHere(page, language);
    const limit = {
      Rust: [`of_mass(${cap}, MASS, PERIOD)?${late ? `.delayed(${late})` : ""};`, `MASS: f64 = ${mass}; // kg, of the device${said}`],
      C: [`of_mass(${cap}, mass, period, ${late},`, `mass = ${mass};         /* kg, of the device${said}`],
      Python: [`(MASS, PERIOD, cap=${cap}, delay=${late})`, `MASS = ${mass}  # kg, of the device${said}`],
    };
    const told = here.filter((it) => limit[language].every((part) => it.includes(part)));
    assert.equal(told.length, 4, `${language}: ${limit[language]}\n${here[1]}`);
    all.push(...here);
    await closed(page);
  }
  for (const text of all) assert.ok(!/undefined|NaN/.test(text), text);
  return all;
}

/** Lines that the page offers in a language, under no stabilizer, POPC and LOLC with each candidate. */
async function offeredHere(page, language) {
  const all = [];
  const copied = `(() => { [...document.querySelectorAll('#lines button')].find((it) => it.textContent.includes(" ${language} ")).click(); return document.querySelector('#code').textContent; })()`;
  await credit(page, "lolc-mass-spring-damper");
  for (const index of [0, 1, 2]) {
    await page.value(`document.querySelector('#why-of button[data-index="${index}"]').click()`);
    all.push(await page.value(copied));
  }
  for (const name of ["lolc-device-damping", "lolc-spring"]) {
    await credit(page, name);
    all.push(await page.value(copied));
  }
  assert.ok(new Set(all).size >= 4, `${language}: too few different loops`);
  return all;
}

/** Lines that the page offers: they compile without a warning. */
export async function lines(browser) {
  const crate = join(folder, "lines");
  mkdirSync(join(crate, "src"), { recursive: true });
  writeFileSync(join(crate, "Cargo.toml"), `[workspace]\n[package]\nname = "lines"\nversion = "0.0.0"\nedition = "2024"\n[dependencies]\nlyapunov = { path = ${JSON.stringify(root)} }\n`);
  const modules = (await offered(browser, "Rust")).map((text, index) => `mod it${index} {\n${text}}\n`);
  writeFileSync(join(crate, "src/lib.rs"), `//! Lines from the page.\n#![allow(dead_code)]\n${modules.join("")}`);
  const env = { ...process.env, RUSTFLAGS: "-D warnings", CARGO_TARGET_DIR: process.env.CARGO_TARGET_DIR ?? join(root, "target") };
  execFileSync("cargo", ["check", "--quiet", "--manifest-path", join(crate, "Cargo.toml")], { env, stdio: "inherit" });

  const header = process.env.LYAPUNOV_H ?? join(root, "bindings/c/include");
  for (const [index, text] of (await offered(browser, "C")).entries()) {
    const source = join(folder, `control-${index}.c`);
    writeFileSync(source, text);
    if (existsSync(join(header, "lyapunov.h"))) execFileSync("cc", ["-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I", header, source], { stdio: "inherit" });
    else if (index === 0) console.log("SKIPPED: the C lines: there is no bindings/c/include/lyapunov.h");
  }
  for (const text of await offered(browser, "Python")) execFileSync("python3", ["-c", "import sys; compile(sys.stdin.read(), 'control.py', 'exec')"], { input: text });
}
