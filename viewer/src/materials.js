/* The looks of VTK: light without gamma, on both sides of a surface. And a ball of glass. */
import {
  Color,
  ColorManagement,
  DoubleSide,
  Mesh,
  NoBlending,
  NormalBlending,
  Points,
  ShaderMaterial,
  Vector3,
  Vector4,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

ColorManagement.enabled = false;

// What the unit ball has to do with a part.
const NOTHING = 0;
const IS_BALL = 1;
const MAY_BE_BEHIND = 2;

// Which sides of a surface to draw.
const BACK = -1;
const BOTH = 0;
const FRONT = 1;

const VERTEX = /* glsl */ `
  uniform vec3 base;
  uniform float pointSize;
  varying vec3 place;
  varying vec3 direction;
  varying vec4 tint;
  uniform vec4 ball;
  varying vec3 ballEye;
  varying vec3 ballPlace;

  vec3 gamma(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
  }

  void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    place = seen.xyz;
    direction = normalMatrix * normal;
    tint = vec4(base, 1.0);
    #ifdef USE_COLOR_ALPHA
      tint = vec4(gamma(color.rgb), color.a);
    #endif
    gl_Position = projectionMatrix * seen;
    gl_PointSize = pointSize;
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
  uniform float opacity;
  uniform float ambient;
  uniform float diffuse;
  uniform vec3 specular;
  uniform float specularPower;
  uniform int sides;
  uniform bool lit;
  uniform bool smoothed;
  uniform bool isPoint;
  uniform bool isRound;
  uniform vec3 toward[LIGHTS];
  uniform vec3 light[LIGHTS];
  varying vec3 place;
  varying vec3 direction;
  varying vec4 tint;

  vec3 normalHere() {
    if (isPoint) {
      vec2 p = isRound ? vec2(2.0, -2.0) * (gl_PointCoord - 0.5) : vec2(0.0);
      if (dot(p, p) > 1.0) discard;
      return vec3(p, sqrt(1.0 - dot(p, p)));
    }
    vec3 flatNormal = cross(dFdx(place), dFdy(place));
    if (!smoothed) return normalize(flatNormal) * -sign(dot(flatNormal, place));
    return normalize(direction) * (gl_FrontFacing ? 1.0 : -1.0);
  }

  void main() {
    if (!isPoint && sides * (gl_FrontFacing ? 1 : -1) < 0) discard;
    if (ballRole == ${IS_BALL}) {
      gl_FragColor = ballColor(ballEye, ballPlace, gl_FrontFacing);
      return;
    }
    vec3 n = normalHere();
    vec3 color = (ambient + (lit ? 0.0 : diffuse)) * tint.rgb;
    for (int i = 0; lit && i < LIGHTS; i++) {
      float facing = max(0.0, dot(n, toward[i]));
      color += facing * diffuse * light[i] * tint.rgb;
      float shine = max(0.0, dot(reflect(-toward[i], n), normalize(-place)));
      if (facing > 0.0) color += pow(shine, specularPower) * specular * light[i];
    }
    // Only opaque parts can be behind a ball, and they do not blend.
    float clear = ballRole == ${MAY_BE_BEHIND} ? ballClear(ballEye, ballPlace) : 1.0;
    gl_FragColor = vec4(clear * color, clear * opacity * tint.a);
  }
`;

/**
 * One program draws everything but lines, because compiling another takes longer than a frame. So
 * three believes that all materials blend and show both sides; only numbers differ.
 */
function shader({ material, geometry, isPoints }, lights, sides = BOTH) {
  const { userData: looks, transparent } = material;
  const uniforms = {
    base: material.color.clone().convertLinearToSRGB(),
    opacity: material.opacity,
    ambient: looks.ambient,
    diffuse: looks.diffuse,
    specular: new Color(...looks.specular),
    specularPower: looks.specularPower,
    pointSize: looks.pointSize,
    sides,
    ball: new Vector4(...(looks.ball ?? looks.behind ?? [0, 0, 0, 1])),
    ballRole: looks.ball ? IS_BALL : looks.behind ? MAY_BE_BEHIND : NOTHING,
    // Light falls on points only if they are drawn as balls.
    lit: looks.lit && (!isPoints || looks.roundPoints),
    smoothed: "normal" in geometry.attributes,
    isPoint: Boolean(isPoints),
    isRound: looks.roundPoints,
    toward: lights.map(({ toward }) => new Vector3(...toward)),
    light: lights.map(({ color }) => new Vector3(...color)),
  };
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT(),
    defines: { LIGHTS: Math.max(1, lights.length) },
    uniforms: Object.fromEntries(Object.entries(uniforms).map(([key, value]) => [key, { value }])),
    vertexColors: "color" in geometry.attributes,
    side: DoubleSide,
    transparent,
    depthWrite: !transparent,
    blending: transparent ? NormalBlending : NoBlending,
  });
}

/** Draw a see-through surface in two steps, because its contents come in between. */
function surface(part, lights) {
  const { transparent, side } = part.material;
  let steps = [side === DoubleSide ? BOTH : FRONT];
  if (transparent && side === DoubleSide) steps = [BACK, FRONT];
  return steps.map((sides) => new Mesh(part.geometry, shader(part, lights, sides)));
}

/** Draw lines, which have no sides, so no light falls on them. */
function lines({ material, geometry }) {
  const { ambient, diffuse, lineWidth } = material.userData;
  const color = material.color
    .clone()
    .convertLinearToSRGB()
    .multiplyScalar(ambient + diffuse);
  const looks = new LineMaterial({
    color,
    opacity: material.opacity,
    transparent: material.transparent,
    linewidth: lineWidth,
  });
  const positions = geometry.attributes.position;
  const end = new Vector3();
  const ends = [...geometry.index.array].flatMap((i) =>
    end.fromBufferAttribute(positions, i).toArray(),
  );
  const pieces = new LineSegmentsGeometry();
  pieces.setPositions(ends);
  return [new LineSegments2(pieces, looks)];
}

/**
 * Make the objects that draw one part of a glTF scene.
 * @param part the part as three's loader returns it
 * @param {{toward: number[], color: number[]}[]} lights in the coordinates of the camera
 */
export function dress(part, lights) {
  let drawn;
  if (part.isPoints) drawn = [new Points(part.geometry, shader(part, lights))];
  else if (part.isLineSegments) drawn = lines(part);
  else drawn = surface(part, lights);
  for (const object of drawn) {
    object.matrix.copy(part.matrixWorld);
    object.matrixAutoUpdate = false;
  }
  return drawn;
}

/** Scale widths, which are in pixels of the poster, to the size of the picture. */
export function scaleWidths(objects, factor) {
  for (const { material, userData } of objects) {
    const width = material.isLineMaterial
      ? material.uniforms.linewidth
      : material.uniforms.pointSize;
    userData.width ??= width.value;
    width.value = userData.width * factor;
  }
}

const isBack = ({ material }) => material.uniforms.sides?.value === BACK;

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
