import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera } from "three";
import { sortSeeThrough } from "../src/materials.js";
import { read } from "../src/read.js";

globalThis.BALL = "";
const LIGHT = { lit: true, ambient: 0, diffuse: 1, specular: [0, 0, 0], specularPower: 1 };
const LOOKS = { ...LIGHT, lineWidth: 3, pointSize: 5, roundPoints: false };

/** A binary glTF file with a square, once as a surface, once as lines, once as points. */
function file({ opacity = 1, matrix, extras } = {}) {
  const positions = new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]);
  const normals = new Int8Array([0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0]);
  const corners = new Uint16Array([0, 1, 2, 3]);
  const material = {
    pbrMetallicRoughness: { baseColorFactor: [0.2158605, 1, 0, opacity] },
    doubleSided: true,
    ...(opacity < 1 && { alphaMode: "BLEND" }),
    extras: LOOKS,
  };
  const primitive = (mode) => ({
    primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, mode, material: 0 }],
  });
  const document = {
    asset: { version: "2.0" },
    extensionsUsed: ["KHR_mesh_quantization"],
    scene: 0,
    scenes: [
      {
        nodes: [0, 1, 2],
        extras: {
          camera: { viewAngle: 30 },
          lights: [{ toward: [0, 0, 1], color: [0.5, 0.5, 0.5] }],
        },
      },
    ],
    nodes: [
      { mesh: 0, extras: { pickable: true, ...extras }, ...(matrix && { matrix }) },
      { mesh: 1, extras: { pickable: true } },
      { mesh: 2, extras: { pickable: false } },
    ],
    meshes: [primitive(5), primitive(1), primitive(0)],
    materials: [material],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: 4,
        type: "VEC3",
        min: [-1, -1, 0],
        max: [1, 1, 0],
      },
      { bufferView: 1, componentType: 5120, count: 4, type: "VEC3", normalized: true },
      { bufferView: 2, componentType: 5123, count: 4, type: "SCALAR" },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 16, byteStride: 4 },
      { buffer: 0, byteOffset: 64, byteLength: 8 },
    ],
    buffers: [{ byteLength: 72 }],
  };
  const text = JSON.stringify(document);
  const json = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const binary = Buffer.concat([positions, normals, corners].map((a) => Buffer.from(a.buffer)));
  const words = (...numbers) => Buffer.from(new Uint32Array(numbers).buffer);
  const head = words(0x46546c67, 2, 12 + 8 + json.length + 8 + binary.length);
  const jsonHead = words(json.length, 0x4e4f534a);
  const binaryHead = words(binary.length, 0x004e4942);
  return new Uint8Array(Buffer.concat([head, jsonHead, json, binaryHead, binary])).buffer;
}

test("a scene has its parts, the surfaces that hide labels and its surroundings", async () => {
  const { objects, surfaces, around, camera } = await read(file());
  assert.equal(objects.length, 3);
  assert.equal(surfaces.length, 1);
  assert.deepEqual([...surfaces[0].positions.slice(0, 3)], [-1, -1, 0]);
  assert.deepEqual([...surfaces[0].corners], [0, 1, 2, 3, 2, 1]);
  assert.ok(!surfaces[0].seeThrough);
  assert.ok(Math.abs(around.radius - Math.SQRT2) < 1e-6);
  assert.equal(camera.viewAngle, 30);
});

test("colours are those of the screen again, lines without light", async () => {
  const { objects } = await read(file());
  const [surface, lines] = objects;
  const { r, g, b } = surface.material.uniforms.base.value;
  for (const [value, wanted] of [
    [r, 128 / 255],
    [g, 1],
    [b, 0],
  ]) {
    assert.ok(Math.abs(value - wanted) < 1e-3);
  }
  assert.ok(Math.abs(lines.material.color.g - 1) < 1e-3);
  assert.equal(lines.material.linewidth, 3);
});

test("a part has a name, a place and what draws it, and may wait to be shown", async () => {
  const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
  const extras = { name: "square", at: [1, 2, 3], hidden: true };
  const { parts, objects, surfaces, clouds } = await read(file({ extras, matrix }));
  const { place, surface, objects: drawn } = parts.get("square");
  assert.deepEqual(place, { at: [1, 2, 3] });
  assert.equal(surface, surfaces[0]);
  assert.equal(drawn[0], objects[0]);
  assert.deepEqual(
    objects.map(({ visible }) => visible),
    [false, true, true],
  );
  assert.deepEqual(
    clouds.map((cloud) => [...cloud.slice(0, 3)]),
    [
      [4, 5, 7],
      [-1, -1, 0],
      [-1, -1, 0],
    ],
  );
});

test("what is moved hides labels where it is", async () => {
  const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1];
  const { objects, surfaces } = await read(file({ matrix }));
  assert.deepEqual([...surfaces[0].positions.slice(0, 3)], [4, 5, 7]);
  assert.deepEqual(objects[0].matrix.elements.slice(12, 15), [5, 6, 7]);
});

test("see-through surfaces are drawn far side first", async () => {
  const { objects, surfaces } = await read(file({ opacity: 0.5 }));
  assert.ok(surfaces[0].seeThrough);
  const camera = new PerspectiveCamera();
  camera.position.set(0, 0, 5);
  sortSeeThrough(objects, camera);
  const [back, front] = objects;
  assert.ok(back.renderOrder < front.renderOrder);
  assert.ok(Math.abs(front.renderOrder - back.renderOrder - 2 * Math.SQRT2) < 1e-6);
});
