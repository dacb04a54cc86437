import assert from "node:assert/strict";
import { test } from "node:test";
import * as three from "three";
import { dress, sortSeeThrough } from "../src/materials.js";

globalThis.SHADERS = "";

/** A part as three's loader returns it, and what draws it. */
function drawn(transparent) {
  const geometry = new three.BufferGeometry();
  const numbers = new Float32Array([0, 0, 0, 1, 2, 3, 4, 5, 7]);
  geometry.setAttribute("position", new three.BufferAttribute(numbers, 3));
  geometry.setIndex([2, 0, 0, 1]);
  const part = new three.Mesh(geometry, new three.MeshBasicMaterial({ transparent }));
  return dress(part);
}

test("what is see-through lets others through, and is drawn inside first", () => {
  const [both, back, front] = [0, -1, 1];
  for (const transparent of [false, true]) {
    const made = drawn(transparent);
    const sides = made.map((object) => object.material.uniforms.sides.value);
    assert.deepEqual(sides, transparent ? [back, front] : [both]);
    const { material } = made[0];
    assert.equal(material.transparent, transparent);
    assert.equal(material.depthWrite, !transparent);
    assert.equal(material.blending, transparent ? three.NormalBlending : three.NoBlending);
    assert.equal(material.side, three.DoubleSide);
  }
});

test("a see-through surface counts by its far or its near end, where it is and as large as it is", () => {
  const made = drawn(true);
  const all = [...made, ...drawn(false)];
  const camera = new three.PerspectiveCamera();
  camera.position.set(0, 0, 9);
  const { geometry } = made[0];
  geometry.boundingSphere = new three.Sphere(new three.Vector3(0, 0, 1), 0.5);
  for (const object of made) object.matrixWorld.makeScale(2, 2, 2);
  sortSeeThrough(all, camera);
  const order = all.map(({ renderOrder }) => renderOrder);
  assert.deepEqual(order, [-8, -6, 0]);
  // A part that has changed its points has lost its sphere.
  geometry.boundingSphere = null;
  sortSeeThrough(made, camera);
  assert.ok(made[0].renderOrder < -8);
});
