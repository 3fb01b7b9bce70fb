// Points as discs of a few pixels, that give way where there is no room between them.
import { BufferAttribute, BufferGeometry, Points, type ShaderMaterial } from 'three';
import { pointMaterial } from './materials';

export interface PointLook {
  colour: string;
  rim: string;
  ground: string;
  /** How much of the ground's colour the farthest points have. */
  haze: number;
  /** Of the usual size. */
  share: number;
}

/** `values` may colour them. */
export function makePoints(positions: Float32Array, values: Float32Array | undefined, look: PointLook): Points {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  if (values) geometry.setAttribute('value', new BufferAttribute(values, 1));
  const points = new Points(geometry, pointMaterial(look.colour, look.rim, look.ground, look.haze));
  const count = positions.length / 3;
  points.userData.size = look.share * (count <= 300 ? 9 : count <= 3000 ? 6.5 : count <= 30000 ? 4 : 2.5);
  points.userData.spacing = spacingOf(positions);
  points.frustumCulled = false;
  return points;
}

/** As far as so many points would be apart on a ball of that extent around the origin. */
export function spacingOf(positions: Float32Array): number {
  const count = Math.max(positions.length / 3, 1);
  const squares = positions.reduce((sum, x) => sum + x * x, 0);
  return Math.sqrt((squares / count) * ((4 * Math.PI) / count));
}

export interface Dot {
  /** Across, in pixels. */
  size: number;
  opacity: number;
}

/** Discs are less than half as wide as the space for them, and fade away before they would be a haze over the surface. */
export function dotFor(usual: number, spacing: number, ratio: number, fades: boolean): Dot {
  const size = Math.max(Math.min(usual, 0.45 * spacing), 1.5);
  return { size, opacity: fades ? Math.min(Math.max((spacing / ratio - 3) / 3, 0), 1) : 1 };
}

/** `ratio`: pixels of a disc's unit; `unit`: pixels of a length of one in the middle of the picture. */
export function scalePoints(points: Points, ratio: number, unit: number, fades: boolean): void {
  const { size, spacing } = points.userData as { size: number; spacing: number };
  const dot = dotFor(size * ratio, spacing * unit, ratio, fades);
  const material = points.material as ShaderMaterial;
  material.uniforms.size!.value = dot.size;
  material.uniforms.opacity!.value = dot.opacity;
  material.transparent = dot.opacity < 1;
  if (dot.opacity === 0) points.visible = false;
}
