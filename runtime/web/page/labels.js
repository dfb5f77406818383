// Names beside curves, where there is room for them.

import { text } from "carvallo/svg.js";

const [WIDTH, HEIGHT] = [6.6, 15];

/** Where along a line its name is tried, from the one that is liked best. */
const SHARES = [0.85, 0.7, 0.55, 0.4, 0.95, 0.25, 0.1];

/** What a name takes of the page, [left, top, right, bottom], by its middle and its bottom. */
export const boxOf = (middle, bottom, name) => {
  const half = (WIDTH * name.length) / 2;
  return [middle - half, bottom - HEIGHT, middle + half, bottom];
};

/**
 * The names of lines, each [points on the page, name, attributes]; those without room are left to the legend.
 * @param {{left: number, right: number, top: number, bottom: number}} area
 * @param {number[][]} others boxes in which something else stands
 */
export function names(area, lines, others = []) {
  const taken = [...others];
  const crowd = lines.map(([points]) => points);
  const drawn = lines.map(([points, name, attributes]) => {
    const box = place(within(points, [area.left, area.top, area.right, area.bottom]), WIDTH * name.length, area, taken, crowd);
    if (!box) return "";
    taken.push(box);
    return text(box[0], box[1] + HEIGHT - 4, name, { class: "name", ...attributes });
  });
  return drawn;
}

function place(points, width, area, taken, crowd) {
  const count = points.length / 2;
  if (count < 2) return undefined;
  for (const share of SHARES) {
    const at = 2 * Math.floor(share * (count - 1));
    const [x, y] = [points[at], points[at + 1]];
    for (const [left, top] of [[x - width / 2, y - HEIGHT - 3], [x - width / 2, y + 4], [x + 6, y - HEIGHT], [x - width - 6, y - HEIGHT]]) {
      const box = [left, top, left + width, top + HEIGHT];
      const near = [left - 2, top, left + width + 2, top + HEIGHT];
      const fits = left > area.left + 2 && box[2] < area.right - 2 && top > area.top && box[3] < area.bottom;
      const clear = fits && !taken.some((other) => overlap(box, other)) && !crowd.some((others) => within(others, near).length > 0);
      if (clear) return box;
    }
  }
  return undefined;
}

const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

/** Those of the points that are in a box. */
function within(points, [left, top, right, bottom]) {
  const found = [];
  for (let at = 0; at < points.length; at += 2) {
    const x = points[at];
    if (x < left || x > right) continue;
    const y = points[at + 1];
    if (y >= top && y <= bottom) found.push(x, y);
  }
  return found;
}
