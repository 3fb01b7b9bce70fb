// The picture: one or two panes that look at the layers through one camera.
import { Matrix3, PerspectiveCamera, type Points, Scene, type ShaderMaterial, Vector2, Vector3, WebGLRenderer, LinearSRGBColorSpace, ColorManagement } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { kFlat, magnitude } from './colour';
import { firstView, joined } from './fit';
import { Layer, type LayerSource, type Scales } from './layer';
import { kDark, kLight, type Palette } from './palette';
import { makePoints, scalePoints } from './points';
import { drawsInSoftware } from './software';
import { panesOf, type Pane, type View } from './views';

ColorManagement.enabled = false;

/** Where the eye is in the first view: right, high and ahead of the middle. */
const kHome = [0.46, 0.34, 0.82] as const;
/** Room around what is shown. */
const kMargin = 1.1;

export interface Content {
  layers: LayerSource[];
  /** The given points, 3 numbers each, with their distances to the plain surface. */
  points?: Float32Array;
  pointErrors?: Float32Array;
}

export class Viewer {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.05, 40);
  private readonly orbit: OrbitControls;
  private layers = new Map<string, Layer>();
  private points: Points | undefined;
  private content: Content = { layers: [] };
  private radius = 0.8;
  private fitted: Float32Array = new Float32Array();
  /** Nobody has turned the picture; and the control meshes that it was fitted to. */
  private atHome = true;
  private fittedCages = '';
  /** From the origin to the eye in the first view; and the width that it needs, of the height. */
  private distance = 3.3;
  private reach = 1;
  private palette: Palette = kLight;
  private asked = false;
  /** Pixels at the edges that other things lie over. */
  insets = { top: 0, bottom: 0 };
  scales: Scales = { mean: 1, gauss: 1, error: 1, distance: 1 };

  constructor(private readonly host: HTMLElement, private view: View) {
    this.renderer = new WebGLRenderer({ antialias: !drawsInSoftware(), powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.autoClear = false;
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    host.append(this.canvas);
    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.enableDamping = false;
    this.orbit.minDistance = 0.2;
    this.orbit.maxDistance = 20;
    this.orbit.addEventListener('change', () => this.ask());
    this.orbit.addEventListener('start', () => { this.atHome = false; });
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(host);
    this.home();
    this.draw();
  }

  /** New things to look at. The camera stays, unless it is still in the first view and they need more room. */
  show(content: Content): void {
    this.content = content;
    this.rebuild();
  }

  get shown(): readonly LayerSource[] {
    return this.content.layers;
  }

  setView(view: View): void {
    const turned = view.up !== this.view.up;
    this.view = view;
    if (turned || (this.atHome && this.cages() !== this.fittedCages)) this.home();
    this.ask();
  }

  setDark(dark: boolean): void {
    this.palette = dark ? kDark : kLight;
    this.rebuild();
  }

  /** From the front, a little to the right and above. */
  home(): void {
    this.fittedCages = this.cages();
    this.measure();
    const [right, high, ahead] = kHome.map((x) => x * this.distance);
    this.camera.up.set(0, this.view.up === 'y' ? 1 : 0, this.view.up === 'z' ? 1 : 0);
    if (this.view.up === 'y') this.camera.position.set(right!, high!, ahead!);
    else this.camera.position.set(right!, -ahead!, high!);
    // The controls take the up axis once, when they are made; told of a new one, they start afresh.
    const orbit = this.orbit as unknown as { _quat: { setFromUnitVectors(a: Vector3, b: Vector3): { clone(): { invert(): unknown } } }; _quatInverse: unknown };
    orbit._quatInverse = orbit._quat.setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0)).clone().invert();
    this.orbit.target.set(0, 0, 0);
    this.orbit.update();
    this.atHome = true;
    this.ask();
  }

  // Control meshes reach far beyond the points that are always fitted; surfaces do not.
  private get shownCages(): LayerSource[] {
    const ids = panesOf(this.view).flatMap((pane) => pane.ids);
    return this.content.layers.filter((l) => l.kind === 'cage' && ids.includes(l.id));
  }
  private cages(): string {
    return this.shownCages.map((l) => l.id).join(' ');
  }

  /** The things around the origin that shall fit into the picture. */
  fit(positions: Float32Array): void {
    this.fitted = positions;
    this.home();
  }

  private measure(): void {
    const positions = [this.fitted, ...this.shownCages.map((l) => l.shape.positions)];
    const { distance, reach, radius } = firstView(joined(positions), this.view.up, kHome, this.tangent / kMargin);
    Object.assign(this, { distance, reach, radius });
  }

  /** Half the height of what is seen, at a distance of one. */
  private get tangent(): number {
    return Math.tan(((this.camera.fov / 2) * Math.PI) / 180);
  }

  /** The picture as a PNG file. */
  async png(): Promise<Blob> {
    // Twice as fine as on the screen: it may be printed.
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(2 * ratio);
    this.draw();
    const blob = new Promise<Blob>((resolve, reject) => {
      this.canvas.toBlob((made) => (made ? resolve(made) : reject(new Error('no picture'))), 'image/png');
    });
    this.renderer.setPixelRatio(ratio);
    this.draw();
    return blob;
  }

  /** Milliseconds a frame takes, with the card's work, while the camera turns. */
  timeFrames(count: number): number {
    const gl = this.renderer.getContext();
    const pixel = new Uint8Array(4);
    const start = performance.now();
    for (let i = 0; i < count; ++i) {
      this.camera.position.applyAxisAngle(this.camera.up, 0.05);
      this.camera.lookAt(this.orbit.target);
      this.draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);  // waits for the frame
    }
    return (performance.now() - start) / count;
  }

  private rebuild(): void {
    for (const layer of this.layers.values()) {
      this.scene.remove(layer.group);
      layer.dispose();
    }
    this.layers = new Map();
    for (const source of this.content.layers) {
      const layer = new Layer(source, this.palette);
      this.layers.set(source.id, layer);
      this.scene.add(layer.group);
    }
    if (this.points) {
      this.scene.remove(this.points);
      this.points.geometry.dispose();
      (this.points.material as ShaderMaterial).dispose();
      this.points = undefined;
    }
    if (this.content.points) {
      const { point, pointRim, background } = this.palette;
      this.points = makePoints(this.content.points, this.content.pointErrors,
        { colour: point, rim: pointRim, ground: background, haze: 0, share: 1 });
      this.scene.add(this.points);
    }
    this.findScales();
    this.ask();
  }

  // One scale for all surfaces, so that they can be compared; the sharpest fiftieth is cut off.
  private findScales(): void {
    const surfaces = this.content.layers.filter((l) => l.kind === 'surface');
    const of = (name: string) => surfaces.flatMap((l) => l.shape.channels[name] ?? []);
    this.scales = {
      mean: magnitude(of('mean'), 0.96, kFlat),
      gauss: magnitude(of('gauss'), 0.95, kFlat),
      distance: magnitude(of('distance'), 1),
      error: this.content.pointErrors?.length ? magnitude([this.content.pointErrors], 1) : magnitude(of('error'), 1),
    };
  }

  private ask(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.draw();
    });
  }

  draw(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.fitCanvas(width, height);
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.palette.background);
    this.renderer.setViewport(0, 0, width, height);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    const panes = panesOf(this.view);
    for (const pane of panes) {
      const left = Math.round(pane.from * width);
      const wide = Math.round(pane.to * width) - left;
      if (wide < 2) continue;
      this.renderer.setViewport(left, 0, wide, height);
      this.renderer.setScissor(left, 0, wide, height);
      this.camera.aspect = wide / height;
      // The same size on both sides, wherever the divider is; and clear of the label and the legend.
      const free = Math.max(height - this.insets.top - this.insets.bottom, height / 2);
      this.camera.zoom = Math.min(1, width / panes.length / free / this.reach) * (free / height);
      this.camera.setViewOffset(wide, height, 0, (this.insets.bottom - this.insets.top) / 2, wide, height);
      this.camera.updateProjectionMatrix();
      this.arrange(pane);
      this.renderer.render(this.scene, this.camera);
    }
  }

  private fitCanvas(width: number, height: number): void {
    const size = this.renderer.getSize(new Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height);
  }

  /** Pixels a disc's unit: smaller where the pane is small. */
  private dotScale(pane: Pane): number {
    const { clientWidth, clientHeight } = this.host;
    const least = Math.min((pane.to - pane.from) * clientWidth, clientHeight);
    return this.renderer.getPixelRatio() * Math.min(1, Math.max(0.5, least / 560));
  }

  private arrange(pane: Pane): void {
    this.camera.updateMatrixWorld();
    const turn = new Matrix3().setFromMatrix4(this.camera.matrixWorldInverse);
    const up = this.camera.up.clone().applyMatrix3(turn);
    const side = new Vector3(1, 0, 0).applyMatrix3(turn);
    const { clientWidth, clientHeight } = this.host;
    const away = this.camera.position.distanceTo(this.orbit.target);
    const frame = {
      size: new Vector2((pane.to - pane.from) * clientWidth, clientHeight), ratio: this.renderer.getPixelRatio(),
      near: this.camera.near, depths: new Vector2(away - 0.5 * this.radius, away + this.radius),
    };
    const unit = (this.camera.projectionMatrix.elements[5]! * clientHeight * frame.ratio) / 2 / away;
    const shown = pane.ids.flatMap((id) => this.layers.get(id) ?? []);
    const withSurface = shown.some((layer) => layer.isSurface);
    for (const layer of this.layers.values()) {
      layer.group.visible = shown.includes(layer);
      if (!layer.group.visible) continue;
      layer.arrange({ withSurface, marks: this.view.marks });
      layer.shade(this.view.shading, this.scales);
      layer.useFrame(up, side, frame);
      layer.scalePoints(this.dotScale(pane), unit);
    }
    if (this.points) this.arrangePoints(this.points, this.dotScale(pane), unit);
  }

  private arrangePoints(points: Points, scale: number, unit: number): void {
    points.visible = this.view.points;
    const { uniforms } = points.material as ShaderMaterial;
    uniforms.scaled!.value = this.view.shading === 'error' && this.content.pointErrors !== undefined;
    uniforms.range!.value = { x: 0, y: this.scales.error };
    scalePoints(points, scale, unit, true);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = (axis: Vector3, angle: number) => {
      this.camera.position.applyAxisAngle(axis, angle);
      this.orbit.update();
      this.ask();
    };
    const side = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const step = event.shiftKey ? 0.35 : 0.12;
    const keys: Record<string, () => void> = {
      ArrowLeft: () => turn(this.camera.up, -step),
      ArrowRight: () => turn(this.camera.up, step),
      ArrowUp: () => turn(side, -step),
      ArrowDown: () => turn(side, step),
      '+': () => this.dolly(0.88),
      '=': () => this.dolly(0.88),
      '-': () => this.dolly(1 / 0.88),
      Home: () => this.home(),
    };
    const action = keys[event.key];
    if (!action) return;
    event.preventDefault();
    this.atHome = false;
    action();
  }

  private dolly(factor: number): void {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.orbit.update();
    this.ask();
  }
}
