/* The geometry of the camera: what it sees of a scene. */
const DEGREES = 180 / Math.PI;
// How far a turned scene may reach: labels need some room at the border.
const ROOM = 0.93;

/**
 * The height of the field of view, in degrees, that shows the whole poster in a box of another
 * shape.
 * @param {number} viewAngle of the poster, in degrees
 * @param {number} posterAspect width over height of the poster
 * @param {number} aspect width over height of the box
 */
export function fieldOfView(viewAngle, posterAspect, aspect) {
  const half = Math.tan(viewAngle / 2 / DEGREES);
  return 2 * DEGREES * Math.atan(half * Math.max(1, posterAspect / aspect));
}

/**
 * The nearest and the farthest distance at which there is something to see.
 * @param {number} distance from the camera to the middle of the scene
 * @param {number} radius of the scene
 */
export function clipping(distance, radius) {
  const far = distance + radius;
  return { near: Math.max(distance - radius, far / 1000) * 0.99, far: far * 1.01 };
}

/**
 * For each of some directions, the one of many points that reaches farthest.
 * @param {ArrayLike<number>[]} clouds coordinates, three for each point
 * @param {number[]} center the origin of the directions
 * @returns {number[][]} points as seen from the center
 */
export function outermost(clouds, center, directions = 64) {
  return spread(directions).map(([x, y, z]) => {
    let highest = -Infinity;
    let farthest;
    for (const cloud of clouds) {
      for (let i = 0; i < cloud.length; i += 3) {
        const height = cloud[i] * x + cloud[i + 1] * y + cloud[i + 2] * z;
        if (height > highest) {
          highest = height;
          farthest = [cloud[i] - center[0], cloud[i + 1] - center[1], cloud[i + 2] - center[2]];
        }
      }
    }
    return farthest;
  });
}

/** Directions evenly spread over a sphere: a spiral whose turns differ by the golden angle. */
function spread(count) {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, i) => {
    const height = 1 - (2 * i + 1) / count;
    const radius = Math.sqrt(1 - height * height);
    return [radius * Math.cos(golden * i), radius * Math.sin(golden * i), height];
  });
}

/**
 * How far points reach towards the border of the picture: 0 is the middle, 1 is the border.
 * @param {number[][]} points as seen from what the camera looks at
 * @param {number[][]} axes of the camera: to the right, up and back, of length 1
 * @param {number} distance from the camera to what it looks at
 * @param {number[]} half width and height of the picture, at distance 1
 */
export function reach(points, [right, up, back], distance, half) {
  const along = (axis, point) => axis[0] * point[0] + axis[1] * point[1] + axis[2] * point[2];
  const far = points.map((point) => {
    const depth = distance - along(back, point);
    const x = Math.abs(along(right, point)) / half[0];
    const y = Math.abs(along(up, point)) / half[1];
    return Math.max(x, y) / Math.max(depth, distance / 1000);
  });
  return Math.max(...far);
}

/**
 * A field of view, in degrees, that cuts off no more of a turned scene than of the scene at rest.
 * @param {number} angle field of view at rest, in degrees
 * @param {number} now how far the scene reaches, turned
 * @param {number} atRest how far it reached at rest
 */
export function widened(angle, now, atRest) {
  const half = Math.tan(angle / 2 / DEGREES);
  return 2 * DEGREES * Math.atan(half * Math.max(1, now / Math.max(ROOM, atRest)));
}
