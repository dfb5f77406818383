// The designs that are shown, as buttons, and the list of what a design can start from.

import { models } from "carvallo/models.js";
import { MOST, design, state } from "carvallo/state.js";
import { saved } from "carvallo/saved.js";
import { escaped } from "carvallo/escaped.js";

const [tabs, select] = ["tabs", "base"].map((id) => document.getElementById(id));

/** Buttons for the designs; `turn` is called when they change. */
export function showTabs(titles, turn) {
  const buttons = titles.map((title, index) => {
    const isActive = index === state.active;
    const close = titles.length > 1
      ? `<button type="button" class="close" data-close="${index}" aria-label="Remove ${escaped(title)}">×</button>` : "";
    return `<span class="tab design-${index}"><button type="button" data-tab="${index}" aria-pressed="${isActive}">${escaped(title)}</button>${close}</span>`;
  });
  const more = titles.length < MOST ? `<button type="button" id="add" title="Lay a copy over what is shown">Add a copy</button>` : "";
  const focused = tabs.contains(document.activeElement) ? focusOf(document.activeElement) : undefined;
  const html = buttons.join("") + more;
  // The buttons stay while a slider moves.
  if (tabs.dataset.html !== html) {
    tabs.innerHTML = html;
    tabs.dataset.html = html;
    if (focused) (tabs.querySelector(focused) ?? tabs.querySelector("[aria-pressed=true]")).focus();
  }
  tabs.onclick = ({ target }) => {
    const { tab, close } = target.dataset;
    if (tab !== undefined) state.active = Number(tab);
    else if (close !== undefined) remove(Number(close));
    else if (target.id === "add") add();
    else return;
    turn();
  };
}

const focusOf = ({ dataset, id }) => (dataset.tab !== undefined ? `[data-tab="${dataset.tab}"]` : id ? `#${id}` : "[aria-pressed=true]");

function add() {
  const { base, changes, feedback } = state.designs[state.active];
  state.designs.push(design(base, { ...changes }, feedback));
  state.active = state.designs.length - 1;
}

function remove(index) {
  state.designs.splice(index, 1);
  if (state.active >= index && state.active > 0) state.active -= 1;
}

/** What a design can start from: what is kept here, the bicycles, and the other models with their sets. */
export function showBases() {
  const option = (value, text) => `<option value="${escaped(JSON.stringify(value))}">${escaped(text)}</option>`;
  const group = (label, options) => (options.length > 0 ? `<optgroup label="${escaped(label)}">${options.join("")}</optgroup>` : "");
  const own = Object.entries(saved()).map(([name, text]) => option({ label: name, text }, name));
  const groups = models.map(({ name, sets }) => {
    const options = sets.map((set) => option({ model: name, set: set.name }, set.kind && name === "Whipple" ? `${set.name} – ${set.kind}` : set.name));
    return [name === "Whipple" ? "Bicycles" : name, options];
  });
  const [bicycles, others] = [groups.filter(([label]) => label === "Bicycles"), groups.filter(([label]) => label !== "Bicycles")];
  select.innerHTML = group("Kept in this browser", own) + [...bicycles, ...others].map(([label, options]) => group(label, options)).join("");
}

/** Shows what the chosen design started from. */
export function showBase({ base }) {
  const value = JSON.stringify(base);
  select.querySelector("option[data-file]")?.remove();
  if (![...select.options].some((option) => option.value === value)) {
    const option = new Option(`file ${base.label ?? base.set}`, value);
    option.dataset.file = "";
    select.prepend(option);
  }
  select.value = value;
}

/** Calls `choose` with what a design is to start from. */
export function onBase(choose) {
  select.addEventListener("change", () => choose(JSON.parse(select.value)));
}
