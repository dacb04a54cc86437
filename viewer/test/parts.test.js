import assert from "node:assert/strict";
import { test } from "node:test";
import { BufferAttribute, BufferGeometry, Color, Matrix4, Mesh, Sphere, Vector3 } from "three";
import { drawn as anew, move } from "../src/parts.js";
import { near, points } from "./near.js";

const SQUARE = points("0,0,0 1,0,0 1,1,0 0,1,0");
const SHIFTED = points("0,0,1 0,1,1 0,1,2 0,0,2");

/** A part drawn in two steps, as see-through surfaces are. */
function square(place = {}) {
  const geometry = new BufferGeometry();
  const numbers = new Float32Array(SQUARE.flat());
  geometry.setAttribute("position", new BufferAttribute(numbers, 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(12), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const objects = [0, 1].map(() => {
    const mesh = new Mesh(geometry, { uniforms: { base: { value: new Color(1, 0, 0) } } });
    mesh.matrixAutoUpdate = false;
    return mesh;
  });
  return { objects, place };
}

const array = ({ objects: [{ geometry }] }, name = "position") => geometry.attributes[name].array;
const along = (part, k) => [...array(part)].filter((_, i) => i % 3 === k);
const visible = ({ objects }) => objects.map((object) => object.visible);
/** Look at a surface, and return a function that tells whether the graphics card hears of a change. */
function drawn({ objects: [{ geometry }] }) {
  geometry.computeBoundingSphere();
  const { position, normal } = geometry.attributes;
  const versions = [position.version, normal.version];
  return () =>
    geometry.boundingSphere === null &&
    position.version > versions[0] &&
    normal.version > versions[1];
}

test("a part takes the color that it is given, in all that draws it, and hides and comes back", () => {
  const part = square();
  move(part, { color: [0.2, 0.4, 0.6], hidden: true });
  assert.deepEqual(visible(part), [false, false]);
  move(part, {});
  assert.deepEqual(visible(part), [false, false]);
  move(part, { hidden: false });
  assert.deepEqual(visible(part), [true, true]);
  for (const { material } of part.objects) {
    near(material.uniforms.base.value.toArray(), [0.2, 0.4, 0.6]);
  }
  // Lines of one width, which have another material, keep their color.
  move({ objects: [{ material: { uniforms: {} } }], place: {} }, { color: [0, 0, 0] });
});

test("a ball goes from where it was made to where it is now", () => {
  const part = square({ at: [1, 2, 3] });
  for (const [at, wanted] of [points("1,2,4 0,0,1"), points("5,1,3 4,-1,0")]) {
    move(part, { at });
    for (const { matrix } of part.objects) near(matrix.elements.slice(12, 15), wanted);
  }
});

test("lines, arrows and balls are drawn from the points that a scene brings", () => {
  const brought = new BufferGeometry().setFromPoints(
    points("0,0,0 0,0,2 3,0,0 3,0,4 3,4,4").map((point) => new Vector3(...point)),
  );
  const lines = anew(brought, { lengths: [2, 3], radius: 0.1 });
  lines.computeBoundingBox();
  near(lines.boundingBox.max.toArray(), [3.1, 4, 4.1], 0.05);
  // Eight sides, and nothing between the lines
  assert.equal(lines.index.count, 3 * 2 * 8 * (1 + 2));
  const up = anew(brought, { lengths: [2], radius: 0.1, tip: 0.4 });
  up.computeBoundingBox();
  near(up.boundingBox.min.toArray().slice(2), [0]);
  near(up.boundingBox.max.toArray().slice(2), [2]);
  assert.ok(up.attributes.normal);
  const point = anew(brought, { lengths: [1], at: [1, 2, 3], radius: 0.5 });
  const glass = anew(brought, { lengths: [1], ball: [1, 2, 3, 0.5] });
  for (const [{ attributes }, least, most] of [
    [point, 0.5, 0.5],
    [glass, 0.5, 0.502],
  ]) {
    const { position } = attributes;
    for (let i = 0; i < position.count; i++) {
      const far = new Vector3().fromBufferAttribute(position, i).distanceTo({ x: 1, y: 2, z: 3 });
      assert.ok(far > least - 1e-6 && far < most + 1e-6);
    }
  }
});

test("lines follow their paths; with as many points they are written over", () => {
  const part = square({ radius: 0.1 });
  const follow = (text) => move(part, { paths: [points(text)] });
  follow("0,0,0 0,0,2");
  const [{ geometry }, other] = part.objects;
  assert.equal(other.geometry, geometry);
  assert.ok(!other.frustumCulled);
  near([Math.min(...along(part, 2)), Math.max(...along(part, 2))], [0, 2]);
  near([Math.max(...along(part, 0))], [0.1], 1e-6);
  const isTold = drawn(part);
  follow("0,0,0 0,0,2");
  assert.ok(!isTold(), "the same again is left as it is");
  follow("0,0,0 0,0,5");
  assert.equal(part.objects[0].geometry, geometry);
  near([Math.max(...along(part, 2))], [5]);
  assert.ok(isTold());
  let disposed = false;
  geometry.addEventListener("dispose", () => (disposed = true));
  follow("0,0,0 0,0,1 0,0,3");
  assert.ok(disposed);
  near([Math.max(...along(part, 2))], [3]);
});

test("the points of a surface move, and those of its equal stay", () => {
  const [part, equal] = [square(), square()];
  for (const object of equal.objects) object.geometry = part.objects[0].geometry;
  move(part, { points: SHIFTED });
  near(array(part), SHIFTED.flat());
  near(array(part, "normal").slice(0, 3), [1, 0, 0]);
  near(array(equal), SQUARE.flat());
  const isTold = drawn(part);
  move(part, { points: SHIFTED.map(([x, y, z]) => [x, y, -z]) });
  assert.equal(part.objects[1].geometry, part.objects[0].geometry);
  near(array(part).slice(0, 3), [0, 0, -1]);
  near(array(part, "normal").slice(0, 3), [-1, 0, 0]);
  assert.ok(isTold());
});

test("a part without normals gets none", () => {
  const part = square();
  part.objects[0].geometry.deleteAttribute("normal");
  move(part, { points: SHIFTED });
  assert.ok(!part.objects[0].geometry.attributes.normal);
});

test("a part takes its matrix, and what hides labels goes with it", () => {
  const matrix = new Matrix4().set(0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 2, 7, 0, 0, 0, 1).toArray();
  const rest = new Float32Array(points("0,0,0 1,0,0 1,1,2").flat());
  const around = new Sphere();
  for (const surface of [{ rest, positions: rest.slice(), around }, undefined]) {
    const part = { ...square(), surface };
    part.objects[0].geometry.boundingSphere = new Sphere(new Vector3(1, 2, 3), 4);
    for (const given of [new Matrix4().toArray(), matrix]) move(part, { matrix: given });
    for (const object of part.objects) near(object.matrix.elements, matrix);
    if (surface) near(surface.positions, points("5,6,7 5,7,7 4,7,11").flat());
    if (surface) near([...around.center, around.radius], [3, 7, 13, 8]);
  }
});

test("small faces that move are lit from the side to which they turn", () => {
  const part = square();
  const { geometry } = part.objects[0];
  const bytes = new Int8Array([0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127]);
  geometry.setAttribute("normal", new BufferAttribute(bytes, 3, true));
  move(part, { points: SQUARE.map(([x, y]) => [0, x / 100, y / 100]) });
  near(array(part, "normal"), points("1,0,0 1,0,0 1,0,0 1,0,0").flat());
});
