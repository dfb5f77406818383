// What the page shows: designs, the chosen one, the speed and the start of the motion; and the same as an address.
//
// The address is `#design=MODEL,SET,NAME:VALUE,…&file=LABEL,TEXT,NAME:VALUE,…&active=1&speed=4.6&…`: designs in their order,
// each with what was changed, in the spelling of files; `feedback` among the names has laws, with `;` between them.

const KEYS = ["active", "speed", "initial", "duration"];

/** The most designs at a time: more lines than these nobody tells apart. */
export const MOST = 5;

export const state = {
  /** @type {{base: object, changes: Record<string, string>, feedback: string | undefined}[]} */
  designs: [],
  active: 0,
  /** In m/s. */
  speed: 5,
  /** How the motion begins, as the command line has it; empty for what suits the model. */
  initial: "",
  /** In s. */
  duration: 5,
};

/** A design that ships, or of a file; with laws of feedback in the place of those of the file, if they are not undefined. */
export function design(base, changes = {}, feedback = undefined) {
  return { base, changes, feedback };
}

/** What the engine calls a design. */
export function subject({ base, changes, feedback }) {
  return { ...base, changes: Object.entries(changes), feedback: feedback?.split(";").map((law) => law.trim()).filter(Boolean) };
}

export const active = () => state.designs[state.active];

/** A design that was changed is not what its name says. */
export const withChanges = (title, { changes }) => (Object.keys(changes).length > 0 ? `${title}, changed` : title);

/** What stands behind `#`. */
export function toHash() {
  const parts = state.designs.map(({ base, changes, feedback }) => {
    const [key, fields] = base.set !== undefined ? ["design", [base.model, base.set]] : ["file", [base.label, base.text]];
    const laws = feedback === undefined ? [] : [["feedback", feedback]];
    const changed = [...Object.entries(changes), ...laws].map((pair) => pair.map(encodeURIComponent).join(":"));
    return `${key}=${[...fields.map(encodeURIComponent), ...changed].join(",")}`;
  });
  return [...parts, ...KEYS.map((key) => `${key}=${encodeURIComponent(state[key])}`)].join("&");
}

/**
 * Takes over what stands behind `#`.
 * @throws {Error} if there is something in it that is not of this page
 */
export function fromHash(hash) {
  const found = { designs: [], active: 0 };
  for (const part of hash.replace(/^#/, "").split("&").filter(Boolean)) {
    const [key, text = ""] = split(part, "=");
    if (key === "design" || key === "file") {
      const [first, second, ...changed] = text.split(",");
      if (second === undefined) throw new Error(`the address has \`${part}\`; expected two parts behind \`${key}=\``);
      const [a, b] = [decode(first), decode(second)];
      const base = key === "design" ? { model: a, set: b } : { label: a, text: b };
      const pairs = changed.map((pair) => split(pair, ":").map(decode)).filter(([, value]) => value !== undefined);
      const { feedback, ...changes } = Object.fromEntries(pairs);
      found.designs.push(design(base, changes, feedback));
    } else if (key === "initial") {
      found.initial = decode(text);
    } else if (KEYS.includes(key)) {
      const value = Number(decode(text));
      if (!(value >= 0 && Number.isFinite(value))) {
        throw new Error(`the address has \`${decode(part)}\`; \`${key}\` must be a number >= 0`);
      }
      found[key] = value;
    } else {
      throw new Error(`the address has \`${decode(part)}\`, which this page does not know`);
    }
  }
  if (found.designs.length > MOST) throw new Error(`the address has more than ${MOST} designs`);
  if (found.designs.length === 0) found.designs.push(design({ model: "Whipple", set: "benchmark" }));
  found.active = Math.min(Math.floor(found.active), found.designs.length - 1);
  Object.assign(state, found);
}

function split(text, separator) {
  const place = text.indexOf(separator);
  return place < 0 ? [text] : [text.slice(0, place), text.slice(place + separator.length)];
}

function decode(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    throw new Error(`the address has \`${text}\`, which is not encoded as addresses are`);
  }
}
