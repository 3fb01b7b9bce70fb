// Lines of any width, as ribbons that face the eye: four vertices a line, told apart by their number.
// Instanced quads would hold a quarter of the numbers, but are drawn one by one where a processor draws.
import { BufferAttribute, BufferGeometry, Mesh, ShaderMaterial, type Vector2 } from 'three';
import { plain } from './materials';

const kVertex = `
attribute vec3 end;
uniform vec2 size;     // of the pane, in the page's pixels
uniform float width;
uniform float nearest;
uniform vec2 depths;   // where lines are full, and where they are faintest
varying float vAcross;
varying float vDepth;
void main() {
  vec4 a = modelViewMatrix * vec4(position, 1.0);
  vec4 b = modelViewMatrix * vec4(end, 1.0);
  // What is behind the eye has no place in the picture.
  if (a.z > -nearest && b.z < -nearest) a = mix(a, b, (-nearest - a.z) / (b.z - a.z));
  if (b.z > -nearest && a.z < -nearest) b = mix(b, a, (-nearest - b.z) / (a.z - b.z));
  bool ends = (gl_VertexID & 2) != 0;
  float side = (gl_VertexID & 1) != 0 ? 1.0 : -1.0;
  vDepth = clamp((-(ends ? b.z : a.z) - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  vec4 from = projectionMatrix * a;
  vec4 to = projectionMatrix * b;
  vec2 along = (to.xy / to.w - from.xy / from.w) * size;
  along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  // A pixel more on both sides, to fade out in; and a little longer, so that corners are closed.
  float half_width = 0.5 * width + 0.5;
  vec2 away = side * half_width * vec2(-along.y, along.x) + (ends ? 0.35 : -0.35) * width * along;
  gl_Position = ends ? to : from;
  gl_Position.xy += away * 2.0 / size * gl_Position.w;
  vAcross = side * half_width;
}`;

const kFragment = `
uniform vec3 colour;
uniform float opacity;
uniform float width;
uniform float ratio;   // of the screen's pixels to the page's
uniform float faintest;
varying float vAcross;
varying float vDepth;
void main() {
  float cover = clamp((0.5 * width - abs(vAcross)) * ratio + 0.5, 0.0, 1.0);
  float alpha = cover * opacity * mix(1.0, faintest, vDepth);
  if (alpha < 0.01) discard;
  gl_FragColor = vec4(colour, alpha);
}`;

export interface LineLook {
  colour: string;
  /** In pixels of the page. */
  width: number;
  opacity: number;
  /** The part of the opacity that is left at the far side. */
  faintest: number;
}

/** What lines have to know of the pane that they are drawn in. */
export interface PaneFrame {
  size: Vector2;
  ratio: number;
  near: number;
  /** Depths of the front and of the back of what is shown. */
  depths: Vector2;
}

/** `ends` has 6 numbers a line. */
export function wideLines(ends: Float32Array, look: LineLook): Mesh<BufferGeometry, ShaderMaterial> {
  const count = ends.length / 6;
  const starts = new Float32Array(12 * count);
  const stops = new Float32Array(12 * count);
  const index = new Uint32Array(6 * count);
  for (let line = 0; line < count; ++line) {
    const start = ends.subarray(6 * line, 6 * line + 3);
    const stop = ends.subarray(6 * line + 3, 6 * line + 6);
    for (let corner = 0; corner < 4; ++corner) {
      starts.set(start, 12 * line + 3 * corner);
      stops.set(stop, 12 * line + 3 * corner);
    }
    index.set([0, 1, 2, 2, 1, 3].map((corner) => 4 * line + corner), 6 * line);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(starts, 3));
  geometry.setAttribute('end', new BufferAttribute(stops, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  const lines = new Mesh(geometry, new ShaderMaterial({
    vertexShader: kVertex,
    fragmentShader: kFragment,
    transparent: true,
    depthWrite: false,
    side: 2,
    uniforms: {
      colour: { value: plain(look.colour) }, opacity: { value: look.opacity }, width: { value: look.width },
      faintest: { value: look.faintest }, size: { value: null }, ratio: { value: 1 }, nearest: { value: 0.05 },
      depths: { value: null },
    },
  }));
  lines.frustumCulled = false;
  return lines;
}

export function fitLines(lines: Mesh<BufferGeometry, ShaderMaterial>, frame: PaneFrame): void {
  const { uniforms } = lines.material;
  uniforms.size!.value = frame.size;
  uniforms.ratio!.value = frame.ratio;
  uniforms.nearest!.value = frame.near;
  uniforms.depths!.value = frame.depths;
}
