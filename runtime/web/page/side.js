// The side view of a bicycle, to scale: wheels, steer axis, trail and centres of mass. Heights are above the ground.

import { tag } from "carvallo/nodes.js";
import { line, picture, text, through } from "carvallo/svg.js";

const [MARGIN, BELOW] = [14, 68];

/**
 * @param {Map<string, number>} values the parameters of the chosen design
 * @param {{values: Map<string, number>, place: number}[]} beside those of the others
 */
export function drawSide(title, values, beside, width) {
  const bicycle = geometry(values);
  if (!bicycle) return undefined;
  const all = [bicycle, ...beside.map(({ values }) => geometry(values)).filter(Boolean)];
  const scale = fit(all, width);
  const { place, height, ground } = scale;
  const content = [line(0, ground, width, ground, { class: "ground" })];
  for (const other of beside) {
    const drawn = geometry(other.values);
    if (drawn) content.push(tag("g", { class: `outline beside design-${other.place}` }, outline(drawn, scale)));
  }
  content.push(tag("g", { class: "outline" }, outline(bicycle, scale)), dimensions(bicycle, scale));
  for (const { name, mass, at } of bicycle.bodies) {
    const [x, y] = place(at);
    const disc = tag("circle", { cx: x, cy: y, r: 5 });
    const quarters = tag("path", { d: `M${x} ${y}v-5a5 5 0 0 1 5 5zM${x} ${y}v5a5 5 0 0 1-5-5z` });
    content.push(tag("g", { class: "mass" }, disc, quarters, text(x + 8, y + 4, `${name} ${short(mass)} kg`)));
  }
  const label = `Side view of ${title}: wheel base ${short(bicycle.base)} m, trail ${short(bicycle.trail)} m, ` +
    `head angle ${short(90 - degrees(bicycle.tilt))}°`;
  return picture(width, height, label, content);
}

function geometry(values) {
  const get = (name) => values.get(name);
  const needed = ["w", "c", "lam", "rR", "rF", "mR", "mF", "xB", "zB", "mB", "xH", "zH", "mH"].map(get);
  if (needed.some((value) => value === undefined)) return undefined;
  const [base, trail, tilt, rear, front, mR, mF, xB, zB, mB, xH, zH, mH] = needed;
  const bodies = [
    { name: "R", mass: mR, at: [0, rear] },
    { name: "F", mass: mF, at: [base, front] },
    { name: "B", mass: mB, at: [xB, -zB] },
    { name: "H", mass: mH, at: [xH, -zH] },
  ];
  const upper = ["xU", "zU", "mU"].map(get);
  if (upper.every((value) => value !== undefined)) bodies.push({ name: "U", mass: upper[2], at: [upper[0], -upper[1]] });
  const [sin, cos] = [Math.sin(tilt), Math.cos(tilt)];
  // The point of the steer axis at a distance upwards from where it meets the ground.
  const axis = (distance) => [base + trail - distance * sin, distance * cos];
  const length = Math.min((2.4 * front + 0.15 * base) / cos, 2 * Math.max(base, 2 * front));
  const fork = trail * sin + front * cos;
  return { base, trail, tilt, rear, front, bodies, axis, length, fork };
}

/** The same scale across and upward, in which everything fits on the page. */
function fit(bicycles, width) {
  const points = bicycles.flatMap(({ base, rear, front, bodies, axis, length }) =>
    [[-rear, 0], [base + front, 2 * front], [0, 2 * rear], axis(0), axis(length), ...bodies.map(({ at }) => at)]);
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right, bottom, top] = [Math.min(...xs, 0), Math.max(...xs), Math.min(...ys, 0), Math.max(...ys)];
  const factor = Math.min((width - 2 * MARGIN) / (right - left), 400 / (top - bottom));
  const indent = (width - (right - left) * factor) / 2;
  const ground = MARGIN + top * factor;
  const place = ([x, y]) => [Math.round(10 * (indent + (x - left) * factor)) / 10, Math.round(10 * (ground - y * factor)) / 10];
  return { place, factor, width, ground, height: MARGIN + (top - bottom) * factor + BELOW };
}

function outline({ base, rear, front, axis, length, fork }, { place, factor }) {
  const [rearHub, frontHub] = [place([0, rear]), place([base, front])];
  const bars = [rearHub, place(axis(fork + 1.3 * front)), place(axis(fork)), frontHub];
  const wheel = ([x, y], radius) => tag("circle", { class: "wheel", cx: x, cy: y, r: radius * factor });
  const steer = tag("path", { class: "steer", d: through([...place(axis(0)), ...place(axis(length))]) });
  return [tag("path", { class: "bars", d: through(bars.flat()) }), wheel(rearHub, rear), wheel(frontHub, front), steer];
}

/** Wheel base and trail, each on a line of its own below the ground, and the head angle at the axis. */
function dimensions({ base, trail, tilt }, { place, ground, factor, width }) {
  const x = (metres) => place([metres, 0])[0];
  const [rear, front, foot] = [x(0), x(base), x(base + trail)];
  const rows = [ground + 20, ground + 40];
  const uprights = [[rear, rows[0]], [front, rows[1]], [foot, rows[1]]].map(([at, to]) => line(at, ground, at, to + 4));
  const spans = [line(rear, rows[0], front, rows[0]), line(front, rows[1], foot, rows[1])];
  const radius = Math.min(0.22 * base * factor, 46);
  // From the ground behind the foot of the axis up to the axis.
  const [dx, dy] = [-Math.sin(tilt) * radius, -Math.cos(tilt) * radius];
  const arc = tag("path", { d: `M${foot - radius} ${ground}A${radius} ${radius} 0 0 1 ${foot + dx} ${ground + dy}` });
  const written = [
    text((rear + front) / 2, rows[0] - 4, `wheel base w ${short(base)} m`, { "text-anchor": "middle" }),
    text(Math.min(front, foot) - 8, rows[1] + 4, `trail c ${short(trail)} m`, { "text-anchor": "end" }),
    text(width - 6, rows[1] + 22, `head angle ${short(90 - degrees(tilt))}°`, { "text-anchor": "end" }),
  ];
  return [tag("g", { class: "dimension" }, uprights, spans, arc), tag("g", { class: "measure" }, written)];
}

export const degrees = (angle) => Number(((angle * 180) / Math.PI).toPrecision(12));

/** At most three decimals. */
export const short = (value) => String(Number(value.toFixed(Math.abs(value) < 0.01 ? 5 : 3))).replace("-", "−");
