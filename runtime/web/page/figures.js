// The figures: the chosen design with the others beside it, and a motion of theirs.

import { drawCurves } from "carvallo/curves.js";
import { Mistake } from "carvallo/engine.js";
import { drawLocus } from "carvallo/locus.js";
import { parametersOf } from "carvallo/models.js";
import { drawMotion, simulate, usual } from "carvallo/motion.js";
import { fill } from "carvallo/nodes.js";
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

/**
 * Draws all figures.
 * @param {object} known the chosen design, as it was analyzed
 * @param {{known: object, other: object, place: number}[]} beside the others
 * @param {Object<string, number>} widths what {@link measure} found
 */
export function draw(known, beside, widths) {
  const named = { ...known, title: withChanges(known.title, active()) };
  const thin = beside.map(({ known: other, other: of, place }) => ({ known: { ...other, title: withChanges(other.title, of) }, place }));
  const pictures = drawAll(named, thin, widths);
  at("side").hidden = pictures.side === undefined;
  for (const [id, picture] of Object.entries(pictures)) fill(drawing(id), picture ?? "");
  move(named, thin, widths.motion);
}

/** Draws a design where nobody sees it, in an element of its own. */
export function drawUnseen(element, design, known, widths) {
  const motion = drawMotion(known.title, simulate(design, initial(known)), [], widths.motion);
  fill(element, Object.values(drawAll(known, [], widths)), motion);
}

function drawAll(known, beside, widths) {
  const map = (of) => new Map(parametersOf(of).map(({ name }, index) => [name, of.values[index]]));
  const others = beside.map(({ known: other, place }) => ({ values: map(other), place }));
  return {
    side: drawSide(known.title, map(known), others, widths.eigenvalues),
    eigenvalues: drawCurves(known, beside, state.speed, widths.eigenvalues),
    locus: drawLocus(known, beside, state.speed, widths.locus),
    numbers: drawNumbers(known, state.speed),
  };
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
    fill(drawing("motion"), drawMotion(known.title, motion, others, width));
    error.hidden = true;
  } catch (mistake) {
    if (!(mistake instanceof Mistake)) throw mistake;
    Object.assign(error, { textContent: mistake.message, hidden: false });
  }
}
