// From what the core answered to what the viewer shows.
import type { Loaded, Shape, Solved } from '../core/protocol';
import { connectivityOf, type Connectivity } from '../viewer/connectivity';
import type { LayerSource } from '../viewer/layer';
import type { Content } from '../viewer/viewer';

export class Scenery {
  private readonly known = new Map<string, { corners: Uint32Array; connectivity: Connectivity }>();

  clear(): void {
    this.known.clear();
  }

  /** Whether the given mesh has a boundary. */
  isOpen(loaded: Loaded): boolean {
    return this.connectivity('given', loaded.given).boundary.length > 0;
  }

  content(loaded: Loaded | undefined, solved: Solved | undefined): Content {
    if (!loaded) return { layers: [] };
    if (loaded.kind === 'points') {
      return { layers: [this.layer('points', 'Points', 'points', loaded.given)] };
    }
    const layers = [this.layer('given', 'Given mesh', 'mesh', loaded.given)];
    if (!solved) return { layers, points: loaded.given.positions };
    if (solved.control) layers.push(this.layer('control', 'Control mesh', 'cage', solved.control));
    layers.push(
      this.layer('plain', 'Plain limit surface', 'surface', solved.plain),
      { ...this.layer('surface', 'Interpolating surface', 'surface', solved.surface), flatError: solved.certificate.max });
    return { layers, points: loaded.given.positions, pointErrors: solved.pointErrors };
  }

  private layer(id: string, label: string, kind: LayerSource['kind'], shape: Shape): LayerSource {
    return { id, label, kind, shape, connectivity: this.connectivity(id, shape) };
  }

  // Positions change with every slider, faces hardly ever.
  private connectivity(id: string, shape: Shape): Connectivity {
    const before = this.known.get(id);
    if (before && before.corners.length === shape.corners.length && before.corners.every((c, i) => c === shape.corners[i])) {
      return before.connectivity;
    }
    const connectivity = connectivityOf(shape);
    this.known.set(id, { corners: shape.corners, connectivity });
    return connectivity;
  }
}
