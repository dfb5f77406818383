// The models that ship, with their parameters and sets.

import { ask } from "carvallo/engine.js";

/** They are there when the engine is loaded. */
export const models = [];

export const loadModels = () => models.push(...ask({ ask: "catalogue" }).reply);

/** The parameters of an analyzed design: its own, or those of its model. */
export const parametersOf = (known) => known.parameters ?? models.find(({ name }) => name === known.model).parameters;
