// Colour scales: a few stops each, made smooth between them.

export type Scale = 'diverging' | 'sequential';
type Rgb = readonly [number, number, number];

// Blue to red over a light middle, so that the sign can be told without reading the legend; and dark
// violet to light yellow, whose lightness rises all the way, for those who do not see hues.
const kStops: Record<Scale, readonly Rgb[]> = {
  diverging: [
    [0.07, 0.22, 0.52], [0.20, 0.47, 0.76], [0.58, 0.77, 0.89], [0.95, 0.95, 0.93],
    [0.97, 0.74, 0.57], [0.84, 0.34, 0.25], [0.50, 0.07, 0.16],
  ],
  sequential: [
    [0.13, 0.09, 0.30], [0.28, 0.20, 0.54], [0.16, 0.45, 0.62], [0.15, 0.64, 0.56],
    [0.52, 0.80, 0.35], [0.97, 0.91, 0.30],
  ],
};

/** The colour at t in [0, 1], as sRGB numbers from 0 to 1. */
export function colourAt(scale: Scale, t: number): Rgb {
  const stops = kStops[scale];
  const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(at), stops.length - 2);
  const [a, b, f] = [stops[i]!, stops[i + 1]!, at - i];
  return [a[0] + (b[0] - a[0]) * f, a[1] + (b[1] - a[1]) * f, a[2] + (b[2] - a[2]) * f];
}

/** 256 RGBA texels. */
export function texels(scale: Scale): Uint8Array<ArrayBuffer> {
  const data = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; ++i) {
    const [r, g, b] = colourAt(scale, i / 255);
    data.set([Math.round(r * 255), Math.round(g * 255), Math.round(b * 255), 255], 4 * i);
  }
  return data;
}

export function cssGradient(scale: Scale): string {
  const stops = kStops[scale].map(
    ([r, g, b]) => `rgb(${Math.round(r * 255)} ${Math.round(g * 255)} ${Math.round(b * 255)})`);
  return `linear-gradient(to right, ${stops.join(', ')})`;
}

/** Curvatures below, of a mesh whose box side is one, are a flat surface's rounding errors. */
export const kFlat = 1e-6;

/** The value below which `share` of the magnitudes lie; at least a tiny positive number. */
export function magnitude(values: readonly Float32Array[], share: number, least = 1e-12): number {
  const sample: number[] = [];
  const total = values.reduce((sum, v) => sum + v.length, 0);
  const step = Math.max(1, Math.floor(total / 20000));
  for (const list of values) {
    for (let i = 0; i < list.length; i += step) sample.push(Math.abs(list[i]!));
  }
  sample.sort((a, b) => a - b);
  return Math.max(sample[Math.floor(share * (sample.length - 1))] ?? 0, least);
}

/** A number for people: 3 digits, and powers of ten where they are shorter; with a true minus sign. */
export function shortNumber(x: number): string {
  const size = Math.abs(x);
  const usual = x === 0 || (size >= 0.001 && size < 100000);
  const text = usual ? String(Number(x.toPrecision(3))) : x.toExponential(1).replace('e+', 'e').replace('.0e', 'e');
  return text.replaceAll('-', '\u2212');
}
