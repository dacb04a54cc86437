/* The models of all scenes that have handles; `rotedu.scenes` names them. */
export { slerp } from "./arcs.js";
export { closedCurve } from "./closed_curve.js";
