/* For pages with explorables: what changes them, and the models of the scenes. */
import * as models from "../rotedu/scenes/models.js";
import { explore } from "./src/explore.js";

/** Let the hand change a live figure; see `explore`. */
export const answer = (element, live, data) => explore(element, live, data, models);
