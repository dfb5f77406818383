// The root locus: where the eigenvalues are in the complex plane while the speed grows.

import { around, axes, frame, grid, inside, path } from "carvallo/axes.js";
import { legend, others } from "carvallo/legend.js";
import { tag } from "carvallo/nodes.js";
import { picture, text } from "carvallo/svg.js";

/** Eigenvalues that move by more than this part of the plane between two speeds are not joined. */
const APART = 0.08;

export function drawLocus(known, beside, speed, width) {
  const height = 360;
  const limits = plane(known);
  const of = axes({ width, height, ...limits, labels: ["real part (1/s)", "imaginary part (rad/s)"] });
  const unstable = of.x[1] > 0
    ? tag("rect", { class: "unstable", x: of.across(Math.max(0, of.x[0])), y: of.top, width: of.right - of.across(Math.max(0, of.x[0])), height: of.bottom - of.top })
    : "";
  const thin = beside.map(({ known: other, place }) =>
    other.locus.strands.map(({ points }) => tag("path", { class: `curve beside design-${place}`, d: joined(of, points) })));
  const thick = known.locus.strands.map(({ points, mode }) =>
    tag("path", { class: "curve", style: `--c:${known.locus.color(mode)}`, d: joined(of, points) }));
  const marks = known.moves ? known.locus.whole.map(([value, re, im, mode]) => mark(of, re, im, known.locus.color(mode), value, width)) : [];
  const now = known.at_speed.map(({ re, im, mode }) =>
    tag("circle", { class: "now", style: `--c:${known.locus.color(mode)}`, cx: of.across(re), cy: of.upward(im), r: 5 }));
  const label = `Eigenvalues of ${known.title} in the complex plane` + (known.moves ? `, from ${known.range[0]} to ${known.range[1]} m/s` : "");
  const content = [unstable, grid(of), inside(of, "locus-inside", [thin, thick, marks, now])];
  const side = unstable ? text(of.right - 6, of.top + 14, "unstable", { class: "unstable-name", "text-anchor": "end" }) : "";
  const modes = known.locus.modes.map((name) => ({ name, color: known.locus.color(name) }));
  const hint = known.moves ? tag("p", { class: "hint" }, `Small points are at whole speeds, circles at ${speed} m/s.`) : "";
  return [picture(width, height, label, [content, side, frame(of)]), legend([...modes, ...others(beside)]), hint];
}

/** The part of the plane that the graph of the curves shows as well; the far ends of what is fast are left out. */
function plane(known) {
  if (known.panels.length > 0) {
    const real = known.panels[0].y;
    const size = known.panels.length > 1 ? known.panels[1].y[1] : real[1];
    const im = Math.max(size, 1.1 * Math.max(...known.at_speed.map((value) => value.im).filter((value) => value <= 2 * size), 0));
    return { x: [real[0], Math.max(real[1] * 0.6, 0.1 * Math.abs(real[0]))], y: [-im, im] };
  }
  const curves = [[0, 0], ...known.locus.strands.map(({ points }) => points)];
  return { x: around(curves, 0), y: around(curves, 1) };
}

function joined(of, points) {
  const [wide, high] = [APART * (of.x[1] - of.x[0]), APART * (of.y[1] - of.y[0])];
  const pieces = [[]];
  for (let at = 0; at < points.length; at += 2) {
    const re = points[at];
    const im = points[at + 1];
    const jumps = Math.abs(re - points[at - 2]) > wide && Math.abs(im - points[at - 1]) > high;
    if (jumps) pieces.push([]);
    pieces.at(-1).push(re, im);
  }
  return pieces.filter((piece) => piece.length > 2).map((piece) => path(of, piece)).join("");
}

function mark(of, re, im, color, value) {
  return tag("circle", { class: "mark", style: `--c:${color}`, cx: of.across(re), cy: of.upward(im), r: 2.2 }, tag("title", {}, `${value} m/s`));
}
