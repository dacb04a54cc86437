/* The looks of VTK: light without gamma, on both sides of a surface. And a ball of glass. */
import {
  Color,
  ColorManagement,
  DoubleSide,
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

// How much of white a part gets that stands out.
const BRIGHTER = 0.32;

// Which sides of a surface to draw.
const BACK = -1;
const BOTH = 0;
const FRONT = 1;

const VERTEX = /* glsl */ `
  varying vec3 place;
  varying vec3 direction;
  uniform vec4 ball;
  varying vec3 ballEye;
  varying vec3 ballPlace;

  void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    place = seen.xyz;
    direction = normalMatrix * normal;
    gl_Position = projectionMatrix * seen;
    ballEye = (cameraPosition - ball.xyz) / ball.w;
    ballPlace = ((modelMatrix * vec4(position, 1.0)).xyz - ball.xyz) / ball.w;
  }
`;

// BALL is the text of rotedu/figures/ball.glsl.
const FRAGMENT = () => /* glsl */ `
  ${BALL}
  uniform int ballRole;
  varying vec3 ballEye;
  varying vec3 ballPlace;
  uniform vec3 base;
  uniform float opacity;
  uniform float stress;
  uniform float ambient;
  uniform float diffuse;
  uniform vec3 specular;
  uniform float specularPower;
  uniform int sides;
  uniform bool lit;
  uniform bool smoothed;
  uniform vec3 toward[LIGHTS];
  uniform vec3 light[LIGHTS];
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
    vec3 n = normalHere();
    vec3 color = (ambient + (lit ? 0.0 : diffuse)) * base;
    for (int i = 0; lit && i < LIGHTS; i++) {
      float facing = max(0.0, dot(n, toward[i]));
      color += facing * diffuse * light[i] * base;
      float shine = max(0.0, dot(reflect(-toward[i], n), normalize(-place)));
      if (facing > 0.0) color += pow(shine, specularPower) * specular * light[i];
    }
    // What is stressed is nearer to white, what steps back lets the page through.
    color = mix(color, vec3(1.0), ${BRIGHTER} * max(0.0, stress - 1.0));
    // Only opaque parts can be behind a ball, and they do not blend.
    float clear = ballRole == ${MAY_BE_BEHIND} ? ballClear(ballEye, ballPlace) : 1.0;
    float faint = min(1.0, stress);
    gl_FragColor = vec4((opacity < 1.0 ? 1.0 : faint) * clear * color, faint * clear * opacity);
  }
`;

/**
 * One program draws everything, because compiling another takes longer than a frame. So
 * three believes that all materials blend and show both sides; only numbers differ.
 */
function shader({ material, geometry }, lights, sides) {
  const { userData: looks, transparent } = material;
  const uniforms = {
    base: material.color.clone().convertLinearToSRGB(),
    opacity: material.opacity,
    stress: 1,
    ambient: looks.ambient,
    diffuse: looks.diffuse,
    specular: new Color(...looks.specular),
    specularPower: looks.specularPower,
    sides,
    ball: new Vector4(...(looks.ball ?? looks.behind ?? [0, 0, 0, 1])),
    ballRole: looks.ball ? IS_BALL : looks.behind ? MAY_BE_BEHIND : NOTHING,
    lit: looks.lit,
    smoothed: "normal" in geometry.attributes,
    toward: lights.map(({ toward }) => new Vector3(...toward)),
    light: lights.map(({ color }) => new Vector3(...color)),
  };
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT(),
    defines: { LIGHTS: Math.max(1, lights.length) },
    uniforms: Object.fromEntries(Object.entries(uniforms).map(([key, value]) => [key, { value }])),
    side: DoubleSide,
    transparent,
    depthWrite: !transparent,
    blending: transparent ? NormalBlending : NoBlending,
  });
}

/**
 * Make the objects that draw one part of a glTF scene: a see-through surface in two steps, because
 * its contents come in between.
 * @param part the part as three's loader returns it
 * @param {{toward: number[], color: number[]}[]} lights in the coordinates of the camera
 */
export function dress(part, lights) {
  return (part.material.transparent ? [BACK, FRONT] : [BOTH]).map((sides) => {
    const drawn = new Mesh(part.geometry, shader(part, lights, sides));
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
