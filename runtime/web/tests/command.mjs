// What the tests hold the page against: the command line, and the module without the page.

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const target = process.env.CARGO_TARGET_DIR ?? `${root}/target`;

/** The page as it was built. */
export const dist = `${target}/web/dist`;

/** The page as one file. */
export const single = `${target}/web/carvallo.html`;

/** Where npm has put what the tests need. */
export const packages = `${target}/npm/`;

/** What the command line prints. */
export const carvallo = (...parameters) => execFileSync(`${target}/debug/carvallo`, parameters, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });

/** The module as the page has it, without a page: what a question is answered by, or what is wrong. */
export async function engine() {
  const { instance: { exports } } = await WebAssembly.instantiate(readFileSync(`${dist}/carvallo.wasm`));
  return (question) => {
    const bytes = new TextEncoder().encode(JSON.stringify(question));
    const place = exports.reserve(bytes.length);
    new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
    exports.ask();
    const text = new Uint8Array(exports.memory.buffer, exports.text(), exports.text_length());
    const numbers = new Float64Array(exports.memory.buffer, exports.numbers(), exports.numbers_length());
    return { reply: JSON.parse(new TextDecoder().decode(text)), numbers: numbers.slice() };
  };
}
