// Axes with ticks, grid and labels, and the way from values to the page.

import { tag } from "carvallo/nodes.js";
import { round, text, through } from "carvallo/svg.js";

const MARGIN = { left: 52, right: 12, top: 10, bottom: 40 };

/** So many pixels a tick has at least, across and upward. */
const [ACROSS, UPWARD] = [64, 34];

/**
 * Axes from `x` to `y`, each [low, high], with labels.
 * @param {{width: number, height: number, x: number[], y: number[], labels: string[]}} of
 */
export function axes({ width, height, x, y, labels }) {
  const [left, right, top, bottom] = [MARGIN.left, width - MARGIN.right, MARGIN.top, height - MARGIN.bottom];
  const across = (value) => left + ((value - x[0]) / (x[1] - x[0])) * (right - left);
  const upward = (value) => bottom - ((value - y[0]) / (y[1] - y[0])) * (bottom - top);
  return { x, y, left, right, top, bottom, across, upward, labels, width, height };
}

/** The grid, behind everything. */
export function grid({ x, y, left, right, top, bottom, across, upward }) {
  const vertical = (value) => `M${round(across(value))} ${top}V${bottom}`;
  const level = (value) => `M${left} ${round(upward(value))}H${right}`;
  const lines = [...ticks(x, (right - left) / ACROSS).map(vertical), ...ticks(y, (bottom - top) / UPWARD).map(level)];
  const zero = (inside, drawn) => (inside[0] < 0 && inside[1] > 0 ? drawn(0) : "");
  return [tag("path", { class: "grid", d: lines.join("") }), tag("path", { class: "zero", d: zero(y, level) + zero(x, vertical) })];
}

/** The frame with numbers and labels, before everything. */
export function frame({ x, y, left, right, top, bottom, across, upward, labels }) {
  const numbers = [
    ...ticks(x, (right - left) / ACROSS).map((value) => text(across(value), bottom + 16, number(value), { "text-anchor": "middle" })),
    ...ticks(y, (bottom - top) / UPWARD).map((value) => text(left - 6, upward(value) + 4, number(value), { "text-anchor": "end" })),
  ];
  const [middle, centre] = [(left + right) / 2, (top + bottom) / 2];
  const named = [
    text(middle, bottom + 33, labels[0], { "text-anchor": "middle", class: "label" }),
    text(13, centre, labels[1], { "text-anchor": "middle", class: "label", transform: `rotate(-90 13 ${centre})` }),
  ];
  const box = tag("path", { class: "frame", d: `M${left} ${top}H${right}V${bottom}H${left}Z` });
  return [box, tag("g", { class: "ticks" }, numbers), named];
}

/** What is drawn inside of the axes, cut off at them. */
export function inside({ left, right, top, bottom }, id, content) {
  const clip = tag("clipPath", { id }, tag("rect", { x: left, y: top, width: right - left, height: bottom - top }));
  return [clip, tag("g", { "clip-path": `url(#${id})` }, content)];
}

/** Where on the page points are. */
export function onPage({ across, upward }, points) {
  const placed = new Float64Array(points.length);
  for (let at = 0; at < points.length; at += 2) {
    placed[at] = across(points[at]);
    placed[at + 1] = upward(points[at + 1]);
  }
  return placed;
}

/** The data of a path through points. */
export const path = (of, points) => through(onPage(of, points));

/** Round numbers between two limits, at most so many. */
export function ticks([low, high], most) {
  const step = roundStep((high - low) / Math.max(most, 2));
  const values = [];
  for (let index = Math.ceil(low / step - 1e-9); index * step <= high + 1e-9 * step; index++) {
    values.push(Number((index * step).toPrecision(12)));
  }
  return values;
}

/** The next of 1, 2 and 5 times a power of ten. */
export function roundStep(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  return power * [1, 2, 5, 10].find((step) => step * power >= size * (1 - 1e-9));
}

/** Limits around curves with a margin, or around one value: across for the part 0 of each point, upward for 1. */
export function around(curves, part) {
  let [low, high] = [Infinity, -Infinity];
  for (const points of curves) {
    for (let at = part; at < points.length; at += 2) {
      low = Math.min(low, points[at]);
      high = Math.max(high, points[at]);
    }
  }
  if (low > high) return [-1, 1];
  const room = 0.06 * (high - low) || Math.max(0.1 * Math.abs(high), 1e-3);
  return [low - room, high + room];
}

const number = (value) =>
  (value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-4) ? value.toExponential() : String(value)).replace("-", "−");
