// The laws of feedback of the chosen design: forces that follow from the motion, which close the loop.

import { active } from "carvallo/state.js";

const [field, reset, hint] = ["feedback", "open-loop", "feedback-hint"].map((id) => document.getElementById(id));

/** Calls `changed` when the laws are others. */
export function onFeedback(changed) {
  field.addEventListener("change", () => {
    const laws = field.value.trim();
    // Without a law there is nothing to replace but what is in a file.
    active().feedback = laws === "" && active().base.text === undefined ? undefined : laws;
    changed();
  });
  reset.addEventListener("click", () => {
    active().feedback = undefined;
    changed();
    field.focus();
  });
  document.getElementById("loop").addEventListener("submit", (event) => event.preventDefault());
}

/** Shows the laws of an analyzed design. */
export function showFeedback({ feedback, coordinates }) {
  if (document.activeElement !== field) field.value = active().feedback ?? feedback.join("; ");
  field.removeAttribute("aria-invalid");
  reset.hidden = active().feedback === undefined;
  const law = `T${coordinates.at(-1)} = 10*${coordinates[0]}_rate`;
  hint.textContent = `Forces that follow from the motion and the speed v, such as ${law}; with a semicolon between them.`;
}

/** Marks the field if a message says something of a law in it. */
export function blameFeedback(message) {
  field.toggleAttribute("aria-invalid", message.includes("feedback `"));
  reset.hidden = active().feedback === undefined;
}
