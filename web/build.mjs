// Puts the page into one file: `node build.mjs WASM TOOLS OUT`.
//
// The program is bundled and minified, the module packed and inlined, and the content policy allows exactly these bytes.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { constants, brotliCompressSync, gzipSync } from "node:zlib";

import { packed } from "./pack.mjs";

const [wasm, tools, out] = process.argv.slice(2);
const { buildSync, transformSync } = await import(join(tools, "esbuild", "lib", "main.js")).then((it) => it.default ?? it);
const page = join(dirname(fileURLToPath(import.meta.url)), "page");
/** Bytes of the page as it is sent with gzip: what the lab takes, and what the folder that it is built in may add. */
const MOST = 367_500;

const bundle = buildSync({ entryPoints: [join(page, "main.js")], bundle: true, minify: true, format: "iife", target: "es2022", charset: "utf8", write: false });
const program = bundle.outputFiles[0].text.trim().replaceAll("</script", "<\\/script");
const style = transformSync(readFileSync(join(page, "style.css"), "utf8"), { loader: "css", minify: true }).code.trim();
/** The module made smaller: shorter code for the same, without names. */
function smaller(module) {
  const short = join(dirname(out), "page.wasm");
  const features = ["simd", "bulk-memory", "sign-ext", "mutable-globals", "nontrapping-float-to-int", "multivalue", "reference-types"];
  // Laid out flat first, after which the passes for size find more.
  // The lowest kilobyte is the far end of the stack, to which no pointer leads.
  // Functions of like names are alike: side by side they pack better than in the order in which they are called most.
  const order = ["--skip-pass=reorder-functions", "--reorder-functions-by-name"];
  const flags = ["--low-memory-unused", "--flatten", "--rereloop", "-Oz", "-Oz", ...order, ...features.map((it) => `--enable-${it}`), "--strip-debug", "--strip-producers", "--strip-target-features"];
  execFileSync(process.execPath, [join(tools, "binaryen", "bin", "wasm-opt"), ...flags, module, "-o", short]);
  return readFileSync(short);
}

mkdirSync(dirname(out), { recursive: true });
const module = smaller(wasm);
const sent = packed(module);
const rust = `${module.length} ${sent.toString("base64")}`;

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy = `default-src 'none'; script-src ${hash(program)} 'wasm-unsafe-eval'; worker-src blob:; style-src ${hash(style)}; base-uri 'none'; form-action 'none'`;

const parts = { policy, style, rust, program };
const html = readFileSync(join(page, "index.html"), "utf8").replace(/@(\w+)@/g, (_, name) => parts[name]);
writeFileSync(out, html);
const zipped = gzipSync(html, { level: constants.Z_BEST_COMPRESSION }).length;
console.log(`${out}: ${html.length} bytes, ${zipped} with gzip, ${brotliCompressSync(html).length} with brotli; of them the module ${sent.length}`);
if (zipped > MOST) {
  console.error(`the page takes ${zipped} bytes compressed: at most ${MOST}`);
  process.exitCode = 1;
}
