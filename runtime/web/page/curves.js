// Eigenvalues against speed: all modes of the chosen design, and those of the others as thin lines in their colours.

import { axes, frame, grid, inside, onPage, path } from "carvallo/axes.js";
import { boxOf, names } from "carvallo/labels.js";
import { legend, others } from "carvallo/legend.js";
import { tag } from "carvallo/nodes.js";
import { line, picture, text } from "carvallo/svg.js";

/**
 * @param {object} known the chosen design, as it was analyzed
 * @param {{known: object, place: number}[]} beside the others
 */
export function drawCurves(known, beside, speed, width) {
  if (known.panels.length === 0) {
    return tag("p", {}, `Nothing in the model ${known.model} depends on the speed: see the root locus for its eigenvalues.`);
  }
  const height = known.panels.length > 1 ? 240 : 340;
  const drawn = known.panels.map((panel, index) => draw(known, panel, index, beside, speed, width, height));
  const entries = known.panels.flatMap(({ series }) => series).filter(({ curves, hasLabel }) => hasLabel && curves.length > 0);
  const unique = entries.filter(({ name }, index) => entries.findIndex((other) => other.name === name) === index);
  return [drawn, legend([...unique, ...others(beside)])];
}

function draw(known, panel, index, beside, speed, width, height) {
  const of = axes({ width, height, x: known.range, y: panel.y, labels: ["forward speed v (m/s)", panel.label] });
  const ranges = known.stable_ranges.map(([from, to]) => stable(of, from, to ?? known.range[1]));
  const background = [grid(of), ranges.map(({ drawn }) => drawn)];
  const thin = beside.flatMap(({ known: other, place }) => {
    const curves = other.panels[index]?.series.flatMap((series) => series.curves.map((curve) => [curve, series.isDashed])) ?? [];
    return curves.map(([curve, isDashed]) =>
      tag("path", { class: `curve beside design-${place} ${isDashed ? "dashed" : ""}`, d: path(of, curve) }));
  });
  const thick = panel.series.flatMap(({ color, border, isDashed, curves }) => {
    const d = curves.map((curve) => path(of, curve)).join("");
    if (!d) return [];
    const edge = border ? tag("path", { class: "curve edge", style: `--c:${border}`, d }) : "";
    return [edge, tag("path", { class: `curve ${isDashed ? "dashed" : ""}`, style: `--c:${color}`, d })];
  });
  const critical = known.critical_speeds
    .filter((critical) => critical.name !== "double_root" && critical.speed <= known.range[1])
    .map((critical) => tag("g", { class: "critical" }, line(of.across(critical.speed), of.top, of.across(critical.speed), of.bottom)));
  const marker = tag("g", { class: "marker" }, line(of.across(speed), of.top, of.across(speed), of.bottom));
  const lines = panel.series.filter(({ hasLabel, curves }) => hasLabel && curves.length > 0).map(({ name, color, curves }) => {
    const longest = curves.reduce((a, b) => (b.length > a.length ? b : a));
    return [onPage(of, longest), name, { style: `--c:${color}` }];
  });
  const content = [background, inside(of, `curves-${index}`, [thin, critical, thick, marker])];
  const label = `${panel.label} of ${known.title} against speed, from ${known.range[0]} to ${known.range[1]} m/s`;
  return picture(width, height, label, [content, frame(of), names(of, lines, ranges.flatMap(({ taken }) => taken))]);
}

/** A stable range, and where its name stands, if there is room for one. */
function stable(of, from, to) {
  const [left, right] = [Math.max(of.across(from), of.left), Math.min(of.across(to), of.right)];
  if (right <= left) return { drawn: "", taken: [] };
  const box = tag("rect", { class: "stable", x: left, y: of.top, width: right - left, height: of.bottom - of.top });
  if (right - left <= 50) return { drawn: box, taken: [] };
  const middle = (left + right) / 2;
  const name = text(middle, of.bottom - 8, "stable", { class: "stable-name", "text-anchor": "middle" });
  return { drawn: [box, name], taken: [boxOf(middle, of.bottom - 4, "stable")] };
}
