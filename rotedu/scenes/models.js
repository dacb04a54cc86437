/* The models of the scenes that answer the hand, by the names that `explorable` gives them. */
export * from "./arcs.js";
export * from "./averages.js";
export * from "./balance.js";
export * from "./closed_curve.js";
export * from "./conclusions.js";
export * from "./control_points.js";
export * from "./five_numbers.js";
export * from "./general_rotation.js";
export * from "./introduction.js";
export * from "./motion.js";
export * from "./ordinary_rotation.js";
export * from "./orientation_curves.js";
export * from "./orientations.js";
export * from "./quaternions.js";
export * from "./rigid_motion.js";
