// Files that come in, by the button or dropped on the page, and files that go out.

import { ask } from "carvallo/engine.js";
import { active, subject } from "carvallo/state.js";
import { asked } from "carvallo/motion.js";
import { standalone } from "carvallo/standalone.js";

/** Calls `read` with the name and text of a file that was chosen or dropped, or `fail` with what is wrong. */
export function onFile(read, fail) {
  const input = document.getElementById("file");
  const take = async (file) => {
    if (!file) return;
    try {
      read(file.name, new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer()));
    } catch (error) {
      fail(error instanceof TypeError ? `${file.name}: this is not UTF-8 text` : error.message);
    }
  };
  document.getElementById("open").addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    take(input.files[0]);
    // So that the same file can be chosen again after it was mended.
    input.value = "";
  });
  const over = (isOver) => (event) => {
    event.preventDefault();
    document.body.classList.toggle("over", isOver);
  };
  document.addEventListener("dragover", over(true));
  document.addEventListener("dragleave", over(false));
  document.addEventListener("drop", (event) => {
    over(false)(event);
    take(event.dataTransfer.files[0]);
  });
}

/** What the engine writes: the name of the file there, its ending here, and what it is. */
const FILES = [
  ["toml", ".toml", "TOML", "the parameters, to open here or with the command line"],
  ["json", ".json", "JSON", "matrices, critical speeds and eigenvalues"],
  ["csv", ".csv", "CSV", "eigenvalues against speed"],
  ["motion csv", "-motion.csv", "CSV: motion", "the motion, row by row"],
];

/** The figures that can be taken away as they are, with the other designs in them. */
const FIGURES = [["eigenvalues", "eigenvalues"], ["side", "side view"], ["locus", "root locus"], ["motion", "motion"]];

/** The buttons that write files of the chosen design; `initial` says how its motion begins. */
export function showDownloads(initial, title, fail) {
  const container = document.getElementById("downloads");
  const add = (name, about, file, ending, contents) => {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name, title: about });
    button.dataset.file = file;
    button.addEventListener("click", () => {
      try {
        save(`${slug(title())}${ending}`, contents());
        fail(undefined);
      } catch (error) {
        fail(error.message);
      }
    });
    container.append(button);
  };
  for (const [file, ending, name, about] of FILES) {
    const question = () => ({ ask: "write", file, design: subject(active()), motion: asked(initial()) });
    add(name, about, file, ending, () => ask(question()).reply.contents);
  }
  for (const [id, name] of FIGURES) {
    add(`SVG: ${name}`, `the ${name} as it is shown`, `${id} svg`, `-${id}.svg`, () => standalone(document.getElementById(id)));
  }
}

/** The parameters of the chosen design as TOML, under a name of its own. */
export function toml(name) {
  return ask({ ask: "write", file: "toml", design: { ...subject(active()), name } }).reply.contents;
}

function save(name, contents) {
  const url = URL.createObjectURL(new Blob([contents]));
  Object.assign(document.createElement("a"), { href: url, download: name }).click();
  URL.revokeObjectURL(url);
}

const slug = (title) => title.toLowerCase().replace(/[^\p{L}\p{N}._-]+/gu, "-").replace(/^-|-$/g, "") || "design";
