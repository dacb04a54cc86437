/* Reads a scene: what to draw, what hides labels, and how the camera starts. */
import { Sphere } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { dress } from "./looks.js";

/**
 * @param {ArrayBuffer} file binary glTF as `rotedu.figures.gltf` writes it
 * @returns the objects to draw, the surfaces that hide labels, the sphere around everything, the
 *   coordinates of all points, the camera of the poster
 */
export async function read(file) {
  const { scene } = await new GLTFLoader().parseAsync(file, "");
  scene.updateMatrixWorld(true);
  const { camera, lights } = scene.userData;
  const objects = [];
  const surfaces = [];
  const clouds = [];
  const around = new Sphere();
  scene.traverse((part) => {
    if (!part.geometry) return;
    part.geometry.computeBoundingSphere();
    around.union(part.geometry.boundingSphere.clone().applyMatrix4(part.matrixWorld));
    const positions = part.geometry.attributes.position.clone().applyMatrix4(part.matrixWorld).array;
    clouds.push(positions);
    const pickable = part.userData.pickable ?? part.parent.userData.pickable;
    if (part.isMesh && pickable) surfaces.push(surface(part, positions));
    objects.push(...dress(part, lights));
  });
  return { objects, surfaces, around, clouds, camera };
}

/** The faces of a part, with positions in the coordinates of the scene. */
function surface({ geometry, material }, positions) {
  return {
    positions,
    corners: geometry.index.array,
    seeThrough: material.opacity < 1,
  };
}
