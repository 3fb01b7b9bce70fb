// One thing to look at - a surface, a mesh with its edges, a cage, points - as objects of the scene.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Mesh, type Points, type ShaderMaterial } from 'three';
import type { Shape } from '../core/protocol';
import { connectivityOf, trianglesOf, type Connectivity } from './connectivity';
import { fitLines, wideLines, type LineLook, type PaneFrame } from './lines';
import { isSigned, plain, shade, surfaceMaterial, type Shading } from './materials';
import type { Palette } from './palette';
import { makePoints, scalePoints } from './points';

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

/** The largest value of each coloured shading; the smallest is zero, or as far below it. */
export type Scales = Record<Exclude<Shading, 'matte' | 'reflection'>, number>;

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
  private readonly wide: ReturnType<typeof wideLines>[] = [];
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
      this.group.add(this.makeLines(parts.edges, cage
        ? { colour: palette.cage, width: 1.5, opacity: 0.95, faintest: 0.3 }
        : { colour: palette.edge, width: 1, opacity: palette.edgeOpacity, faintest: 0.6 }));
    }
    if (kind === 'cage' || kind === 'points') this.dots = this.makeDots();
    this.marks.add(this.makeLines(parts.boundary, { colour: palette.boundary, width: 2.5, opacity: 1, faintest: 0.8 }));
    this.marks.add(this.makeLines(shape.creases, { colour: palette.crease, width: 3, opacity: 1, faintest: 0.8 }));
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

  private makeLines(pairs: Uint32Array, look: LineLook): Group {
    const group = new Group();
    if (pairs.length === 0) return group;
    const ends = segments(this.source.shape.positions, pairs);
    if (pairs.length / 2 <= kMostWideLines) {
      const lines = wideLines(ends, look);
      this.keep(lines.geometry);
      this.keep(lines.material);
      this.wide.push(lines);
      group.add(lines);
    } else {
      const geometry = this.keep(new BufferGeometry());
      geometry.setAttribute('position', new BufferAttribute(ends, 3));
      const lines = new LineSegments(geometry, this.keep(new LineBasicMaterial({
        color: plain(look.colour), transparent: true, opacity: 0.4 * look.opacity })));
      lines.frustumCulled = false;
      group.add(lines);
    }
    return group;
  }

  private makeDots(): Points {
    const cage = this.source.kind === 'cage';
    const { palette } = this;
    // A cloud has no faces that hide what is behind: there, distance makes points fainter.
    const dots = makePoints(this.source.shape.positions, undefined, cage
      ? { colour: palette.cage, rim: palette.cage, ground: palette.background, haze: 0.4, share: 0.6 }
      : { colour: palette.point, rim: palette.point, ground: palette.background, haze: 0.75, share: 1 });
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
    const signed = isSigned(shading);
    shade(material, 2, signed ? 'diverging' : 'sequential', { x: signed ? -scales[shading] : 0, y: scales[shading] });
  }

  /** Facets give way where a surface is seen with them: then a mesh is its edges. */
  arrange(options: { withSurface: boolean; marks: boolean }): void {
    this.marks.visible = options.marks;
    if (!this.isSurface && this.faces) this.faces.visible = !options.withSurface;
  }

  useFrame(up: { x: number; y: number; z: number }, side: { x: number; y: number; z: number }, pane: PaneFrame): void {
    for (const lines of this.wide) fitLines(lines, pane);
    if (this.dots) (this.dots.material as ShaderMaterial).uniforms.depths!.value = pane.depths;
    if (!this.faces) return;
    const { uniforms } = this.faces.material as ShaderMaterial;
    uniforms.worldUp!.value = up;
    uniforms.worldSide!.value = side;
  }

  scalePoints(ratio: number, unit: number): void {
    if (!this.dots) return;
    this.dots.visible = true;
    scalePoints(this.dots, ratio, unit, this.source.kind !== 'points');
  }

  dispose(): void {
    for (const thing of this.garbage) thing.dispose();
  }
}
