// Pieces of pictures.

import { tag } from "carvallo/nodes.js";

export const text = (x, y, content, attributes = {}) => tag("text", { x: round(x), y: round(y), ...attributes }, content);

export const line = (x1, y1, x2, y2, attributes = {}) =>
  tag("path", { d: `M${round(x1)} ${round(y1)}L${round(x2)} ${round(y2)}`, ...attributes });

/** The data of a path through points [x, y]. */
export const through = (points) => points.map(([x, y], index) => `${index ? "L" : "M"}${round(x)} ${round(y)}`).join("");

/** A tenth of a pixel is finer than anyone sees. */
export const round = (value) => Math.round(10 * value) / 10;

/** A picture with what it shows in words. */
export function picture(width, height, label, content) {
  return tag("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": label }, content);
}
