// What one takes along: the address, the scene, its rows, lines for a loop of one's own.

import { LANGUAGES, numbers } from "./lines.js";
import { button, made } from "./made.js";
import { toml } from "./scene.js";

function save(name, text) {
  const link = made("a", { href: URL.createObjectURL(new Blob([text], { type: "text/plain" })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1e3);
}

/** Wires the buttons; `now` tells the scene, its stabilizer and what that is called, `open` takes dropped files. */
export function wire({ $, engine, now, open }) {
  const done = (text) => ($("done").textContent = text);
  const copy = async (text, what, of = "") => {
    try {
      await navigator.clipboard.writeText(text);
      done(`${what} copied${of}.`);
    } catch {
      done(`${what}: select and copy it below.`);
      $("code").hidden = false;
      $("code").textContent = text;
    }
  };
  const scene = () => toml(now().tree);
  $("copy-address").addEventListener("click", () => copy(location.href, "The address"));
  $("download").addEventListener("click", () => {
    save("scene.toml", scene());
    done("The scene is in scene.toml: lyapunov run scene.toml");
  });
  $("download-rows").addEventListener("click", () => save("rows.csv", engine.text("rows", scene())));
  for (const { name, lines } of LANGUAGES) {
    $("lines").append(button(`copy the ${name} lines`, () => {
      const at = now();
      const text = lines(numbers(at.tree, engine.numbers("limits", toml(at.tree))), at.name);
      $("code").hidden = false;
      $("code").textContent = text;
      copy(text, `The ${name} lines`, `: ${at.title}, the loop chosen under Why`);
    }));
  }
  const read = async (files) => open(await Promise.all([...files].map(async (file) => ({ name: file.name, text: await file.text() }))));
  $("open").addEventListener("change", () => read($("open").files));
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    read(event.dataTransfer.files);
  });
}
