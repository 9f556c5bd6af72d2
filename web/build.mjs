// Puts the page into one file: `node build.mjs WASM ESBUILD OUT`.
//
// The program is bundled and minified, the module deflated and inlined, and the content policy allows exactly these bytes.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { constants, brotliCompressSync, gzipSync } from "node:zlib";

const [wasm, esbuild, out] = process.argv.slice(2);
const { buildSync, transformSync } = await import(join(esbuild, "lib", "main.js")).then((it) => it.default ?? it);
const page = join(dirname(fileURLToPath(import.meta.url)), "page");
/** Bytes of the page as it is sent: what the lab takes, and a little more. */
const MOST = 800_000;

const bundle = buildSync({ entryPoints: [join(page, "main.js")], bundle: true, minify: true, format: "iife", target: "es2022", charset: "utf8", write: false });
const program = bundle.outputFiles[0].text.trim().replaceAll("</script", "<\\/script");
const style = transformSync(readFileSync(join(page, "style.css"), "utf8"), { loader: "css", minify: true }).code.trim();
/** A module without its custom sections: names of functions and of tools. */
function stripped(module) {
  const kept = [module.subarray(0, 8)];
  for (let at = 8; at < module.length; ) {
    const begin = at;
    const kind = module[at++];
    let [length, shift, byte] = [0, 0, 128];
    while (byte & 128) {
      byte = module[at++];
      length |= (byte & 127) << shift;
      shift += 7;
    }
    at += length;
    if (kind !== 0) kept.push(module.subarray(begin, at));
  }
  return Buffer.concat(kept);
}

const rust = gzipSync(stripped(readFileSync(wasm)), { level: constants.Z_BEST_COMPRESSION }).toString("base64");

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy = `default-src 'none'; script-src ${hash(program)} 'wasm-unsafe-eval'; worker-src blob:; style-src ${hash(style)}; base-uri 'none'; form-action 'none'`;

const parts = { policy, style, rust, program };
const html = readFileSync(join(page, "index.html"), "utf8").replace(/@(\w+)@/g, (_, name) => parts[name]);
mkdirSync(dirname(out), { recursive: true });
writeFileSync(out, html);
const sent = gzipSync(html, { level: constants.Z_BEST_COMPRESSION }).length;
console.log(`${out}: ${html.length} bytes, ${sent} with gzip, ${brotliCompressSync(html).length} with brotli`);
if (sent > MOST) {
  console.error(`the page takes ${sent} bytes compressed: at most ${MOST}`);
  process.exitCode = 1;
}
