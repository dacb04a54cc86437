/* node write-panels.js writes the panels of explorables, which come and go as JSON, for a page. */
import { readFileSync } from "node:fs";
import * as models from "../rotedu/scenes/models.js";
import { panelHtml } from "./src/panel-html.js";

const panels = JSON.parse(readFileSync(0, "utf8")).map((data) =>
  panelHtml(data, models[data.model](data.start, data.constants, [])),
);
process.stdout.write(JSON.stringify(panels));
