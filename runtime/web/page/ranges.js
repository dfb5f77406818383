// How parameters are shown: their names, units and the ends of their sliders.

import { roundStep } from "carvallo/axes.js";
import { degrees } from "carvallo/side.js";

/** What comes first: what people change on a bicycle. */
export const FIRST = ["w", "c", "lam"];

/** A bicycle has a head angle where the equations have the tilt from the vertical. */
const isTilt = ({ name, unit }, isBicycle) => isBicycle && name === "lam" && unit === "rad";

/**
 * A parameter as the page shows it: `shown` and `meant` lead from its unit to what is shown and back, as text of a file.
 */
export function shownAs(parameter, isBicycle) {
  const { about, symbol, unit } = parameter;
  const label = about.split(/[:;.\n]/)[0] || symbol;
  if (isTilt(parameter, isBicycle)) {
    const meant = (text) => (plain(text) ? `${rounded(90 - Number(text))} deg` : text);
    const hint = "90° minus the tilt λ; what is not a plain number is read as λ itself, such as 0.32 rad";
    return { label: "Head angle", symbol: "90° − λ", unit: "°", shown: (value) => 90 - degrees(value), meant, hint };
  }
  if (unit === "rad") {
    const meant = (text) => (plain(text) ? `${text} deg` : text);
    return { label, symbol, unit: "°", shown: degrees, meant, hint: about };
  }
  return { label, symbol, unit, shown: (value) => value, meant: (text) => text, hint: about };
}

const plain = (text) => text.trim() !== "" && Number.isFinite(Number(text));

/** The ends of a slider around a value, within what is allowed, and its step: [low, high, step]. */
export function ends(parameter, shown, base, value, isBicycle) {
  const at = shown(base);
  let [low, high] = usual(parameter, at, isBicycle);
  const bounds = parameter.bounds.map((bound) => (bound === null ? null : shown(bound))).sort((a, b) => a - b);
  const step = roundStep((high - low) / 400);
  if (bounds.length === 2 && parameter.bounds.every((bound) => bound !== null)) {
    low = Math.max(low, bounds[0] + step);
    high = Math.min(high, bounds[1] - step);
  } else if (parameter.bounds[0] !== null) {
    const open = parameter.required.startsWith("> ") ? step : 0;
    low = Math.max(low, shown(parameter.bounds[0]) + open);
  } else if (parameter.bounds[1] !== null) {
    high = Math.min(high, shown(parameter.bounds[1]) - step);
  }
  // What was typed beyond belongs to it.
  return [Math.min(low, value), Math.max(high, value), step];
}

function usual(parameter, at, isBicycle) {
  if (isTilt(parameter, isBicycle)) return [Math.min(45, at - 10), Math.max(90, at + 10)];
  if (isBicycle && parameter.name === "c") return [Math.min(-0.1, at - 0.1), Math.max(0.2, at + 0.1)];
  if (isBicycle && parameter.name === "w") return [at / 2, at * 1.5];
  const size = Math.abs(at) || 1;
  return [at - size, at + size];
}

/** Without the digits that a subtraction has made. */
export const rounded = (value) => Number(value.toPrecision(12));
