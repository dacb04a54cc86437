/* Reads a scene: what to draw, what hides labels, and how the camera starts. */
import { Sphere } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { dress } from "./materials.js";

/**
 * @param {ArrayBuffer} file binary glTF as `rotedu.figures.gltf` writes it
 * @returns the objects to draw, the parts by name, the surfaces that hide labels, the sphere around everything, the
 *   coordinates of all points, the camera of the poster
 */
export async function read(file) {
  const { scene } = await new GLTFLoader().parseAsync(file, "");
  scene.updateMatrixWorld(true);
  const { camera, lights } = scene.userData;
  const objects = [];
  const parts = new Map();
  const surfaces = [];
  const clouds = [];
  const around = new Sphere();
  scene.traverse((part) => {
    if (!part.geometry) return;
    part.geometry.computeBoundingSphere();
    around.union(part.geometry.boundingSphere.clone().applyMatrix4(part.matrixWorld));
    const positions = part.geometry.attributes.position
      .clone()
      .applyMatrix4(part.matrixWorld).array;
    clouds.push(positions);
    // A node with several primitives becomes a group.
    const node = "pickable" in part.userData ? part : part.parent;
    const drawn = dress(part, lights);
    const { name, pickable, hidden, ...place } = node.userData;
    const entry = { objects: drawn, place };
    if (part.isMesh && pickable) surfaces.push((entry.surface = surface(part, positions)));
    for (const object of drawn) object.visible = !hidden;
    parts.set(name, entry);
    objects.push(...drawn);
  });
  return { objects, parts, surfaces, around, clouds, camera };
}

/** The faces of a part, with positions in the coordinates of the scene. */
function surface({ geometry, material }, positions) {
  return {
    positions,
    rest: geometry.attributes.position.array,
    corners: geometry.index.array,
    seeThrough: material.opacity < 1,
  };
}
