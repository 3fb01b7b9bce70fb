// How surfaces and points are lit. Colours are worked out here down to the screen's own numbers, so
// that matte clay, lamps and colour scales look the same everywhere.
import { Color, DataTexture, DoubleSide, LinearFilter, ShaderMaterial, Vector3 } from 'three';
import { texels, type Scale } from './colour';

export type Shading = 'matte' | 'reflection' | 'mean' | 'gauss' | 'error' | 'distance';
export const kShadings: readonly Shading[] = ['matte', 'reflection', 'mean', 'gauss', 'error', 'distance'];
/** Whether the values are on both sides of zero. */
export const isSigned = (shading: Shading): boolean => shading === 'mean' || shading === 'gauss';

const kSurfaceVertex = `
attribute float value;
varying vec3 vPosition;
varying vec3 vNormal;
varying float vValue;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vPosition = place.xyz;
  vNormal = normalMatrix * normal;
  vValue = value;
  gl_Position = projectionMatrix * place;
}`;

const kSurfaceFragment = `
uniform vec3 front;
uniform vec3 back;
uniform int mode;      // 0 matte, 1 lamps, 2 colour scale
uniform bool facets;
uniform vec3 worldUp;  // in view space
uniform vec3 worldSide;
uniform vec2 range;
uniform sampler2D scale;
varying vec3 vPosition;
varying vec3 vNormal;
varying float vValue;

float lambert(vec3 n, vec3 l) { return max(dot(n, normalize(l)), 0.0); }

// A mirror under a sky of sixteen parallel lamps: where the bands break, the surface has a kink.
vec3 lamps(vec3 n) {
  vec3 r = reflect(normalize(vPosition), n);
  vec2 across = vec2(dot(r, worldSide), dot(r, worldUp));
  float angle = atan(across.x, across.y) * (8.0 / 3.14159265);
  float wave = abs(fract(angle) - 0.5) * 2.0;
  // From the vector and not from the angle, which jumps where it has gone round.
  float turn = length(fwidth(across)) / max(length(across), 1e-4) * (8.0 / 3.14159265);
  float width = clamp(turn * 1.2, 0.02, 1.0);
  float lit = smoothstep(0.5 - width, 0.5 + width, wave);
  float rim = pow(1.0 - abs(n.z), 3.0);
  return mix(vec3(0.075, 0.085, 0.11), vec3(0.93, 0.945, 0.96), lit) * (0.86 + 0.14 * n.y) + 0.06 * rim;
}

void main() {
  vec3 n = facets ? normalize(cross(dFdx(vPosition), dFdy(vPosition))) : normalize(vNormal);
  if (!facets && !gl_FrontFacing) n = -n;
  if (mode == 1) {
    gl_FragColor = vec4(lamps(n), 1.0);
    return;
  }
  vec3 base = gl_FrontFacing ? front : back;
  float light = 0.30 + 0.22 * (0.5 + 0.5 * n.y) + 0.62 * lambert(n, vec3(-0.45, 0.75, 0.65))
              + 0.14 * lambert(n, vec3(0.8, 0.1, 0.4));
  if (mode == 2) {
    float t = (vValue - range.x) / (range.y - range.x);
    base = texture2D(scale, vec2(clamp(t, 0.002, 0.998), 0.5)).rgb;
    base = pow(base, vec3(2.2));
    light = mix(1.0, light, 0.45);
  } else {
    base = pow(base, vec3(2.2));
  }
  vec3 h = normalize(normalize(vec3(-0.45, 0.75, 0.65)) + vec3(0.0, 0.0, 1.0));
  float gloss = mode == 0 && !facets ? 0.10 * pow(max(dot(n, h), 0.0), 40.0) : 0.0;
  vec3 colour = base * light + gloss;
  gl_FragColor = vec4(pow(min(colour, vec3(1.0)), vec3(1.0 / 2.2)), 1.0);
}`;

const textures = new Map<Scale, DataTexture>();
function textureOf(scale: Scale): DataTexture {
  let texture = textures.get(scale);
  if (!texture) {
    texture = new DataTexture(texels(scale), 256, 1);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    textures.set(scale, texture);
  }
  return texture;
}

export interface SurfaceLook {
  front: string;
  back: string;
  facets: boolean;
}

export function surfaceMaterial(look: SurfaceLook): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: kSurfaceVertex,
    fragmentShader: kSurfaceFragment,
    side: DoubleSide,
    // Lines and points lie on the surface, and shall be seen.
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 8,
    uniforms: {
      front: { value: plain(look.front) },
      back: { value: plain(look.back) },
      facets: { value: look.facets },
      mode: { value: 0 },
      worldUp: { value: new Vector3(0, 1, 0) },
      worldSide: { value: new Vector3(1, 0, 0) },
      range: { value: { x: 0, y: 1 } },
      scale: { value: textureOf('sequential') },
    },
  });
}

export function shade(material: ShaderMaterial, mode: number, scale: Scale, range: { x: number; y: number }): void {
  material.uniforms.mode!.value = mode;
  material.uniforms.scale!.value = textureOf(scale);
  material.uniforms.range!.value = range;
}

const kPointVertex = `
attribute float value;
uniform float size;
uniform vec2 depths;
varying float vValue;
varying float vDepth;
void main() {
  vValue = value;
  // A little towards the eye, for the points lie on the surfaces.
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vDepth = clamp((-place.z - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  gl_Position = projectionMatrix * vec4(place.xyz * 0.996, 1.0);
  gl_PointSize = size;
}`;

const kPointFragment = `
uniform vec3 colour;
uniform vec3 rim;
uniform bool scaled;
uniform vec2 range;
uniform sampler2D scale;
uniform float size;
uniform vec3 ground;
uniform float opacity;
uniform float haze;    // how much of the ground's colour the farthest have
varying float vValue;
varying float vDepth;
void main() {
  float r = length(gl_PointCoord - 0.5) * 2.0;
  if (r > 1.0) discard;
  vec3 inside = colour;
  if (scaled) {
    float t = (vValue - range.x) / (range.y - range.x);
    inside = texture2D(scale, vec2(clamp(t, 0.002, 0.998), 0.5)).rgb;
  }
  // Of small discs the rim would leave nothing.
  float edge = smoothstep(1.0 - min(3.0 / size, 0.4), 1.0 - min(1.0 / size, 0.15), r);
  gl_FragColor = vec4(mix(mix(inside, rim, edge), ground, haze * vDepth), opacity);
}`;

export function pointMaterial(colour: string, rim: string, ground: string, haze: number): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: kPointVertex,
    fragmentShader: kPointFragment,
    uniforms: {
      colour: { value: plain(colour) },
      rim: { value: plain(rim) },
      scaled: { value: false },
      range: { value: { x: 0, y: 1 } },
      scale: { value: textureOf('sequential') },
      size: { value: 6 },
      ground: { value: plain(ground) },
      haze: { value: haze },
      opacity: { value: 1 },
      depths: { value: { x: 0, y: 1 } },
    },
  });
}

/** The colour's own numbers, unconverted. */
export function plain(colour: string): Color {
  const number = Number.parseInt(colour.slice(1), 16);
  const c = new Color();
  c.r = ((number >> 16) & 255) / 255;
  c.g = ((number >> 8) & 255) / 255;
  c.b = (number & 255) / 255;
  return c;
}
