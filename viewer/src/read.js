/* Reads a scene: what to draw, what hides labels, and how the camera starts. */
import { Sphere } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { dress } from "./materials.js";
import { castShadow, drawn } from "./parts.js";

/** @import { BufferGeometry, Material, Mesh } from "three" */

/**
 * @param {ArrayBuffer} file binary glTF as `rotedu.figures.gltf` writes it
 * @returns the objects to draw, the parts by name, the surfaces that hide labels, the sphere around everything, the
 *   coordinates of all points, the camera of the poster
 */
export async function read(file) {
  const { scene } = await new GLTFLoader().parseAsync(file, "");
  scene.updateMatrixWorld(true);
  const { camera } = scene.userData;
  const objects = [];
  /** @type {Map<string, import("./types.js").Part>} */
  const parts = new Map();
  const surfaces = [];
  const clouds = [];
  const grounds = [];
  const around = new Sphere();
  scene.traverse((object) => {
    const part = /** @type {Mesh<BufferGeometry, Material>} */ (object);
    if (!part.geometry) return;
    if (part.userData.lengths) {
      part.geometry = drawn(part.geometry, { ...part.userData, ...part.material.userData });
    }
    const { geometry, matrixWorld } = part;
    const positions = geometry.attributes.position.clone().applyMatrix4(matrixWorld).array;
    clouds.push(positions);
    geometry.computeBoundingSphere();
    const sphere = geometry.boundingSphere?.clone().applyMatrix4(matrixWorld);
    if (sphere) around.union(sphere);
    const { userData } = part;
    const { userData: looks } = part.material;
    const { name, pickable, hidden, ...place } = userData;
    const dressed = dress(part);
    const hides = part.isMesh && pickable ? surface(part, positions, sphere) : undefined;
    if (hides) surfaces.push(hides);
    for (const object of dressed) object.visible = !hidden;
    parts.set(name, { objects: dressed, place, surface: hides });
    if (looks.of) grounds.push({ of: looks.of, objects: dressed });
    objects.push(...dressed);
  });
  for (const { of, objects } of grounds) {
    const spoon = /** @type {import("./types.js").Part} */ (parts.get(of));
    spoon.ground = objects;
    castShadow(spoon);
  }
  return { objects, parts, surfaces, around, clouds, camera };
}

/** The faces of a part, with positions in the coordinates of the scene. */
function surface({ geometry, material }, positions, around) {
  return {
    positions,
    rest: geometry.attributes.position.array,
    corners: geometry.index.array,
    around,
    seeThrough: material.opacity < 1,
  };
}
