/* The models of all scenes that have handles; `rotedu.scenes` names them. */
export { slerp } from "./arcs.js";
export { camera } from "./camera.js";
export { closedCurve } from "./closed_curve.js";
export { figure1 } from "./ordinary_rotation.js";
export { carriedAround } from "./orientations.js";
export { eulerAngles } from "./general_rotation.js";
export { controlPoints } from "./control_points.js";
export { twoMirrors } from "./quaternions.js";
