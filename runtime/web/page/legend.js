// What lines mean, below a graph.

import { escaped, tag } from "carvallo/svg.js";

/** Lines with their names: each {name, color, className, isDashed}. */
export function legend(entries) {
  const items = entries.map(({ name, color, className = "", isDashed }) => {
    const d = "M1 6H27";
    const swatch = tag("path", { d, class: `curve ${className} ${isDashed ? "dashed" : ""}`, style: color && `--c:${color}` });
    return `<li><svg width="28" height="12" aria-hidden="true">${swatch}</svg>${escaped(name)}</li>`;
  });
  return `<ul class="legend">${items.join("")}</ul>`;
}

/** The other designs in a legend: `beside` has each with its title and place. */
export const others = (beside) => beside.map(({ known, place }) => ({ name: known.title, className: `beside design-${place}` }));
