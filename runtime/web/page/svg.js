// Pieces of SVG as text, which a browser reads faster than it makes elements one by one.

const ESCAPES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

export const escaped = (text) => String(text).replace(/[&<>"]/g, (char) => ESCAPES[char]);

/** A tag with its attributes; those without a value are left out. */
export function tag(name, attributes, content = "") {
  const written = Object.entries(attributes).filter(([, value]) => value !== undefined && value !== null);
  return `<${name}${written.map(([key, value]) => ` ${key}="${escaped(value)}"`).join("")}>${content}</${name}>`;
}

export const text = (x, y, content, attributes = {}) => tag("text", { x: round(x), y: round(y), ...attributes }, escaped(content));

export const line = (x1, y1, x2, y2, attributes = {}) =>
  tag("path", { d: `M${round(x1)} ${round(y1)}L${round(x2)} ${round(y2)}`, ...attributes });

/** The data of a path through points [x, y]. */
export const through = (points) => points.map(([x, y], index) => `${index ? "L" : "M"}${round(x)} ${round(y)}`).join("");

/** A tenth of a pixel is finer than anyone sees. */
export const round = (value) => Math.round(10 * value) / 10;

/** A picture with what it shows in words. */
export function picture(width, height, label, content) {
  return tag("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": label }, content);
}
