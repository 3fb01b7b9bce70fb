// One thing to look at - a surface, a mesh with its edges, a cage, points - as objects of the scene.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Mesh, Points, type ShaderMaterial } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Shape } from '../core/protocol';
import { connectivityOf, trianglesOf, type Connectivity } from './connectivity';
import { plain, pointMaterial, shade, surfaceMaterial, type Shading } from './materials';
import type { Palette } from './palette';

/** surface: smooth and shaded; mesh: facets with edges; cage: edges and vertices; points: these. */
export type Kind = 'surface' | 'mesh' | 'cage' | 'points';

export interface LayerSource {
  id: string;
  label: string;
  kind: Kind;
  shape: Shape;
  /** Edges known to be drawn are marked as creases or boundary. */
  connectivity?: Connectivity;
  /** The value that error shading takes where there is no channel of that name. */
  flatError?: number;
}

/** Lines up to so many are drawn wide; more are drawn as the card's own thin lines. */
const kMostWideLines = 60000;

export interface Scales {
  mean: number;
  gauss: number;
  error: number;
}

function segments(positions: Float32Array, pairs: Uint32Array): Float32Array {
  const ends = new Float32Array(3 * pairs.length);
  for (let i = 0; i < pairs.length; ++i) {
    const v = 3 * pairs[i]!;
    ends[3 * i] = positions[v]!;
    ends[3 * i + 1] = positions[v + 1]!;
    ends[3 * i + 2] = positions[v + 2]!;
  }
  return ends;
}

export class Layer {
  readonly group = new Group();
  private readonly faces: Mesh | undefined;
  private readonly edges: Group | undefined;
  private readonly marks = new Group();
  private readonly dots: Points | undefined;
  /** The shading whose numbers are with the card. */
  private loaded: Shading | undefined;
  private readonly garbage: { dispose(): void }[] = [];

  constructor(readonly source: LayerSource, private readonly palette: Palette) {
    const { kind, shape } = source;
    // The fine triangles of a surface are not shown as lines, so only its boundary is looked for.
    const parts = source.connectivity ?? connectivityOf(shape);
    if (kind !== 'points' && shape.corners.length > 0) this.faces = this.makeFaces();
    if (kind === 'mesh' || kind === 'cage') {
      const cage = kind === 'cage';
      this.edges = this.makeLines(parts.edges, cage ? palette.cage : palette.edge, cage ? 1.6 : 1,
        cage ? 0.95 : palette.edgeOpacity);
      this.group.add(this.edges);
    }
    if (kind === 'cage' || kind === 'points') this.dots = this.makeDots();
    this.marks.add(this.makeLines(parts.boundary, palette.boundary, 2.5, 1));
    this.marks.add(this.makeLines(shape.creases, palette.crease, 3, 1));
    this.group.add(this.marks);
  }

  get isSurface(): boolean {
    return this.source.kind === 'surface';
  }

  /** Whether there is anything to mark. */
  static hasMarks(source: LayerSource): boolean {
    return source.shape.creases.length > 0 || (source.connectivity?.boundary.length ?? 0) > 0;
  }

  private keep<T extends { dispose(): void }>(thing: T): T {
    this.garbage.push(thing);
    return thing;
  }

  private makeFaces(): Mesh {
    const { shape, kind } = this.source;
    const geometry = this.keep(new BufferGeometry());
    geometry.setAttribute('position', new BufferAttribute(shape.positions, 3));
    if (shape.normals) geometry.setAttribute('normal', new BufferAttribute(shape.normals, 3));
    geometry.setIndex(new BufferAttribute(this.source.connectivity?.triangles ?? trianglesOf(shape), 1));
    // A cage's faces only hide what is behind them.
    const [front, back] = {
      surface: [this.palette.front, this.palette.back], mesh: [this.palette.given, this.palette.givenBack],
      cage: [this.palette.cageFace, this.palette.cageFace], points: [this.palette.given, this.palette.given],
    }[kind] as [string, string];
    const material = this.keep(surfaceMaterial({
      front, back,
      facets: !shape.normals,
    }));
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.group.add(mesh);
    return mesh;
  }

