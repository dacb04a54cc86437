// The light on solid bodies, the same in VTK and in three: a white room with a window and a bright
// ceiling, which stay where the camera is. Directions are in its coordinates: to the right, up, and
// back to the eye. Colours come and go as a screen shows them; in between light is linear.

const vec3 LIGHT_SKY = vec3(0.66, 0.68, 0.72);
const vec3 LIGHT_GROUND = vec3(0.30, 0.28, 0.26);
const vec3 LIGHT_UP = vec3(0.0, 0.905, 0.425);
const vec3 LIGHT_KEY_COLOR = vec3(0.58, 0.57, 0.55);
const vec3 LIGHT_KEY = vec3(-0.447, 0.671, 0.592);
// The sides of the window, across the direction of the key.
const vec3 LIGHT_ALONG = vec3(0.798, 0.602, 0.0);
const vec3 LIGHT_ACROSS = vec3(-0.356, 0.473, -0.806);
// How far the inside of a bowl is mixed with grey, so that front and back differ.
const float LIGHT_INSIDE = 0.06;

vec3 lightLinear(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

vec3 lightScreen(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

// How much of the window a ray meets: two panes, a bar between them, soft borders.
float lightWindow(vec3 ray) {
  float toward = dot(ray, LIGHT_KEY);
  vec2 at = abs(vec2(dot(ray, LIGHT_ALONG), dot(ray, LIGHT_ACROSS)) / max(toward, 1e-3));
  vec2 pane = 1.0 - smoothstep(vec2(0.46, 0.60), vec2(0.62, 0.80), at);
  return step(0.0, toward) * pane.x * pane.y * mix(0.35, 1.0, smoothstep(0.02, 0.07, at.x));
}

// The colour of a body whose side with a normal the eye sees; what gleams mirrors the room.
vec3 lightOn(vec3 color, vec3 normal, vec3 eye, float inside, float gleam) {
  vec3 body = mix(lightLinear(color), vec3(0.85), LIGHT_INSIDE * inside);
  float key = max(0.0, (dot(normal, LIGHT_KEY) + 0.2) / 1.2);
  vec3 light = mix(LIGHT_GROUND, LIGHT_SKY, 0.5 + 0.5 * dot(normal, LIGHT_UP));
  light += LIGHT_KEY_COLOR * key * key;
  float rim = pow(1.0 - clamp(dot(normal, eye), 0.0, 1.0), 4.0);
  vec3 ray = reflect(-eye, normal);
  float ceiling = smoothstep(0.15, 0.75, dot(ray, LIGHT_UP));
  float shine = (0.03 + 0.20 * rim) * ceiling + 0.36 * lightWindow(ray);
  return lightScreen(min(body * light + gleam * shine, 1.0));
}

// The shadow of a spoon on the ground at a place in units of its half length; the columns of a matrix
// are its own axes, along the handle, across it and out of the bowl.
vec4 lightShadow(vec2 place, mat3 lying) {
  vec2 along = lying[0].xy;
  vec2 across = lying[1].xy;
  vec2 out_ = lying[2].xy;
  mat2 bowl = 0.16 * outerProduct(along, along) + 0.07 * outerProduct(across, across)
    + 0.02 * outerProduct(out_, out_) + mat2(0.015, 0.0, 0.0, 0.015);
  vec2 d = place - 0.62 * along;
  vec2 e = place - clamp(dot(place, along) / max(dot(along, along), 1e-4), -1.0, 0.3) * along;
  float dark = max(exp(-dot(d, inverse(bowl) * d)), 0.6 * exp(-dot(e, e) / 0.014));
  return vec4(0.05, 0.06, 0.08, 0.22 * dark);
}
