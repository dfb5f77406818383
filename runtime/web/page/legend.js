// What lines mean, below a graph.

import { tag } from "carvallo/nodes.js";

/** Lines with their names: each {name, color, className, isDashed}. */
export function legend(entries) {
  const items = entries.map(({ name, color, className = "", isDashed }) => {
    const d = "M1 6H27";
    const swatch = tag("path", { d, class: `curve ${className} ${isDashed ? "dashed" : ""}`, style: color && `--c:${color}` });
    return tag("li", {}, tag("svg", { width: 28, height: 12, "aria-hidden": "true" }, swatch), name);
  });
  return tag("ul", { class: "legend" }, items);
}

/** The other designs in a legend: `beside` has each with its title and place. */
export const others = (beside) => beside.map(({ known, place }) => ({ name: known.title, className: `beside design-${place}` }));