  private makeLines(pairs: Uint32Array, colour: string, width: number, opacity: number): Group {
    const group = new Group();
    if (pairs.length === 0) return group;
    const ends = segments(this.source.shape.positions, pairs);
    const common = { color: plain(colour), transparent: opacity < 1, opacity };
    if (pairs.length / 2 <= kMostWideLines) {
      const geometry = this.keep(new LineSegmentsGeometry());
      geometry.setPositions(ends);
      const lines = new LineSegments2(geometry, this.keep(new LineMaterial({ ...common, linewidth: width })));
      lines.frustumCulled = false;
      group.add(lines);
    } else {
      const geometry = this.keep(new BufferGeometry());
      geometry.setAttribute('position', new BufferAttribute(ends, 3));
      const lines = new LineSegments(geometry, this.keep(new LineBasicMaterial({
        ...common, transparent: true, opacity: 0.4 * opacity })));
      lines.frustumCulled = false;
      group.add(lines);
    }
    return group;
  }

  private makeDots(): Points {
    const cage = this.source.kind === 'cage';
    const dots = makePoints(this.source.shape.positions, undefined,
      cage ? this.palette.cage : this.palette.point, cage ? this.palette.cage : this.palette.pointRim, cage ? 0.6 : 1);
    this.keep(dots.geometry);
    this.keep(dots.material as ShaderMaterial);
    this.group.add(dots);
    return dots;
  }

  /** The numbers that a shading shows, or nothing. */
  private values(shading: Shading): Float32Array | undefined {
    return this.source.shape.channels[shading];
  }

  shade(shading: Shading, scales: Scales): void {
    if (!this.faces || !this.isSurface) return;
    const material = this.faces.material as ShaderMaterial;
    if (shading === 'matte' || shading === 'reflection') {
      shade(material, shading === 'matte' ? 0 : 1, 'sequential', { x: 0, y: 1 });
      return;
    }
    const values = this.values(shading);
    const size = this.source.shape.positions.length / 3;
    const flat = shading === 'error' ? this.source.flatError : undefined;
    if (!values && flat === undefined) {
      shade(material, 0, 'sequential', { x: 0, y: 1 });
      return;
    }
    if (this.loaded !== shading) {
      this.faces.geometry.setAttribute('value',
        new BufferAttribute(values ?? new Float32Array(size).fill(flat!), 1));
      this.loaded = shading;
    }
    if (shading === 'error') shade(material, 2, 'sequential', { x: 0, y: scales.error });
    else shade(material, 2, 'diverging', { x: -scales[shading], y: scales[shading] });
  }

  /** Facets give way where a surface is seen with them: then a mesh is its edges. */
  arrange(options: { withSurface: boolean; marks: boolean }): void {
    this.marks.visible = options.marks;
    if (!this.isSurface && this.faces) this.faces.visible = !options.withSurface;
  }

  useFrame(up: { x: number; y: number; z: number }, side: { x: number; y: number; z: number }): void {
    if (!this.faces) return;
    const { uniforms } = this.faces.material as ShaderMaterial;
    uniforms.worldUp!.value = up;
    uniforms.worldSide!.value = side;
  }

  scalePoints(ratio: number): void {
    if (this.dots) scalePoints(this.dots, ratio);
  }

  dispose(): void {
    for (const thing of this.garbage) thing.dispose();
  }
}

/** Points as discs of a few pixels, smaller where there are many; `values` may colour them. */
export function makePoints(positions: Float32Array, values: Float32Array | undefined, colour: string,
                           rim: string, share = 1): Points {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  if (values) geometry.setAttribute('value', new BufferAttribute(values, 1));
  const points = new Points(geometry, pointMaterial(colour, rim));
  const count = positions.length / 3;
  points.userData.size = share * (count <= 300 ? 9 : count <= 3000 ? 6.5 : count <= 30000 ? 4 : 2.5);
  points.frustumCulled = false;
  return points;
}

export function scalePoints(points: Points, ratio: number): void {
  const material = points.material as ShaderMaterial;
  material.uniforms.size!.value = (points.userData.size as number) * ratio;
}
