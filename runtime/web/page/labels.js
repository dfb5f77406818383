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
  const crowd = lines.flatMap(([points]) => points);
  const drawn = lines.map(([points, name, attributes]) => {
    const visible = points.filter(([x, y]) => x >= area.left && x <= area.right && y >= area.top && y <= area.bottom);
    const box = place(visible, WIDTH * name.length, area, taken, crowd);
    if (!box) return "";
    taken.push(box);
    return text(box[0], box[1] + HEIGHT - 4, name, { class: "name", ...attributes });
  });
  return drawn;
}

function place(points, width, area, taken, crowd) {
  if (points.length < 2) return undefined;
  for (const share of SHARES) {
    const [x, y] = points[Math.floor(share * (points.length - 1))];
    for (const [left, top] of [[x - width / 2, y - HEIGHT - 3], [x - width / 2, y + 4], [x + 6, y - HEIGHT], [x - width - 6, y - HEIGHT]]) {
      const box = [left, top, left + width, top + HEIGHT];
      const fits = left > area.left + 2 && box[2] < area.right - 2 && top > area.top && box[3] < area.bottom;
      const clear = fits && !taken.some((other) => overlap(box, other)) && !crowd.some((point) => holds(box, point));
      if (clear) return box;
    }
  }
  return undefined;
}

const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

const holds = (box, [x, y]) => x > box[0] - 2 && x < box[2] + 2 && y > box[1] && y < box[3];
