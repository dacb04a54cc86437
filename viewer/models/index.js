/* The models of all scenes that have handles; `rotedu.scenes` names them. */
export { camera } from "./camera.js";
export { closedCurve } from "./closed_curve.js";
