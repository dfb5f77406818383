const ESCAPES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

/** Text as it stands in HTML. */
export const escaped = (text) => String(text).replace(/[&<>"]/g, (char) => ESCAPES[char]);
