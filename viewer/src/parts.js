/* The parts of a scene by name, and how a state moves them. */
import { BufferAttribute, BufferGeometry } from "three";
import { arrow, tubes } from "./shapes.js";

/** @import { Change, Drawn, Part } from "./types.js" */

/**
 * Move a part.
 * @param {Part} part
 * @param {Change} change
 */
export function move(part, { at, color, count, from, hidden, matrix, paths, points, to }) {
  const { objects, place, surface } = part;
  const { radius = 0, tip = 0 } = place;
  if (hidden !== undefined) for (const object of objects) object.visible = !hidden;
  if (color) paint(objects, color);
  if (at) shift(objects, at, place.at ?? [0, 0, 0]);
  if (paths) dress(part, (part.tubes = tubes(paths, radius, part.tubes)));
  if (from && to) dress(part, arrow(from, to, radius, tip));
  if (points) bend(part, points);
  if (count) for (const object of objects) object.count = count;
  if (matrix) {
    for (const object of objects) object.matrix.fromArray(matrix);
    if (surface) carry(surface, objects[0].matrix);
    castShadow(part);
  }
}

/**
 * Let the shadow of a part lie as the part does.
 * @param {Part} part
 */
export function castShadow({ objects, ground }) {
  for (const { material } of ground ?? []) {
    material.uniforms.lying.value.setFromMatrix4(objects[0].matrix);
  }
}

/** Put a ball elsewhere; its points are where the scene was made. */
function shift(objects, at, from) {
  const [x, y, z] = at.map((value, i) => value - from[i]);
  for (const object of objects) object.matrix.makeTranslation(x, y, z);
}

/** Give a part the points of a new surface. */
function dress(part, { positions, normals, corners }) {
  const [{ geometry }] = part.objects;
  if (part.corners === corners) {
    geometry.attributes.position.needsUpdate = true;
    geometry.attributes.normal.needsUpdate = true;
    geometry.boundingSphere = null;
    return;
  }
  part.corners = corners;
  const fresh = new BufferGeometry();
  fresh.setAttribute("position", new BufferAttribute(positions, 3));
  fresh.setAttribute("normal", new BufferAttribute(normals, 3));
  fresh.setIndex(new BufferAttribute(corners, 1));
  replace(part, fresh);
  geometry.dispose();
}

/** Move the points of a surface, whose faces stay. */
function bend(part, points) {
  // Equal parts share their points until one of them moves.
  if (!part.own) replace(part, ownPoints(part.objects[0].geometry));
  const { geometry } = part.objects[0];
  part.own = true;
  const { position, normal } = geometry.attributes;
  points.forEach((point, i) => position.setXYZ(i, ...point));
  position.needsUpdate = true;
  if (normal) geometry.computeVertexNormals();
  geometry.boundingSphere = null;
}

/** A copy whose normals are numbers: stored in bytes, those of small faces would be zero. */
function ownPoints(geometry) {
  const own = geometry.clone();
  const { position, normal } = own.attributes;
  if (normal)
    own.setAttribute("normal", new BufferAttribute(new Float32Array(3 * position.count), 3));
  return own;
}

/** Draw a part from other points, wherever they are. */
function replace({ objects }, geometry) {
  for (const object of objects) {
    object.geometry = geometry;
    object.frustumCulled = false;
  }
}

/** Move the surface that hides labels along with its part. */
function carry(surface, matrix) {
  const m = matrix.elements;
  const { rest, positions } = surface;
  for (let i = 0; i < rest.length; i += 3) {
    const [x, y, z] = [rest[i], rest[i + 1], rest[i + 2]];
    for (let k = 0; k < 3; k++) {
      positions[i + k] = m[k] * x + m[k + 4] * y + m[k + 8] * z + m[k + 12];
    }
  }
}

function paint(objects, color) {
  for (const { material } of objects) material.uniforms.base?.value.setRGB(...color);
}
