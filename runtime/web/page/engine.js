// The WebAssembly module: questions go in as JSON, answers come out as JSON and an array of numbers.

/** What the module says is wrong: the message of the command line. */
export class Mistake extends Error {}

let module;
let exports;

/** Loads the module: from the page itself where that carries it, or else from the file beside the page. */
export async function load() {
  const carried = document.getElementById("wasm");
  const bytes = carried ? decode(carried.textContent) : await fetched("carvallo.wasm");
  module = await WebAssembly.compile(bytes);
  await start();
}

async function start() {
  exports = (await WebAssembly.instantiate(module)).exports;
}

async function fetched(name) {
  const response = await fetch(new URL(name, document.baseURI));
  if (!response.ok) throw new Error(`${name} cannot be loaded: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

function decode(base64) {
  return Uint8Array.from(atob(base64.trim()), (char) => char.charCodeAt(0));
}

/**
 * Asks a question. The numbers are a copy, which stays.
 * @returns {{reply: any, numbers: Float64Array}}
 * @throws {Mistake} what is wrong with what was asked for
 */
export function ask(question) {
  const { text, numbers } = answer(JSON.stringify(question));
  const reply = JSON.parse(text);
  if (reply.error !== undefined) throw new Mistake(reply.error);
  return { reply, numbers };
}

function answer(question) {
  const bytes = new TextEncoder().encode(question);
  try {
    const place = exports.reserve(bytes.length);
    // The memory may have grown: views of it are made anew after each call.
    new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
    exports.ask();
    const text = new Uint8Array(exports.memory.buffer, exports.text(), exports.text_length());
    const numbers = new Float64Array(exports.memory.buffer, exports.numbers(), exports.numbers_length());
    return { text: new TextDecoder().decode(text), numbers: numbers.slice() };
  } catch (error) {
    // What has stopped in the middle is not to be used again.
    start();
    throw new Mistake(`this is a fault of the page, please report it: ${error.message}`);
  }
}
