/* The parts of a scene by name, and how a state moves them. */
import { BufferAttribute, BufferGeometry, Matrix4 } from "three";
import { arrow, tubes } from "./shapes.js";

/**
 * @typedef {object} Part
 * @property {object[]} objects what draws the part
 * @property {{at?: number[], radius?: number}} place as `rotedu.figures.state` recorded it
 * @property {object} [surface] what hides labels, if the part does
 */

/**
 * Move a part.
 * @param {Part} part
 * @param {object} change one entry of the parts of a state
 */
export function move(part, change) {
  const { objects, place } = part;
  if ("hidden" in change) for (const object of objects) object.visible = !change.hidden;
  if (change.color) paint(objects, change.color);
  if (change.at) {
    shift(objects, change.at, place.at);
  } else if (change.paths) {
    part.tubes = tubes(change.paths, place.radius, part.tubes);
    dress(part, part.tubes);
  } else if (change.from) {
    dress(part, arrow(change.from, change.to, place.radius));
  } else if (change.points) {
    bend(part, change.points);
  }
  if (change.matrix) {
    for (const { matrix } of objects) matrix.fromArray(change.matrix);
    if (part.surface) carry(part.surface, objects[0].matrix);
  }
}

/** Put a ball elsewhere; its points are where the scene was made. */
function shift(objects, at, from) {
  const matrix = new Matrix4().makeTranslation(...at.map((value, i) => value - from[i]));
  for (const object of objects) object.matrix.copy(matrix);
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
