/* The models of all scenes that have handles; `rotedu.scenes` names them. */
export { closedCurve } from "./closed_curve.js";
export { twoMirrors } from "./quaternions.js";
