// A design as it was analyzed: what the engine says of it, with the curves of its numbers.

import { ask } from "carvallo/engine.js";
import { kept } from "carvallo/kept.js";
import { subject } from "carvallo/state.js";

/** Enough for the designs that lie over each other, and for what the chosen one began with. More would only be collected later. */
const KEPT = 8;

/** Modes that have no curve of their own name, such as in pairs, have this colour. */
const NAMELESS = "#555d66";

/**
 * Analyzes a design.
 * @throws {Mistake} what is wrong with it
 */
export function analyze(design) {
  return answer({ ask: "analyze", design: subject(design) });
}

/**
 * The eigenvalues of a design at one speed in m/s.
 * @returns {{mode: string, re: number, im: number}[]}
 * @throws {Mistake} what is wrong with either
 */
export function eigenvalues(design, speed) {
  return ask({ ask: "eigenvalues", design: subject(design), speed }).reply;
}

const answer = kept(KEPT, (question) => known(ask(question)));

function known({ reply, numbers }) {
  let place = 0;
  const points = (count) => numbers.subarray(place, (place += 2 * count));
  const panels = reply.panels.map(({ series, ...panel }) => ({
    ...panel,
    series: series.map(({ name, color, border, is_dashed, has_label, lengths }) =>
      ({ name, color, border, isDashed: is_dashed, hasLabel: has_label, curves: lengths.map(points) })),
  }));
  return { ...reply, panels, locus: locus(reply, numbers.subarray(place), panels) };
}

/** For each eigenvalue pieces of one mode; and what is drawn at whole speeds. */
function locus({ locus: [speeds, count], modes, moves }, numbers, panels) {
  const series = panels.flatMap((panel) => panel.series);
  const color = (mode) => series.find(({ name }) => name === mode || name.startsWith(`${mode}, real`) || name.startsWith(`${mode} `))?.color ?? NAMELESS;
  const strands = [];
  const whole = [];
  const width = 1 + 3 * count;
  for (let index = 0; index < count; index++) {
    let strand;
    for (let row = 0; row < speeds; row++) {
      const speed = numbers[row * width];
      const at = row * width + 1 + 3 * index;
      const re = numbers[at];
      const im = numbers[at + 1];
      const mode = modes[numbers[at + 2]];
      if (strand?.mode !== mode) strands.push((strand = { mode, points: strand ? strand.points.slice(-2) : [] }));
      strand.points.push(re, im);
      if (moves && Number.isInteger(speed)) whole.push([speed, re, im, mode]);
    }
  }
  return { strands, whole, modes, color };
}
