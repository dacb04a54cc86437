/* The looks of VTK: one light, on both sides of a surface. And a ball of glass. */
import {
  ColorManagement,
  DoubleSide,
  InstancedMesh,
  Matrix3,
  Mesh,
  NoBlending,
  NormalBlending,
  ShaderMaterial,
  Vector3,
  Vector4,
} from "three";

ColorManagement.enabled = false;

// What the unit ball has to do with a part.
const NOTHING = 0;
const IS_BALL = 1;
const MAY_BE_BEHIND = 2;
const IS_SHADOW = 3;

// How much of white a part gets that stands out.
const BRIGHTER = 0.32;

// Which sides of a surface to draw.
const BACK = -1;
const BOTH = 0;
const FRONT = 1;

const VERTEX = /* glsl */ `
  attribute float _inside;
  varying float isInside;
  varying vec3 place;
  varying vec3 direction;
  uniform vec4 ball;
  varying vec3 ballEye;
  varying vec3 ballPlace;

  void main() {
    vec4 point = vec4(position, 1.0);
    vec3 outwards = normal;
    #ifdef USE_INSTANCING
      point = instanceMatrix * point;
      outwards = mat3(instanceMatrix) * outwards;
    #endif
    vec4 seen = modelViewMatrix * point;
    place = seen.xyz;
    direction = normalMatrix * outwards;
    isInside = _inside;
    gl_Position = projectionMatrix * seen;
    ballEye = (cameraPosition - ball.xyz) / ball.w;
    ballPlace = ((modelMatrix * point).xyz - ball.xyz) / ball.w;
  }
`;

// SHADERS is the text of light.glsl and ball.glsl in rotedu/figures.
const FRAGMENT = () => /* glsl */ `
  ${SHADERS}
  uniform int ballRole;
  uniform mat3 lying;
  varying vec3 ballEye;
  varying vec3 ballPlace;
  varying float isInside;
  uniform vec3 base;
  uniform float opacity;
  uniform float stress;
  uniform float gleam;
  uniform int sides;
  uniform bool lit;
  uniform bool smoothed;
  varying vec3 place;
  varying vec3 direction;

  vec3 normalHere() {
    vec3 flatNormal = cross(dFdx(place), dFdy(place));
    if (!smoothed) return normalize(flatNormal) * -sign(dot(flatNormal, place));
    return normalize(direction) * (gl_FrontFacing ? 1.0 : -1.0);
  }

  void main() {
    if (sides * (gl_FrontFacing ? 1 : -1) < 0) discard;
    if (ballRole == ${IS_BALL}) {
      gl_FragColor = ballColor(ballEye, ballPlace, gl_FrontFacing);
      return;
    }
    if (ballRole == ${IS_SHADOW}) {
      gl_FragColor = lightShadow(ballPlace.xy, lying);
      return;
    }
    vec3 color = lit ? lightOn(base, normalHere(), normalize(-place), isInside, gleam) : base;
    // What is stressed is nearer to white, what steps back lets the page through.
    color = mix(color, vec3(1.0), ${BRIGHTER} * max(0.0, stress - 1.0));
    // Only opaque parts can be behind a ball, and they do not blend.
    float clear = ballRole == ${MAY_BE_BEHIND} ? ballClear(ballEye, ballPlace) : 1.0;
    float faint = min(1.0, stress);
    gl_FragColor = vec4((opacity < 1.0 ? 1.0 : faint) * clear * color, faint * clear * opacity);
  }
`;

/** What the ball has to do with a part, and the ball, or what the ground of a shadow has in its place. */
function roleOf({ ball, behind, shadow }) {
  if (ball) return { ballRole: IS_BALL, ball };
  if (behind) return { ballRole: MAY_BE_BEHIND, ball: behind };
  if (shadow) return { ballRole: IS_SHADOW, ball: shadow };
  return { ballRole: NOTHING, ball: [0, 0, 0, 1] };
}

/**
 * One program draws everything, because compiling another takes longer than a frame. So
 * three believes that all materials blend and show both sides; only numbers differ.
 */
function shader({ material, geometry }, sides) {
  const { userData: looks, transparent } = material;
  const { ballRole, ball } = roleOf(looks);
  const uniforms = {
    base: material.color.clone().convertLinearToSRGB(),
    opacity: material.opacity,
    stress: 1,
    gleam: looks.gleam,
    sides,
    ball: new Vector4(...ball),
    ballRole,
    lying: new Matrix3(),
    lit: looks.lit,
    smoothed: "normal" in geometry.attributes,
  };
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT(),
    uniforms: Object.fromEntries(Object.entries(uniforms).map(([key, value]) => [key, { value }])),
    side: DoubleSide,
    transparent,
    depthWrite: !transparent,
    blending: transparent ? NormalBlending : NoBlending,
  });
}

/** A mesh, or as many equal ones in their places. */
function like({ geometry, instanceMatrix, userData }, material) {
  if (!instanceMatrix) return new Mesh(geometry, material);
  const heap = new InstancedMesh(geometry, material, instanceMatrix.count);
  heap.instanceMatrix = instanceMatrix;
  heap.count = userData.count;
  heap.frustumCulled = false;
  return heap;
}

/**
 * Make the objects that draw one part of a glTF scene: a see-through surface in two steps, because
 * its contents come in between.
 * @param part the part as three's loader returns it
 */
export function dress(part) {
  return (part.material.transparent ? [BACK, FRONT] : [BOTH]).map((sides) => {
    const drawn = like(part, shader(part, sides));
    drawn.matrix.copy(part.matrixWorld);
    drawn.matrixAutoUpdate = false;
    return drawn;
  });
}

const isBack = ({ material }) => material.uniforms.sides.value === BACK;

/** Sort see-through surfaces from far to near; far sides count by far ends, near by near. */
export function sortSeeThrough(objects, camera) {
  const center = new Vector3();
  for (const object of objects.filter(({ material }) => material.transparent)) {
    const { geometry } = object;
    if (!geometry.boundingSphere) geometry.computeBoundingSphere();
    const { boundingSphere } = geometry;
    center.copy(boundingSphere.center).applyMatrix4(object.matrixWorld);
    const reach = boundingSphere.radius * object.matrixWorld.getMaxScaleOnAxis();
    const distance = center.distanceTo(camera.position);
    object.renderOrder = -(distance + (isBack(object) ? reach : -reach));
  }
}
