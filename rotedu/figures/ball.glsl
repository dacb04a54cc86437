// A glass ball with a graticule, the same in VTK and in three. The ball is the unit sphere of its own
// coordinates; eye and place are in these, too. Whatever mesh contains it, each pixel's ray is cut
// with the sphere itself, so that outline, shading and graticule are exact.

const vec3 BALL_INK = vec3(0.47, 0.51, 0.56);
const vec3 BALL_SHADE = vec3(0.42, 0.46, 0.52);
const vec3 BALL_SUNNY = vec3(0.66, 0.70, 0.75);
// Half the width of a line of the graticule.
const float BALL_LINE = 0.0025;
// How much is seen of what stands behind the ball.
const float BALL_BEHIND = 0.38;

// How far beyond the sphere's middle the ray is nearest to it, and the square of half its chord.
vec2 ballChord(vec3 eye, vec3 ray) {
  float nearest = -dot(ray, eye);
  return vec2(nearest, 1.0 - dot(eye, eye) + nearest * nearest);
}

// Meridians and parallels, 30 degrees apart, at a point of the sphere.
float ballGraticule(vec3 n) {
  float grid = 0.0;
  for (int k = 0; k < 11; k++) {
    bool meridian = k < 6;
    float angle = radians(30.0 * float(meridian ? k : k - 8));
    vec2 along = vec2(cos(angle), sin(angle));
    float far = meridian ? n.x * along.y - n.y * along.x : (n.z - along.y) / along.x;
    float pixel = max(length(vec2(dFdx(far), dFdy(far))), 1e-5);
    vec2 sides = clamp((far + vec2(BALL_LINE, -BALL_LINE)) / pixel + 0.5, 0.0, 1.0);
    float line = sides.x - sides.y;
    // Only two of the six meridians reach the poles, or their lines would make a blot there.
    if (meridian && k % 3 != 0) line *= smoothstep(0.12, 0.3, length(n.xy));
    grid = max(grid, line);
  }
  return grid;
}

// The colour of a ball where the ray through a place of its mesh goes in, or else out.
vec4 ballColor(vec3 eye, vec3 place, bool goesIn) {
  vec3 ray = normalize(place - eye);
  vec2 chord = ballChord(eye, ray);
  float edge = clamp(chord.y / max(fwidth(chord.y), 1e-6), 0.0, 1.0);
  // Half the chord is the cosine between ray and normal.
  float facing = sqrt(max(chord.y, 0.0));
  vec3 n = normalize(eye + (chord.x + (goesIn ? -facing : facing)) * ray);
  float rim = pow(1.0 - facing, 2.6);
  float grid = ballGraticule(n);
  vec3 sun = normalize(eye / max(length(eye), 1e-3) + vec3(0.0, 0.0, 0.8));
  vec3 tint = mix(BALL_SHADE, BALL_SUNNY, smoothstep(0.25, 1.0, 0.5 + 0.5 * dot(n, sun)));
  // For an eye within the ball, its far side is all there is.
  bool isFront = goesIn || dot(eye, eye) < 1.0;
  float glass = goesIn ? mix(0.05, 0.66, rim) : mix(0.035, 0.0, rim);
  float ink = (isFront ? 0.5 : 0.17) * grid;
  float alpha = glass + (1.0 - glass) * ink;
  return vec4(mix(mix(tint, BALL_INK, rim), BALL_INK, ink / max(alpha, 1e-4)), alpha * edge);
}

// How much is seen of a place: all of it before the ball, within it, beside it and from within.
float ballClear(vec3 eye, vec3 place) {
  float chord = ballChord(eye, normalize(place - eye)).y;
  if (chord < 0.0 || dot(eye, eye) < 1.0) return 1.0;
  // Beyond the horizon, this is below zero.
  float height = (dot(place, eye) - 1.0) / length(eye);
  float behind = 1.0 - smoothstep(-0.1, 0.0, height);
  // A point on the far side reaches some way into the ball.
  return mix(1.0, BALL_BEHIND, behind * smoothstep(0.7, 0.9, length(place)));
}
