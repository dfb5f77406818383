// The page as a whole: what happens when something is changed.

import { analyze, eigenvalues } from "carvallo/analysis.js";
import { onBase, showBase, showBases, showTabs } from "carvallo/choice.js";
import { Mistake, load } from "carvallo/engine.js";
import { blameFeedback, onFeedback, showFeedback } from "carvallo/feedback.js";
import { draw, drawUnseen, initial, measure, widthOf } from "carvallo/figures.js";
import { onFile, showDownloads, toml } from "carvallo/files.js";
import { loadModels, parametersOf } from "carvallo/models.js";
import { sentence } from "carvallo/numbers.js";
import { blame, list, show } from "carvallo/parameters.js";
import { forget, save, saved } from "carvallo/saved.js";
import { MOST, active, design, fromHash, state, toHash, withChanges } from "carvallo/state.js";

const at = (id) => document.getElementById(id);
/** Of what the list of parameters is made. */
let listed;

const isBicycle = (parameters) => ["w", "c", "lam", "rR", "rF"].every((name) => parameters.some((parameter) => parameter.name === name));

/** Computes everything anew, and shows it; a mistake is told, and what was there before stays. */
function update() {
  schedule.address();
  const widths = measure();
  let known;
  try {
    known = { ...analyze(active()), at_speed: eigenvalues(active(), state.speed) };
  } catch (error) {
    if (!(error instanceof Mistake)) throw error;
    fail(error.message);
    blame(active().changes, error.message);
    blameFeedback(error.message);
    titles();
    return;
  }
  fail(undefined);
  const others = state.designs.map((other, place) => ({ other, place })).filter(({ place }) => place !== state.active);
  const beside = others.flatMap(({ other, place }) => {
    try {
      return [{ known: analyze(other), other, place }];
    } catch {
      // It is told when it is chosen.
      return [];
    }
  });
  titles();
  showFeedback(known);
  showParameters(known);
  showNotes([...known.warnings, ...known.notes]);
  showSpeed(known);
  draw(known, beside, widths);
}

/** Takes steps of a slider where nobody waits for them or sees them: in the first ones a browser compiles what it needs. */
function rehearse(steps, unseen = document.createElement("div")) {
  if (steps === 0 || !globalThis.requestIdleCallback) return;
  requestIdleCallback(() => {
    try {
      const known = analyze(active());
      const [{ name }] = parametersOf(known);
      const step = { ...active(), changes: { ...active().changes, [name]: String(known.values[0] * (1 + 1e-3 * steps)) } };
      drawUnseen(unseen, step, { ...analyze(step), at_speed: eigenvalues(step, state.speed) }, measure());
    } catch (error) {
      // What is wrong with a design was told when it was shown.
      if (!(error instanceof Mistake)) throw error;
    }
    rehearse(steps - 1, unseen);
  });
}

function titles() {
  const title = (other) => {
    try {
      return withChanges(analyze(other).title, other);
    } catch {
      return withChanges(other.base.set ?? other.base.label, other);
    }
  };
  showTabs(state.designs.map(title), changed);
  showBase(active());
  at("forget").hidden = !(active().base.label in saved());
}

function showParameters(known) {
  const parameters = parametersOf(known);
  const key = parameters.map(({ name }) => name).join(" ");
  if (listed !== key) {
    list(parameters, isBicycle(parameters), change);
    listed = key;
  }
  const base = analyze(design(active().base));
  show(parameters, known.values, base.values, active().changes);
}

function change(name, text) {
  const { changes } = active();
  if (text === undefined) delete changes[name];
  else changes[name] = text;
  schedule.update();
}

function showNotes(notes) {
  at("notes").hidden = notes.length === 0;
  at("notes").replaceChildren(...notes.map((note) => Object.assign(document.createElement("li"), { textContent: note })));
}

function showSpeed(known) {
  at("stable").textContent = `${withChanges(known.title, active())}: ${sentence(known)}`;
  at("stable").classList.toggle("good", known.stable_ranges.length > 0);
  const slider = at("speed");
  slider.max = Math.max(known.range[1], state.speed);
  slider.step = known.range[1] / 1000;
  slider.disabled = at("speed-field").disabled = !known.moves;
  slider.value = state.speed;
  slider.setAttribute("aria-valuetext", `${state.speed} m/s`);
  if (document.activeElement !== at("speed-field")) at("speed-field").value = state.speed;
}

