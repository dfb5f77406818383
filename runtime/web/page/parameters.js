// The list of parameters, each with a slider and a field.

import { FIRST, ends, rounded, shownAs } from "carvallo/ranges.js";
import { escaped } from "carvallo/escaped.js";

const container = document.getElementById("parameters");
let rows = new Map();

/**
 * Makes the list for a model.
 * @param {(name: string, text: string | undefined) => void} change is told a new value, or that it is the first again
 */
export function list(parameters, isBicycle, change) {
  const first = isBicycle ? FIRST : [];
  const sorted = [...parameters].sort((a, b) => rank(first, a) - rank(first, b));
  rows = new Map();
  const elements = sorted.map((parameter) => row(parameter, isBicycle, change));
  const others = document.createElement("details");
  // On a phone the results come before what is changed less often.
  others.open = first.length === 0 || matchMedia("(min-width: 900px)").matches;
  others.append(Object.assign(document.createElement("summary"), { textContent: "All other parameters" }), ...elements.slice(first.length));
  container.replaceChildren(...elements.slice(0, first.length), others);
}

const rank = (first, { name }) => (first.includes(name) ? first.indexOf(name) : first.length);

function row(parameter, isBicycle, change) {
  const as = shownAs(parameter, isBicycle);
  const element = document.createElement("div");
  const id = `p-${parameter.name}`;
  element.className = "parameter";
  element.innerHTML =
    `<label for="${id}" title="${escaped(as.hint)}"><span>${escaped(as.label)}</span> <i>${escaped(as.symbol)}</i></label>` +
    `<input type="range" id="${id}" data-name="${parameter.name}">` +
    `<input type="text" inputmode="text" id="${id}-field" autocomplete="off" spellcheck="false" aria-label="${escaped(as.label)} ${as.unit && `in ${escaped(as.unit)}`}">` +
    `<span class="unit">${escaped(as.unit)}</span>` +
    `<button type="button" class="reset" aria-label="Reset ${escaped(as.label)}" title="Reset" hidden>↺</button>`;
  const [slider, field, reset] = ["input[type=range]", "input[type=text]", "button"].map((query) => element.querySelector(query));
  if (!parameter.used) element.classList.add("unused");
  slider.addEventListener("input", () => {
    field.value = slider.value;
    change(parameter.name, as.meant(slider.value));
  });
  const typed = () => change(parameter.name, field.value.trim() === "" ? undefined : as.meant(field.value));
  field.addEventListener("change", typed);
  reset.addEventListener("click", () => {
    change(parameter.name, undefined);
    slider.focus();
  });
  rows.set(parameter.name, { parameter, as, slider, field, reset, isBicycle });
  return element;
}

/** Shows values, beside those that the design began with; what somebody writes or drags is left alone. */
export function show(parameters, values, bases, changes) {
  parameters.forEach(({ name }, index) => {
    const { parameter, as, slider, field, reset, isBicycle } = rows.get(name);
    const value = rounded(as.shown(values[index]));
    // Most parameters stay as they are while one slider moves.
    const key = `${bases[index]} ${value}`;
    // A slider that is moved keeps its ends.
    const isMoved = document.activeElement === slider && as.meant(slider.value) === changes[name];
    if (isMoved) {
      delete slider.dataset.shown;
    } else if (slider.dataset.shown !== key) {
      const [low, high, step] = ends(parameter, as.shown, bases[index], value, isBicycle);
      Object.assign(slider, { min: low, max: high, step });
      slider.value = value;
      slider.dataset.shown = key;
    }
    slider.setAttribute("aria-valuetext", `${value} ${as.unit}`);
    if (document.activeElement !== field) field.value = value;
    field.removeAttribute("aria-invalid");
    reset.hidden = changes[name] === undefined;
  });
}

/** Marks what a message says something of. */
export function blame(changes, message) {
  for (const [name, { field }] of rows) {
    const isNamed = changes[name] !== undefined && message.includes(`\`${name}\``);
    if (isNamed) field.setAttribute("aria-invalid", "true");
    else field.removeAttribute("aria-invalid");
  }
}

