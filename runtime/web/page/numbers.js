// The numbers behind the pictures: stable ranges, critical speeds, and the eigenvalues at the speed.

import { tag } from "carvallo/nodes.js";

/** Six digits that people read; the cell has all of them in `data-value`. */
const cell = (value) => tag("td", { "data-value": value }, digits(value));

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
  const critical = known.critical_speeds.map(({ name, speed: at }) => row(name.replace("_", " "), [at]));
  const values = known.at_speed.map(({ mode, re, im }) => row(mode, [re, im]));
  const at = known.moves ? ` at ${speed} m/s` : "";
  return [
    table("critical", "Critical speeds", ["", "m/s"], critical, known.moves ? "There are none." : "Nothing depends on the speed."),
    table("at-speed", `Eigenvalues${at}`, ["mode", "real part (1/s)", "imaginary part (rad/s)"], values, "There are no equations of motion at this speed."),
  ];
}

const row = (head, values) => tag("tr", {}, tag("th", { scope: "row" }, head), values.map(cell));

function table(id, caption, heads, rows, none) {
  if (rows.length === 0) return tag("p", {}, tag("b", {}, caption), `: ${none}`);
  const head = heads.map((text) => tag("th", { scope: "col" }, text));
  return tag("table", { id }, tag("caption", {}, caption), tag("thead", {}, tag("tr", {}, head)), tag("tbody", {}, rows));
}