function fail(message) {
  const box = at("error");
  box.hidden = message === undefined;
  box.textContent = message ?? "";
}

const say = (message) => Object.assign(at("status"), { textContent: message });

/** After something other than a value has changed. */
function changed() {
  say("");
  at("address").hidden = true;
  update();
}

/** What happens at most once a frame, and what happens when nothing more comes. */
const schedule = (() => {
  let frame;
  let timer;
  return {
    update() {
      frame ??= requestAnimationFrame(() => {
        frame = undefined;
        update();
      });
    },
    address() {
      clearTimeout(timer);
      timer = setTimeout(() => history.replaceState(null, "", `#${toHash()}`), 150);
    },
  };
})();

function start(base) {
  state.designs[state.active] = design(base);
  changed();
}

function read(label, text) {
  const added = design({ label, text });
  const found = analyze(added);
  if (state.designs.length < MOST) state.designs.push(added);
  else state.designs[state.active] = added;
  state.active = state.designs.indexOf(added);
  changed();
  say(`${found.title} was read from ${label}.`);
}

function listen() {
  onBase(start);
  onFeedback(changed);
  onFile(read, (message) => {
    say("");
    fail(message);
  });
  at("speed").addEventListener("input", () => {
    state.speed = Number(at("speed").value);
    at("speed-field").value = state.speed;
    schedule.update();
  });
  numberField("speed-field", "speed", (value) => value >= 0, "the speed must be a number >= 0");
  numberField("duration", "duration", (value) => value > 0 && value <= 60, "the duration must be a number > 0 and <= 60");
  at("initial").addEventListener("change", () => {
    state.initial = at("initial").value.trim();
    changed();
  });
  at("start").addEventListener("submit", (event) => event.preventDefault());
  at("save").addEventListener("submit", keep);
  at("forget").addEventListener("click", () => {
    const { label } = active().base;
    forget(label);
    showBases();
    changed();
    say(`${label} is no longer kept in this browser.`);
  });
  at("share").addEventListener("click", share);
  addEventListener("hashchange", () => {
    if (location.hash === `#${toHash()}`) return;
    open();
  });
  let width;
  new ResizeObserver(() => {
    if (width !== undefined && width !== widthOf("eigenvalues")) schedule.update();
    width = widthOf("eigenvalues");
  }).observe(at("figures"));
}

function numberField(id, key, isGood, required) {
  const field = at(id);
  field.addEventListener("change", () => {
    const value = Number(field.value);
    const good = field.value.trim() !== "" && isGood(value);
    field.toggleAttribute("aria-invalid", !good);
    if (!good) return fail(`${required}, but it is \`${field.value}\``);
    state[key] = value;
    changed();
  });
}

function keep(event) {
  event.preventDefault();
  const name = at("name").value.trim();
  try {
    if (!name) throw new Error("a name is missing, under which the design is kept");
    const text = toml(name);
    save(name, text);
    showBases();
    start({ label: name, text });
    say(`${name} is kept in this browser.`);
  } catch (error) {
    fail(error.message);
  }
}

async function share() {
  history.replaceState(null, "", `#${toHash()}`);
  const field = at("address");
  Object.assign(field, { value: location.href, hidden: false });
  field.select();
  try {
    await navigator.clipboard.writeText(location.href);
    say("The address is copied: it has all of the designs in it.");
  } catch {
    say("This address has all of the designs in it.");
  }
}

/** Shows what the address has. */
function open() {
  try {
    fromHash(location.hash);
  } catch (error) {
    fromHash("");
    changed();
    fail(error.message);
    return;
  }
  changed();
}

try {
  await load();
  loadModels();
  showBases();
  showDownloads(() => initial(analyze(active())), () => analyze(active()).title, fail);
  listen();
  open();
  document.body.dataset.ready = "";
  rehearse(12);
} catch (error) {
  fail(`The page cannot start: ${error.message}`);
  throw error;
}
