/* The models of the scenes that answer the hand, by the names that `explorable` gives them. */
export { slerp } from "./arcs.js";
export { camera, closedCurve } from "./closed_curve.js";
export { controlPoints } from "./control_points.js";
export { eulerAngles } from "./general_rotation.js";
export { figure1 } from "./ordinary_rotation.js";
export { carriedAround } from "./orientations.js";
export { twoMirrors } from "./quaternions.js";
