// Pieces of pictures.

import { tag } from "carvallo/nodes.js";

export const text = (x, y, content, attributes = {}) => tag("text", { x: round(x), y: round(y), ...attributes }, content);

export const line = (x1, y1, x2, y2, attributes = {}) =>
  tag("path", { d: `M${round(x1)} ${round(y1)}L${round(x2)} ${round(y2)}`, ...attributes });

/**
 * The data of a path through points. What follows the first is written as the way from the one before: these numbers are short, and
 * so few that a browser has most of them as text already.
 * @param {ArrayLike<number>} points x and y of each in turn, as everywhere on this page: a pair of its own for each point would be
 * memory to be collected again in every step of a slider
 */
export function through(points) {
  let data = "";
  let x = 0;
  let y = 0;
  for (let at = 0; at < points.length; at += 2) {
    const across = Math.round(10 * points[at]);
    const down = Math.round(10 * points[at + 1]);
    data += `${at ? "l" : "M"}${(across - x) / 10} ${(down - y) / 10}`;
    x = across;
    y = down;
  }
  return data;
}

/** A tenth of a pixel is finer than anyone sees. */
export const round = (value) => Math.round(10 * value) / 10;

/** A picture with what it shows in words. */
export function picture(width, height, label, content) {
  return tag("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": label }, content);
}
