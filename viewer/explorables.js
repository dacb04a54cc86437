/* For pages with figures that answer the hand: what moves them, and the models of the scenes. */
import * as models from "../rotedu/scenes/models.js";
import { explore } from "./src/explore.js";

/** Let the hand change a live figure; see `explore`. */
export const bring = (element, live, data) => explore(element, live, data, models);
