// A figure as an SVG file: the graphs one below the other, styled as the page shows them.

import { escaped } from "carvallo/escaped.js";

/** What of the style of an element a file needs. */
const KEPT = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "opacity", "font-size", "font-style", "text-anchor", "paint-order"];

const GAP = 12;

/**
 * The graphs of a figure as one SVG.
 * @throws {Error} if there is none
 */
export function standalone(figure) {
  const graphs = [...figure.querySelectorAll(".drawing > svg")];
  if (graphs.length === 0) throw new Error("there is no such picture of this design");
  let [top, width] = [GAP, 0];
  const ink = plain(getComputedStyle(figure).color);
  const parts = graphs.map((graph) => {
    const copy = styled(graph);
    copy.setAttribute("y", top);
    top += graph.viewBox.baseVal.height + GAP;
    width = Math.max(width, graph.viewBox.baseVal.width);
    return new XMLSerializer().serializeToString(copy);
  });
  const names = [...figure.querySelectorAll(".legend li")].map((item, index) => {
    const stroke = plain(getComputedStyle(item.querySelector(".curve")).stroke);
    const y = top + 16 * index;
    return `<path d="M12 ${y}H40" stroke="${stroke}" stroke-width="2"/><text x="48" y="${y + 4}" font-size="12" fill="${ink}">${escaped(item.textContent)}</text>`;
  });
  top += 16 * names.length;
  const title = graphs.map((graph) => graph.getAttribute("aria-label")).join("; ");
  const background = getComputedStyle(figure).backgroundColor;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${top}" viewBox="0 0 ${width} ${top}" ` +
    `font-family="sans-serif" role="img">\n<title>${escaped(title)}</title>\n` +
    `<rect width="100%" height="100%" fill="${plain(background)}"/>\n${[...parts, ...names].join("\n")}\n</svg>\n`;
}

function styled(graph) {
  const copy = graph.cloneNode(true);
  const from = [graph, ...graph.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((element, index) => {
    const style = getComputedStyle(from[index]);
    const kept = KEPT.map((key) => `${key}:${plain(style.getPropertyValue(key))}`).join(";");
    element.removeAttribute("class");
    element.setAttribute("style", kept);
  });
  return copy;
}

/** Colours as every viewer reads them: a mixed one is `color(srgb 0.1 0.4 0.7)` in a browser. */
const plain = (value) =>
  value.replace(/color\(srgb ([\d.]+) ([\d.]+) ([\d.]+)\)/g, (_, ...parts) => `rgb(${parts.slice(0, 3).map((part) => Math.round(255 * part)).join(", ")})`);
