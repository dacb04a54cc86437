/* For notebooks: the viewer, and the models of the scenes. */
import * as models from "../rotedu/scenes/models.js";
import { render as show } from "./src/widget.js";

/** Show the figure of a widget, as anywidget asks for it. */
export const render = (view) => show(view, models);
