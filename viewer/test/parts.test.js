import assert from "node:assert/strict";
import { test } from "node:test";
import { BufferAttribute, BufferGeometry, Color, Matrix4, Mesh } from "three";
import { move } from "../src/parts.js";

const SQUARE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];

/** A part drawn in two steps, as see-through surfaces are. */
function square(place = {}) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(SQUARE), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(12).fill(0), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const objects = [0, 1].map(() => {
    const material = { uniforms: { base: { value: new Color(1, 0, 0) } } };
    const mesh = new Mesh(geometry, material);
    mesh.matrixAutoUpdate = false;
    return mesh;
  });
  return { objects, place };
}

const near = (mine, wanted) => {
  assert.equal(mine.length, wanted.length);
  [...mine].forEach((x, i) =>
    assert.ok(Math.abs(x - wanted[i]) < 1e-6, `${mine} is not ${wanted}`),
  );
};
const positions = ({ objects: [{ geometry }] }) => geometry.attributes.position.array;

test("a part takes the color that it is given, in all that draws it", () => {
  const part = square();
  move(part, { color: [0.2, 0.4, 0.6] });
  for (const { material } of part.objects) {
    near(material.uniforms.base.value.toArray(), [0.2, 0.4, 0.6]);
  }
  move(part, { hidden: false });
  near(part.objects[0].material.uniforms.base.value.toArray(), [0.2, 0.4, 0.6]);
});

test("a part hides and comes back", () => {
  const part = square();
  move(part, { hidden: true });
  assert.deepEqual(
    part.objects.map(({ visible }) => visible),
    [false, false],
  );
  move(part, { color: [0, 0, 0] });
  assert.ok(!part.objects[0].visible);
  move(part, { hidden: false });
  assert.deepEqual(
    part.objects.map(({ visible }) => visible),
    [true, true],
  );
});

test("a ball goes from where it was made to where it is now", () => {
  const part = square({ at: [1, 2, 3] });
  for (const at of [
    [1, 2, 4],
    [5, 1, 3],
  ]) {
    move(part, { at });
    for (const { matrix } of part.objects) {
      near(
        matrix.elements.slice(12, 15),
        at.map((x, i) => x - [1, 2, 3][i]),
      );
    }
  }
});

test("lines follow their paths; with as many points they are written over", () => {
  const part = square({ radius: 0.1 });
  move(part, {
    paths: [
      [
        [0, 0, 0],
        [0, 0, 2],
      ],
    ],
  });
  const [{ geometry }, other] = part.objects;
  assert.equal(other.geometry, geometry);
  assert.ok(!other.frustumCulled);
  const along = (k) => [...positions(part)].filter((_, i) => i % 3 === k);
  near([Math.min(...along(2)), Math.max(...along(2)), Math.max(...along(0))], [0, 2, 0.1]);
  geometry.computeBoundingSphere();
  const { version } = geometry.attributes.position;
  move(part, {
    paths: [
      [
        [0, 0, 0],
        [0, 0, 5],
      ],
    ],
  });
  assert.equal(part.objects[0].geometry, geometry);
  near([Math.max(...along(2))], [5]);
  assert.ok(geometry.attributes.position.version > version);
  assert.ok(geometry.attributes.normal.version > 0);
  assert.equal(geometry.boundingSphere, null);
  let disposed = false;
  geometry.addEventListener("dispose", () => (disposed = true));
  move(part, {
    paths: [
      [
        [0, 0, 0],
        [0, 0, 1],
        [0, 0, 3],
      ],
    ],
  });
  assert.ok(disposed);
  assert.notEqual(part.objects[0].geometry, geometry);
  near([Math.max(...along(2))], [3]);
});

test("an arrow reaches from one point to the other", () => {
  const part = square({ radius: 0.02 });
  move(part, { from: [0, 0, 1], to: [0, 0, 3] });
  const heights = [...positions(part)].filter((_, i) => i % 3 === 2);
  near([Math.min(...heights), Math.max(...heights)], [1, 3]);
  assert.ok(part.objects[0].geometry.index.count > 0);
});

test("the points of a surface move, and those of its equal stay", () => {
  const [part, equal] = [square(), square()];
  equal.objects.forEach((object) => (object.geometry = part.objects[0].geometry));
  const shared = part.objects[0].geometry;
  const points = [
    [0, 0, 1],
    [0, 1, 1],
    [0, 1, 2],
    [0, 0, 2],
  ];
  move(part, { points });
  const own = part.objects[0].geometry;
  near(positions(part), points.flat());
  near([...own.attributes.normal.array.slice(0, 3)], [1, 0, 0]);
  near(positions(equal), SQUARE);
  assert.notEqual(own, shared);
  own.computeBoundingSphere();
  const { version } = own.attributes.position;
  move(part, { points: points.map(([x, y, z]) => [x, y, -z]) });
  assert.equal(part.objects[1].geometry, own);
  near(positions(part).slice(0, 3), [0, 0, -1]);
  near([...own.attributes.normal.array.slice(0, 3)], [-1, 0, 0]);
  assert.ok(own.attributes.position.version > version);
  assert.equal(own.boundingSphere, null);
});

test("a part without normals gets none", () => {
  const part = square();
  part.objects[0].geometry.deleteAttribute("normal");
  move(part, {
    points: [
      [0, 0, 1],
      [0, 1, 1],
      [0, 1, 2],
      [0, 0, 2],
    ],
  });
  assert.ok(!part.objects[0].geometry.attributes.normal);
});

test("a part takes its matrix, and what hides labels goes with it", () => {
  const part = square();
  const rest = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 2]);
  part.surface = { rest, positions: rest.slice() };
  const matrix = new Matrix4().set(0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 2, 7, 0, 0, 0, 1).toArray();
  for (let i = 0; i < 2; i++) {
    move(part, { matrix });
    for (const object of part.objects) near(object.matrix.elements, matrix);
    near(part.surface.positions, [5, 6, 7, 5, 7, 7, 4, 7, 7, 4, 6, 11]);
  }
});

test("a part that hides nothing takes its matrix, too", () => {
  const part = square();
  const matrix = new Matrix4().makeTranslation(1, 2, 3).toArray();
  move(part, { matrix });
  near(part.objects[1].matrix.elements, matrix);
});

test("lines of one width, which have another material, keep their color", () => {
  const objects = [{ material: { uniforms: {} } }];
  move({ objects, place: {} }, { color: [0, 0, 0] });
  assert.deepEqual(objects, [{ material: { uniforms: {} } }]);
});

test("small faces that move are lit from the side to which they turn", () => {
  const geometry = new BufferGeometry();
  const corners = [
    [0, 0, 0],
    [0.01, 0, 0],
    [0, 0.01, 0],
  ];
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flat()), 3));
  geometry.setAttribute(
    "normal",
    new BufferAttribute(new Int8Array([0, 0, 127, 0, 0, 127, 0, 0, 127]), 3, true),
  );
  const part = { objects: [{ geometry, visible: true }], place: {} };
  move(part, { points: corners.map(([x, y, z]) => [z, x, y]) });
  assert.deepEqual(
    [...part.objects[0].geometry.attributes.normal.array],
    [1, 0, 0, 1, 0, 0, 1, 0, 0],
  );
});
