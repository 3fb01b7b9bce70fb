// How far the eye has to be.
import type { Up } from './views';

export interface FirstView {
  /** From the origin to the eye. */
  distance: number;
  /** The width that is needed, of the height. */
  reach: number;
  /** Of a ball around the origin that holds all points. */
  radius: number;
}

const kTurns = 12;
/** So many points tell enough of more. */
const kPoints = 20000;

/**
 * As near as the eye can be while nothing is cut off, wherever around the upright axis it is. `eye` is its direction:
 * right, high, ahead, of length one; `tangent` is half the height of what is seen, at a distance of one.
 */
export function firstView(positions: Float32Array, up: Up, eye: readonly [number, number, number], tangent: number): FirstView {
  const [sine, cosine] = [eye[1], Math.hypot(eye[0], eye[2])];
  const stride = 3 * Math.max(1, Math.ceil(positions.length / 3 / kPoints));
  const visit = (take: (across: number, high: number, ahead: number) => void) => {
    for (let i = 0; i + 2 < positions.length; i += stride) {
      const [x, a, b] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
      const [y, z] = up === 'y' ? [a, b] : [b, -a];
      for (let turn = 0; turn < kTurns; ++turn) {
        const [s, c] = [Math.sin((2 * Math.PI * turn) / kTurns), Math.cos((2 * Math.PI * turn) / kTurns)];
        const level = x * s + z * c;
        take(Math.abs(x * c - z * s), Math.abs(y * cosine - level * sine), y * sine + level * cosine);
      }
    }
  };
  let [square, distance, reach] = [0.01, 0, 0.05];
  visit((across, high, ahead) => {
    square = Math.max(square, across * across + high * high + ahead * ahead);
    distance = Math.max(distance, ahead + high / tangent);
  });
  const radius = Math.sqrt(square);
  distance = Math.max(distance, 1.5 * radius);
  visit((across, _high, ahead) => { reach = Math.max(reach, across / (distance - ahead) / tangent); });
  return { distance, reach, radius };
}

/** Positions of several things in one list. */
export function joined(lists: readonly Float32Array[]): Float32Array {
  const all = new Float32Array(lists.reduce((sum, list) => sum + list.length, 0));
  let at = 0;
  for (const list of lists) {
    all.set(list, at);
    at += list.length;
  }
  return all;
}
