// The numbers behind the pictures: stable ranges, critical speeds, and the eigenvalues at the speed.

import { escaped } from "carvallo/svg.js";

/** Six digits that people read; the cell has all of them in `data-value`. */
export const cell = (value) => `<td data-value="${value}">${digits(value)}</td>`;

const digits = (value) => {
  const size = Math.abs(value);
  const text = size !== 0 && (size >= 1e6 || size < 1e-4) ? value.toExponential(5) : String(Number(value.toPrecision(6)));
  return text.replace("-", "−");
};

/** The stable ranges in a sentence. */
export function sentence({ stable_ranges: ranges, moves, at_speed: values }) {
  if (!moves) {
    const isStable = values.every(({ re }) => re < 0);
    return isStable ? "Stable." : "Not stable: not every motion dies away.";
  }
  if (ranges.length === 0) return "Stable at no speed.";
  const range = ([from, to]) => (to === null ? `above ${digits(from)} m/s` : `from ${digits(from)} to ${digits(to)} m/s`);
  return `Stable ${ranges.map(range).join(" and ")}.`;
}

/** Tables of one design. */
export function drawNumbers(known, speed) {
  const critical = known.critical_speeds.map(({ name, speed: at }) => `<tr><th scope="row">${name.replace("_", " ")}</th>${cell(at)}</tr>`);
  const values = known.at_speed.map(({ mode, re, im }) => `<tr><th scope="row">${escaped(mode)}</th>${cell(re)}${cell(im)}</tr>`);
  const at = known.moves ? ` at ${speed} m/s` : "";
  return (
    table("critical", "Critical speeds", ["", "m/s"], critical, known.moves ? "There are none." : "Nothing depends on the speed.") +
    table("at-speed", `Eigenvalues${at}`, ["mode", "real part (1/s)", "imaginary part (rad/s)"], values, "There are no equations of motion at this speed.")
  );
}

function table(id, caption, heads, rows, none) {
  if (rows.length === 0) return `<p><b>${caption}</b>: ${none}</p>`;
  const head = heads.map((text) => `<th scope="col">${text}</th>`).join("");
  return `<table id="${id}"><caption>${caption}</caption><thead><tr>${head}</tr></thead><tbody>${rows.join("")}</tbody></table>`;
}
