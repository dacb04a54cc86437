import assert from "node:assert/strict";
import { test } from "node:test";
import * as three from "three";
import { dress, scaleWidths, sortSeeThrough } from "../src/materials.js";

globalThis.BALL = "// the ball";
const LOOKS = {
  ambient: 0.25,
  diffuse: 0.5,
  specular: [0.1, 0.2, 0.3],
  specularPower: 7,
  pointSize: 5,
  lineWidth: 3,
  roundPoints: true,
  lit: true,
};
const LIGHTS = [
  [0, 0, 1],
  [0, 0.6, 0.8],
].map((toward, i) => ({ toward, color: [1, i, 0.5] }));

/** A part as three's loader returns it, and what draws it. */
function drawn(kind, { looks = {}, attributes = ["normal"], lights = LIGHTS, ...material } = {}) {
  const geometry = new three.BufferGeometry();
  for (const name of ["position", ...attributes]) {
    geometry.setAttribute(
      name,
      new three.BufferAttribute(new Float32Array([0, 0, 0, 1, 2, 3, 4, 5, 7]), 3),
    );
  }
  geometry.setIndex([2, 0, 0, 1]);
  const part = new kind(geometry, new three.MeshBasicMaterial(material));
  part.material.userData = { ...LOOKS, ...looks };
  part.matrixWorld.makeTranslation(1, 2, 3);
  return dress(part, lights);
}

const uniform = ({ material }, name) => material.uniforms[name].value;
const sides = (made) => made.map((object) => uniform(object, "sides"));
const near = (mine, wanted) =>
  mine.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-6, `${mine} is not ${wanted}`));

test("a surface has the looks that Python has given it", () => {
  const [made] = drawn(three.Mesh, { color: 0xffffff, opacity: 0.75 });
  for (const [name, value] of Object.entries({
    opacity: 0.75,
    ambient: 0.25,
    diffuse: 0.5,
    specularPower: 7,
  })) {
    assert.equal(uniform(made, name), value, name);
  }
  near(uniform(made, "base").toArray(), [1, 1, 1]);
  near(uniform(made, "specular").toArray(), [0.1, 0.2, 0.3]);
  assert.deepEqual(
    uniform(made, "toward").map((v) => v.toArray()),
    [
      [0, 0, 1],
      [0, 0.6, 0.8],
    ],
  );
  assert.deepEqual(
    uniform(made, "light").map((v) => v.toArray()),
    [
      [1, 0, 0.5],
      [1, 1, 0.5],
    ],
  );
  assert.equal(made.material.defines.LIGHTS, 2);
  near(made.matrix.elements.slice(12, 15), [1, 2, 3]);
  assert.ok(!made.matrixAutoUpdate);
});

test("a part knows the ball that it is, or may stand behind", () => {
  const roles = [{}, { ball: [1, 2, 3, 4] }, { behind: [1, 2, 3, 4] }].map((looks) => {
    const [made] = drawn(three.Mesh, { looks });
    assert.match(made.material.fragmentShader, /^\s*\/\/ the ball$/m);
    near(
      uniform(made, "ball").toArray(),
      "ball" in looks || "behind" in looks ? [1, 2, 3, 4] : [0, 0, 0, 1],
    );
    return uniform(made, "ballRole");
  });
  assert.equal(new Set(roles).size, 3);
});

test("a surface without normals is flat, with colors it has them, without light it shines", () => {
  for (const yes of [false, true]) {
    const attributes = yes ? ["normal", "color"] : [];
    const [made] = drawn(three.Mesh, { attributes, lights: [], looks: { lit: yes } });
    assert.equal(uniform(made, "smoothed"), yes);
    assert.equal(made.material.vertexColors, yes);
    assert.equal(uniform(made, "lit"), yes);
    assert.equal(made.material.defines.LIGHTS, 1);
  }
});

test("what is see-through on both sides is drawn in two steps, its inside first", () => {
  const [both, back, front] = [0, -1, 1];
  const double = three.DoubleSide;
  assert.deepEqual(sides(drawn(three.Mesh, { side: double })), [both]);
  assert.deepEqual(sides(drawn(three.Mesh)), [front]);
  assert.deepEqual(sides(drawn(three.Mesh, { transparent: true })), [front]);
  assert.deepEqual(sides(drawn(three.Mesh, { side: double, transparent: true })), [back, front]);
});

test("what is see-through lets others through, and nothing else does", () => {
  for (const transparent of [false, true]) {
    const [{ material }] = drawn(three.Mesh, { transparent });
    assert.equal(material.transparent, transparent);
    assert.equal(material.depthWrite, !transparent);
    assert.equal(material.blending, transparent ? three.NormalBlending : three.NoBlending);
    assert.equal(material.side, three.DoubleSide);
  }
});

test("light falls on points that are balls alone", () => {
  for (const roundPoints of [false, true]) {
    const [made] = drawn(three.Points, { looks: { roundPoints } });
    assert.deepEqual(
      ["lit", "isRound", "isPoint"].map((name) => uniform(made, name)),
      [roundPoints, roundPoints, true],
    );
    assert.equal(uniform(made, "pointSize"), 5);
    assert.ok(made.isPoints);
  }
  assert.equal(uniform(drawn(three.Mesh, { looks: { roundPoints: false } })[0], "lit"), true);
  assert.equal(uniform(drawn(three.Mesh)[0], "isPoint"), false);
});

test("lines have their ends, their width and a color without light", () => {
  const [made] = drawn(three.LineSegments, { color: 0xffffff, opacity: 0.5, transparent: true });
  near(made.material.color.toArray(), [0.75, 0.75, 0.75]);
  assert.deepEqual(
    [made.material.opacity, made.material.transparent, made.material.linewidth],
    [0.5, true, 3],
  );
  assert.deepEqual(
    [...made.geometry.attributes.instanceStart.data.array],
    [4, 5, 7, 0, 0, 0, 0, 0, 0, 1, 2, 3],
  );
});

test("widths are those of the poster, however often the picture changes its size", () => {
  const objects = [...drawn(three.Points), ...drawn(three.LineSegments)];
  for (const factor of [2, 0.5]) scaleWidths(objects, factor);
  assert.equal(uniform(objects[0], "pointSize"), 2.5);
  assert.equal(objects[1].material.linewidth, 1.5);
});

test("a see-through surface counts by its far or its near end, where it is and as large as it is", () => {
  const made = drawn(three.Mesh, { side: three.DoubleSide, transparent: true });
  const [solid] = drawn(three.Mesh);
  const camera = new three.PerspectiveCamera();
  camera.position.set(0, 0, 9);
  const { geometry } = made[0];
  geometry.boundingSphere = new three.Sphere(new three.Vector3(0, 0, 1), 0.5);
  for (const object of made) object.matrixWorld.makeScale(2, 2, 2);
  sortSeeThrough([...made, solid], camera);
  assert.deepEqual(
    [...made, solid].map(({ renderOrder }) => renderOrder),
    [-8, -6, 0],
  );
  // A part that has changed its points has lost its sphere.
  geometry.boundingSphere = null;
  sortSeeThrough(made, camera);
  assert.ok(made[0].renderOrder < -8);
});
