// A design as it was analyzed: what the engine says of it, with the curves of its numbers.

import { ask } from "carvallo/engine.js";
import { subject } from "carvallo/state.js";

const cache = new Map();

/** Enough for the designs that lie over each other, and for the way back from a change. */
const KEPT = 32;

/** Modes that have no curve of their own name, such as in pairs, have this colour. */
const NAMELESS = "#555d66";

/**
 * Analyzes a design.
 * @throws {Mistake} what is wrong with it
 */
export function analyze(design, speed, range) {
  const question = { ask: "analyze", design: subject(design), speed, range };
  const key = JSON.stringify(question);
  if (!cache.has(key)) {
    const { reply, numbers } = ask(question);
    if (cache.size >= KEPT) cache.delete(cache.keys().next().value);
    cache.set(key, known(reply, numbers));
  }
  return cache.get(key);
}

function known(reply, numbers) {
  let place = 0;
  const take = (count) => numbers.subarray(place, (place += count));
  const pairs = (count) => Array.from({ length: count }, () => Array.from(take(2)));
  const panels = reply.panels.map(({ series, ...panel }) => ({
    ...panel,
    series: series.map(({ name, color, border, is_dashed, has_label, lengths }) =>
      ({ name, color, border, isDashed: is_dashed, hasLabel: has_label, curves: lengths.map(pairs) })),
  }));
  const [speeds, count] = reply.locus;
  const rows = Array.from({ length: speeds }, () => Array.from(take(1 + 3 * count)));
  return { ...reply, panels, locus: locus(reply.modes, rows, count, panels, reply.moves) };
}

/** For each eigenvalue pieces of one mode; and what is drawn at whole speeds. */
function locus(modes, rows, count, panels, moves) {
  const series = panels.flatMap((panel) => panel.series);
  const color = (mode) => series.find(({ name }) => name === mode || name.startsWith(`${mode}, real`) || name.startsWith(`${mode} `))?.color ?? NAMELESS;
  const strands = [];
  const whole = [];
  for (let index = 0; index < count; index++) {
    let strand;
    for (const row of rows) {
      const [re, im, which] = row.slice(1 + 3 * index, 4 + 3 * index);
      const mode = modes[which];
      if (strand?.mode !== mode) strands.push((strand = { mode, points: strand ? [strand.points.at(-1)] : [] }));
      strand.points.push([re, im]);
      if (moves && Number.isInteger(row[0])) whole.push([row[0], re, im, mode]);
    }
  }
  return { strands, whole, modes, color };
}
