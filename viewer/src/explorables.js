/* Figures that answer the hand, with the models that the scenes bring along. */
import * as models from "../models/index.js";
import { explore } from "./explore.js";

/** Let the hand change a live figure; see `explore`. */
export function bring(element, live, data, python) {
  return explore(element, live, data, models, python);
}
