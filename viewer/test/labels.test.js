import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { PerspectiveCamera, Ray, SphereGeometry, Vector3 } from "three";
import { apart, crossings, isHidden, project } from "../src/labels.js";

function ball(seeThrough = false) {
  const geometry = new SphereGeometry(1, 48, 32);
  return {
    positions: geometry.attributes.position.array,
    corners: geometry.index.array,
    seeThrough,
  };
}

const square = { positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], corners: [0, 1, 2, 0, 2, 3] };

test("labels are where three's camera sees their points", () => {
  const camera = new PerspectiveCamera(30, 1.5, 0.1, 100);
  camera.up.set(0, 0, 1);
  camera.position.set(4, -2, 2);
  camera.lookAt(0, 0, 0.1);
  camera.updateMatrixWorld();
  const matrix = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
  for (const point of [
    [0, 0, 0.1],
    [1, 0.5, -0.3],
    [-2, 1, 1],
  ]) {
    const seen = new Vector3(...point).project(camera);
    const { left, top, inside } = project(matrix, point);
    assert.ok(Math.abs(left - (1 + seen.x) / 2) < 1e-9);
    assert.ok(Math.abs(top - (1 - seen.y) / 2) < 1e-9);
    assert.ok(inside);
  }
  for (const outside of [
    [8, -4, 4],
    [0, 3, 0],
    [0, 0, 2],
    [0, 0, -2],
  ]) {
    assert.ok(!project(matrix, outside).inside);
  }
});

describe("crossings", () => {
  test("are counted on the way alone", () => {
    assert.equal(crossings(square, [0.3, 0.1, 1], [0.3, 0.1, -1]), 1);
    assert.equal(crossings(square, [0.3, 0.1, 1], [0.3, 0.1, 0.5]), 0);
    assert.equal(crossings(square, [0.3, 0.1, -1], [0.3, 0.1, -2]), 0);
    assert.equal(crossings(square, [2, 0, 1], [2, 0, -1]), 0);
  });

  test("of a slanting face are those that three finds", () => {
    const [a, b, c] = [
      [0.2, -0.1, 0.3],
      [1.1, 0.4, -0.5],
      [-0.3, 0.9, 0.6],
    ];
    const face = { positions: [a, b, c].flat(), corners: [0, 1, 2] };
    const corners = [a, b, c].map((corner) => new Vector3(...corner));
    let hits = 0;
    for (let i = 0; i < 400; i++) {
      const [from, to] = [0, 3].map((k) =>
        [1, 2, 3].map((j) => 1.5 * Math.sin((7 * i + 1) * (j + k))),
      );
      const way = new Vector3(...to).sub(new Vector3(...from));
      const ray = new Ray(new Vector3(...from), way.clone().normalize());
      const hit = ray.intersectTriangle(...corners, false, new Vector3());
      const wanted = hit && hit.distanceTo(ray.origin) < way.length() ? 1 : 0;
      assert.equal(crossings(face, from, to), wanted);
      hits += wanted;
    }
    assert.ok(hits > 10);
  });

  test("in the edge between two faces are one", () => {
    assert.equal(crossings(square, [0.5, 0.5, 1], [0.5, 0.5, -1]), 1);
  });

  test("of a ball are two, in and out", () => {
    assert.equal(crossings(ball(), [0.1, 0.2, 3], [0.15, 0.1, -3]), 2);
    assert.equal(crossings(ball(), [0.1, 0.2, 3], [0.15, 0.1, 0]), 1);
  });

  test("stop at the limit", () => {
    assert.equal(crossings(ball(), [0.1, 0.2, 3], [0.15, 0.1, -3], 1), 1);
  });

  test("ignore faces without area", () => {
    assert.equal(crossings({ ...square, corners: [0, 0, 2] }, [0, 0, 1], [0, 0, -1]), 0);
  });
});

describe("hidden is a label", () => {
  const eye = [0.3, 0.2, 5];
  const places = [1.5, 0.999, 0, -0.999, -1.5].map((z) => [0.01, 0.01, z]);

  test("in and behind an opaque ball", () => {
    const hidden = places.map((place) => isHidden([ball()], eye, place));
    assert.deepEqual(hidden, [false, false, true, true, true]);
  });

  test("behind a glass ball alone", () => {
    const hidden = places.map((place) => isHidden([ball(true)], eye, place));
    assert.deepEqual(hidden, [false, false, false, false, true]);
  });

  test("nowhere without surfaces", () => {
    assert.ok(!isHidden([], eye, places[4]));
  });
});

describe("labels give way", () => {
  const box = (x, y, width = 20, height = 10) => ({ x, y, width, height });
  /** By how much two boxes overlap: the shorter way apart. */
  const overlap = (a, b) =>
    Math.min(
      (a.width + b.width) / 2 - Math.abs(a.x - b.x),
      (a.height + b.height) / 2 - Math.abs(a.y - b.y),
    );
  const pushed = (boxes) =>
    apart(boxes).map(({ x, y }, i) => ({ ...boxes[i], x: boxes[i].x + x, y: boxes[i].y + y }));
  const worst = (boxes) =>
    Math.max(...boxes.flatMap((a, i) => boxes.slice(0, i).map((b) => overlap(a, b))));

  test("by half of the shorter way each, and not at all if they only touch", () => {
    const still = { x: 0, y: 0 };
    assert.deepEqual(apart([box(0, 0), box(20, 3), box(0, 10)]), [still, still, still]);
    assert.deepEqual(apart([box(0, 0), box(3, 6)]), [
      { x: 0, y: -2 },
      { x: 0, y: 2 },
    ]);
    assert.deepEqual(apart([box(0, 0), box(3, -6)]), [
      { x: 0, y: 2 },
      { x: 0, y: -2 },
    ]);
    assert.deepEqual(apart([box(0, 0), box(-17, 1)]), [
      { x: 1.5, y: 0 },
      { x: -1.5, y: 0 },
    ]);
    assert.deepEqual(apart([]), []);
  });

  test("also if they lie in one place, and in a crowd", () => {
    const crowd = [0, 1, 2, 3, 4, 5].map((i) =>
      box(7 * Math.sin(5 * i), 4 * Math.cos(3 * i), 14 + i),
    );
    for (const boxes of [[box(5, 5), box(5, 5)], [box(5, 5), box(5, 5), box(5, 5)], crowd]) {
      assert.ok(worst(boxes) > 1);
      assert.ok(worst(pushed(boxes)) < 0.5, `${worst(pushed(boxes))}`);
      const far = apart(boxes).map(({ x, y }) => Math.hypot(x, y));
      assert.ok(Math.max(...far) < 40);
    }
  });

  test("without a leap", () => {
    let before;
    for (let y = 12; y > 1; y -= 0.1) {
      const [, { y: now }] = pushed([box(0, 0), box(4, y)]);
      if (before !== undefined) assert.ok(Math.abs(now - before) < 0.2);
      before = now;
    }
  });
});
