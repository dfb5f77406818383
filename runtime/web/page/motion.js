// A motion in time: lean and steer, or whatever a model has, and below it the path on the ground.

import { ask } from "carvallo/engine.js";
import { around, axes, frame, grid, inside, onPage, path } from "carvallo/axes.js";
import { kept } from "carvallo/kept.js";
import { names } from "carvallo/labels.js";
import { legend } from "carvallo/legend.js";
import { tag } from "carvallo/nodes.js";
import { picture } from "carvallo/svg.js";
import { state, subject } from "carvallo/state.js";

const STEPS = 200;
const COLORS = ["#1f6fb4", "#c0283c", "#2e7d32", "#b46a00", "#7a3f9d", "#555d66"];

/** What is drawn in one graph, by its unit. */
const LABELS = { rad: "angles (°)", m: "positions (m)", "N*m": "torques (N m)", N: "forces (N)" };

/** What begins a motion of a model, where nothing else is given: a push to the side, or of the first coordinate. */
export function usual(coordinates) {
  return coordinates.includes("phi") ? "phi_rate=0.5" : `${coordinates[0]}=0.1`;
}

/** What the engine is to simulate. */
export function asked(initial) {
  const given = initial.split(/[,;]/).map((part) => part.trim()).filter(Boolean);
  return { speed: state.speed, duration: state.duration, steps: STEPS, initial: given };
}

/** Enough for the designs that lie over each other. */
const KEPT = 8;

/**
 * Simulates a design.
 * @throws {Mistake} what is wrong with the start, or why there is no motion
 */
export function simulate(design, initial) {
  return answer({ ask: "simulate", design: subject(design), motion: asked(initial) });
}

const answer = kept(KEPT, (question) => told(ask(question)));

function told({ reply, numbers }) {
  const forces = reply.forces.map((force) => ({ ...force, label: force.name, isForce: true }));
  const quantities = [...reply.quantities, ...forces];
  return { ...reply, quantities, numbers };
}

/**
 * @param {object} motion the one of the chosen design
 * @param {{motion: object, place: number, title: string}[]} beside those of the others
 */
export function drawMotion(title, motion, beside, width) {
  const shown = motion.quantities.filter(({ name, isForce }) => isForce || !hasPath(motion) || ["phi", "delta"].includes(name))
    .map((quantity, index) => ({ ...quantity, color: COLORS[index % COLORS.length] }));
  const units = [...new Set(shown.map(({ unit }) => unit))];
  const graphs = units.map((unit, index) => graph(title, motion, beside, shown.filter((quantity) => quantity.unit === unit), unit, width, index));
  const ground = hasPath(motion) ? [track(title, motion, beside, width)] : [];
  const kind = motion.is_linear ? "by the linear equations" : "by the nonlinear equations";
  const said = [motion.end, ...motion.notes].filter(Boolean).map((note) => tag("li", {}, note));
  const entries = [
    ...shown.map((quantity) => ({ name: named(quantity), color: quantity.color })),
    ...beside.map(({ title, place }) => ({ name: title, className: `beside design-${place}` })),
  ];
  return [graphs, legend(entries), ground, tag("p", { class: "hint" }, `At ${state.speed} m/s, ${kind}.`), tag("ul", { class: "said" }, said)];
}

const hasPath = ({ quantities }) => ["x", "y", "delta"].every((name) => quantities.some((quantity) => quantity.name === name));
const named = ({ name, label }) => (name === label ? name : `${label} ${symbol(name)}`);
const symbol = (name) => ({ phi: "φ", delta: "δ", psi: "ψ", theta: "θ" })[name] ?? name;

const placeOf = ({ quantities }, name) => 1 + quantities.findIndex((quantity) => quantity.name === name);

/** A quantity over another, of both of which there is a place in each row, point by point; none where the motion has it not. */
function over({ quantities, rows, numbers }, [x, y], scale) {
  const width = 1 + quantities.length;
  const points = new Float64Array(y > 0 ? 2 * rows : 0);
  for (let at = 0, row = 0; at < points.length; at += 2, row += width) {
    points[at] = numbers[row + x];
    points[at + 1] = scale * numbers[row + y];
  }
  return points;
}

/** A quantity over the time. */
const history = (motion, name, scale) => over(motion, [0, placeOf(motion, name)], scale);

function graph(title, motion, beside, shown, unit, width, index) {
  const scale = unit === "rad" ? 180 / Math.PI : 1;
  const curves = shown.map((quantity) => history(motion, quantity.name, scale));
  const label = LABELS[unit] ?? "positions";
  const of = axes({ width, height: 220, x: [0, state.duration], y: around([[0, 0], ...curves], 1), labels: ["time t (s)", label] });
  const thin = beside.flatMap(({ motion: other, place }) =>
    shown.map(({ name }) => tag("path", { class: `curve beside design-${place}`, d: path(of, history(other, name, scale)) })));
  const attributes = (quantity) => ({ style: `--c:${quantity.color}` });
  const thick = curves.map((curve, which) => tag("path", { class: "curve", ...attributes(shown[which]), d: path(of, curve) }));
  const lines = curves.map((curve, which) =>
    [onPage(of, curve), named(shown[which]), attributes(shown[which])]);
  const content = [grid(of), inside(of, `motion-${index}`, [thin, thick]), frame(of), names(of, lines)];
  return picture(width, 220, `${label} of ${title} against time`, content);
}

/** Where the rear wheel touches the ground, seen from above: to the right is up to the page's bottom, as y is to the right. */
function track(title, motion, beside, width) {
  const points = (of) => over(of, [placeOf(of, "x"), placeOf(of, "y")], -1);
  const own = points(motion);
  const of = axes({ width, height: 160, x: around([own], 0), y: around([own], 1), labels: ["x, forward (m)", "to the left (m)"] });
  const thin = beside.filter(({ motion: other }) => hasPath(other)).map(({ motion: other, place }) =>
    tag("path", { class: `curve beside design-${place}`, d: path(of, points(other)) }));
  const thick = tag("path", { class: "curve", style: `--c:${COLORS[5]}`, d: path(of, own) });
  const content = [grid(of), inside(of, "track-inside", [thin, thick]), frame(of)];
  return [
    tag("p", { class: "sub" }, "Path of the rear wheel on the ground, from above (axes of different scale)"),
    picture(width, 160, `Path of the rear wheel of ${title}, from above`, content),
  ];
}
