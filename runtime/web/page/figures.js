// The figures: the chosen design with the others beside it, and a motion of theirs.

import { drawCurves } from "carvallo/curves.js";
import { Mistake } from "carvallo/engine.js";
import { drawLocus } from "carvallo/locus.js";
import { parametersOf } from "carvallo/models.js";
import { drawMotion, simulate, usual } from "carvallo/motion.js";
import { drawNumbers } from "carvallo/numbers.js";
import { drawSide } from "carvallo/side.js";
import { active, state, withChanges } from "carvallo/state.js";

const at = (id) => document.getElementById(id);

/** How the motions begin. */
export const initial = (known) => state.initial || usual(known.coordinates);

const drawing = (id) => document.querySelector(`#${id} .drawing`);
export const widthOf = (id) => Math.max(240, Math.floor(drawing(id).clientWidth));
/** Before anything is written: a size that is read after that waits for the layout of the whole page, each time. */
export const measure = () => Object.fromEntries(["eigenvalues", "locus", "motion"].map((id) => [id, widthOf(id)]));

/** What stands in each drawing: a browser takes its time even where the same is written again. */
const written = {};

function fill(id, content) {
  if (written[id] === content) return;
  drawing(id).innerHTML = written[id] = content;
}

/**
 * Draws all figures.
 * @param {object} known the chosen design, as it was analyzed
 * @param {{known: object, other: object, place: number}[]} beside the others
 * @param {Object<string, number>} widths what {@link measure} found
 */
export function draw(known, beside, widths) {
  const map = (of) => new Map(parametersOf(of).map(({ name }, index) => [name, of.values[index]]));
  const title = withChanges(known.title, active());
  const named = { ...known, title };
  const thin = beside.map(({ known: other, other: of, place }) => ({ known: { ...other, title: withChanges(other.title, of) }, place }));
  const side = drawSide(title, map(known), beside.map(({ known: other, place }) => ({ values: map(other), place })), widths.eigenvalues);
  at("side").hidden = side === undefined;
  fill("side", side ?? "");
  fill("eigenvalues", drawCurves(named, thin, state.speed, widths.eigenvalues));
  fill("locus", drawLocus(named, thin, state.speed, widths.locus));
  fill("numbers", drawNumbers(named, state.speed));
  move(named, thin, widths.motion);
}

function move(known, beside, width) {
  const start = initial(known);
  const error = at("motion-error");
  if (document.activeElement !== at("initial")) at("initial").value = start;
  if (document.activeElement !== at("duration")) at("duration").value = state.duration;
  at("initial-hint").textContent = `Positions and rates, such as ${usual(known.coordinates)}, or phi=5 deg; with commas between them.`;
  try {
    const motion = simulate(active(), start);
    const others = beside.flatMap(({ known: other, place }) => {
      try {
        return [{ motion: simulate(state.designs[place], start), title: other.title, place }];
      } catch {
        // Another model may have no such quantities.
        return [];
      }
    });
    fill("motion", drawMotion(known.title, motion, others, width));
    error.hidden = true;
  } catch (mistake) {
    if (!(mistake instanceof Mistake)) throw mistake;
    Object.assign(error, { textContent: mistake.message, hidden: false });
  }
}
