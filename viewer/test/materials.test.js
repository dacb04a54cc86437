import assert from "node:assert/strict";
import { test } from "node:test";
import * as three from "three";
import { dress, scaleWidths, sortSeeThrough } from "../src/materials.js";
import { near } from "./near.js";

globalThis.BALL = "// the ball";
const NUMBERS = { ambient: 0.25, diffuse: 0.5, specularPower: 7, pointSize: 5 };
const LOOKS = { ...NUMBERS, specular: [0.1, 0.2, 0.3], lineWidth: 3, roundPoints: true, lit: true };
const LIGHTS = [
  { toward: [0, 0, 1], color: [1, 0, 0.5] },
  { toward: [0, 0.6, 0.8], color: [1, 1, 0.5] },
];

/** A part as three's loader returns it, and what draws it. */
function drawn(kind, { looks = {}, attributes = ["normal"], lights = LIGHTS, ...material } = {}) {
  const geometry = new three.BufferGeometry();
  for (const name of ["position", ...attributes]) {
    const numbers = new Float32Array([0, 0, 0, 1, 2, 3, 4, 5, 7]);
    geometry.setAttribute(name, new three.BufferAttribute(numbers, 3));
  }
  geometry.setIndex([2, 0, 0, 1]);
  const part = new kind(geometry, new three.MeshBasicMaterial(material));
  part.material.userData = { ...LOOKS, ...looks };
  part.matrixWorld.makeTranslation(1, 2, 3);
  return dress(part, lights);
}

const uniform = ({ material }, name) => material.uniforms[name].value;
const uniforms = (made, ...names) => names.map((name) => uniform(made, name));

test("a surface has the looks that Python has given it", () => {
  const [made] = drawn(three.Mesh, { color: 0xffffff, opacity: 0.75 });
  near(uniforms(made, "opacity", ...Object.keys(NUMBERS)), [0.75, ...Object.values(NUMBERS)]);
  near(
    uniforms(made, "base", "specular").map((v) => v.toArray()),
    [1, 1, 1, 0.1, 0.2, 0.3],
  );
  near(
    uniform(made, "toward").map((v) => v.toArray()),
    LIGHTS.map(({ toward }) => toward),
  );
  near(
    uniform(made, "light").map((v) => v.toArray()),
    LIGHTS.map(({ color }) => color),
  );
  assert.equal(made.material.defines.LIGHTS, 2);
  near(made.matrix.elements.slice(12, 15), [1, 2, 3]);
  assert.ok(!made.matrixAutoUpdate);
});

test("a part knows the ball that it is, or may stand behind", () => {
  const place = [1, 2, 3, 4];
  const roles = [{}, { ball: place }, { behind: place }].map((looks) => {
    const [made] = drawn(three.Mesh, { looks });
    assert.match(made.material.fragmentShader, /^\s*\/\/ the ball$/m);
    near(uniform(made, "ball").toArray(), looks.ball ?? looks.behind ?? [0, 0, 0, 1]);
    return uniform(made, "ballRole");
  });
  assert.deepEqual(roles, [0, 1, 2]);
});

test("a surface without normals is flat, with colors it has them, without light it shines", () => {
  for (const yes of [false, true]) {
    const attributes = yes ? ["normal", "color"] : [];
    const [made] = drawn(three.Mesh, { attributes, lights: [], looks: { lit: yes } });
    assert.deepEqual(uniforms(made, "smoothed", "lit"), [yes, yes]);
    assert.equal(made.material.vertexColors, yes);
    assert.equal(made.material.defines.LIGHTS, 1);
  }
});

test("what is see-through lets others through; on both sides it is drawn inside first", () => {
  const [both, back, front] = [0, -1, 1];
  for (const [side, transparent, ...sides] of [
    [three.DoubleSide, false, both],
    [three.FrontSide, false, front],
    [three.FrontSide, true, front],
    [three.DoubleSide, true, back, front],
  ]) {
    const made = drawn(three.Mesh, { side, transparent });
    assert.deepEqual(
      made.map((object) => uniform(object, "sides")),
      sides,
    );
    const { material } = made[0];
    assert.equal(material.transparent, transparent);
    assert.equal(material.depthWrite, !transparent);
    assert.equal(material.blending, transparent ? three.NormalBlending : three.NoBlending);
    assert.equal(material.side, three.DoubleSide);
  }
});

test("light falls on points that are balls alone", () => {
  for (const roundPoints of [false, true]) {
    const [points] = drawn(three.Points, { looks: { roundPoints } });
    const [surface] = drawn(three.Mesh, { looks: { roundPoints } });
    const wanted = [roundPoints, roundPoints, true];
    assert.deepEqual(uniforms(points, "lit", "isRound", "isPoint"), wanted);
    assert.deepEqual(uniforms(surface, "lit", "isPoint"), [true, false]);
    assert.ok(points.isPoints);
  }
});

test("lines have their ends, their width and a color without light", () => {
  const [made] = drawn(three.LineSegments, { color: 0xffffff, opacity: 0.5, transparent: true });
  const { color, opacity, transparent, linewidth } = made.material;
  near(color.toArray(), [0.75, 0.75, 0.75]);
  assert.deepEqual([opacity, transparent, linewidth], [0.5, true, 3]);
  near(made.geometry.attributes.instanceStart.data.array, [4, 5, 7, 0, 0, 0, 0, 0, 0, 1, 2, 3]);
});

test("widths are those of the poster, however often the picture changes its size", () => {
  const [point, line] = [...drawn(three.Points), ...drawn(three.LineSegments)];
  for (const factor of [2, 0.5]) scaleWidths([point, line], factor);
  assert.deepEqual([uniform(point, "pointSize"), line.material.linewidth], [2.5, 1.5]);
});

test("a see-through surface counts by its far or its near end, where it is and as large as it is", () => {
  const made = drawn(three.Mesh, { side: three.DoubleSide, transparent: true });
  const all = [...made, ...drawn(three.Mesh)];
  const camera = new three.PerspectiveCamera();
  camera.position.set(0, 0, 9);
  const { geometry } = made[0];
  geometry.boundingSphere = new three.Sphere(new three.Vector3(0, 0, 1), 0.5);
  for (const object of made) object.matrixWorld.makeScale(2, 2, 2);
  sortSeeThrough(all, camera);
  assert.deepEqual(
    all.map(({ renderOrder }) => renderOrder),
    [-8, -6, 0],
  );
  // A part that has changed its points has lost its sphere.
  geometry.boundingSphere = null;
  sortSeeThrough(made, camera);
  assert.ok(made[0].renderOrder < -8);
});
