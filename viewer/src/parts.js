/* The parts of a scene by name, and how a state moves them. */
import { BufferAttribute, BufferGeometry, SphereGeometry } from "three";
import { arrow, tubes } from "./shapes.js";

/** @import { Change, Drawn, Part } from "./types.js" */

// As `rotedu.scenes.parts` makes them: the middles of the faces touch a ball of glass, which its shader draws.
const POINT = { across: 16, down: 11 };
const GLASS = { across: 60, down: 30, share: Math.cos(Math.PI / 60) ** 2 };

/**
 * Move a part, unless it is already so.
 * @param {Part} part
 * @param {Change} change
 */
export function move(part, change) {
  if (alike(change, part.change)) return;
  part.change = change;
  const { at, color, count, from, hidden, matrix, paths, points, to } = change;
  const { objects, place, surface } = part;
  const { radius = 0, tip = 0 } = place;
  if (hidden !== undefined) for (const object of objects) object.visible = !hidden;
  if (color) paint(objects, color);
  if (at) shift(objects, at, place.at ?? [0, 0, 0]);
  if (paths) dress(part, tubes(paths, radius, part.skin));
  if (from && to) dress(part, arrow(from, to, radius, tip, part.skin));
  if (points) bend(part, points);
  if (count) for (const object of objects) object.count = count;
  if (matrix) {
    for (const object of objects) object.matrix.fromArray(matrix);
    if (surface) carry(surface, objects[0]);
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

/** Whether two changes, or what is in them, are the same. */
function alike(a, b) {
  if (!(a instanceof Object && b instanceof Object)) return a === b;
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => alike(a[name], b[name]));
}

/** Put a ball elsewhere; its points are where the scene was made. */
function shift(objects, at, from) {
  const [x, y, z] = at.map((value, i) => value - from[i]);
  for (const object of objects) object.matrix.makeTranslation(x, y, z);
}

/**
 * The lines or the arrow through the points that a scene brings of them, or the ball around its middle.
 * @param {BufferGeometry} points
 * @param {Record<string, any>} looks how many points each line has, and what else a surface needs
 */
export function drawn({ attributes: { position } }, { at, ball, lengths, radius, tip }) {
  if (ball) return around(ball, ball[3], GLASS);
  if (at) return around(at, radius, POINT);
  let i = 0;
  const next = () => [position.getX(i), position.getY(i), position.getZ(i++)];
  const paths = lengths.map((length) => Array.from({ length }, next));
  const [from, to] = paths[0];
  return wrapped(tip === undefined ? tubes(paths, radius) : arrow(from, to, radius, tip));
}

/** A ball, with so many faces around it and from pole to pole. */
function around([x, y, z], radius, { across, down, share = 1 }) {
  return new SphereGeometry(radius / share, across, down).rotateX(Math.PI / 2).translate(x, y, z);
}

/** A surface as three.js has it. */
function wrapped({ positions, normals, corners }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(new BufferAttribute(corners, 1));
  return geometry;
}

/** Give a part a new surface, or its own, written over. */
function dress(part, skin) {
  const [{ geometry }] = part.objects;
  if (part.skin === skin) {
    geometry.attributes.position.needsUpdate = true;
    geometry.attributes.normal.needsUpdate = true;
    geometry.boundingSphere = null;
    return;
  }
  part.skin = skin;
  replace(part, wrapped(skin));
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
function carry(surface, { geometry, matrix }) {
  const m = matrix.elements;
  const { rest, positions, around } = surface;
  around.copy(geometry.boundingSphere).applyMatrix4(matrix);
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
