// What the page and the worker that holds the core say to each other.

/** A mesh as it is shown: in a frame whose centre is the origin and whose box side is 1. */
export interface Shape {
  /** 3 a vertex. */
  positions: Float32Array;
  /** 3 a vertex, of unit length; absent where facets are shown. */
  normals?: Float32Array;
  /** Corners of face f are corners[offsets[f]] up to corners[offsets[f + 1] - 1]. */
  offsets: Uint32Array;
  corners: Uint32Array;
  /** 2 a sharp edge. */
  creases: Uint32Array;
  /** Numbers per vertex: "mean", "gauss" (curvature, of the box side), "error" (of the box side). */
  channels: Record<string, Float32Array>;
}

export interface Failure {
  code: string;
  message: string;
  vertex?: number;
  face?: number;
}

/** Mending is never done unasked. */
export interface Mend {
  repair?: boolean;
  triangulate?: boolean;
}

export interface Loaded {
  kind: 'mesh' | 'points';
  format: string;
  notices: string[];
  vertices: number;
  faces: number;
  triangles: boolean;
  /** The scheme that the file records, or the one that suits its faces. */
  scheme: string;
  boxSide: number;
  given: Shape;
  /** Absent for points. */
  shapes?: Shapes;
}

/** Shape parameters of nonstationary-loop: the range that the mesh allows, and those with names. */
export interface Shapes {
  lowest: number;
  highest: number;
  round: number;
  standard: number;
  flat: number;
}

export interface SolveOptions {
  scheme: string;
  boundary: string;
  method: string;
  solver: string;
  tolerance: number;
  maxIterations: number;
  /** 0 to 1: the membrane's share of the energy, under the method fair. */
  tension: number;
  /** The shape parameter of nonstationary-loop. */
  shape: number;
  levels: number;
}

/** Errors are relative to the box side; for similarity and fair, residuals of the solver. */
export interface Iteration {
  iteration: number;
  max: number;
  mean: number;
}

export interface Certificate {
  max: number;
  mean: number;
  boxSide: number;
  worstVertex: number;
  evaluator: string;
}

export interface SolveReport {
  converged: boolean;
  solver: string;
  tolerance: number;
  iterations: number;
  boundaryIterations: number;
  history: Iteration[];
  boundaryHistory: Iteration[];
  notes: string[];
}

/** What the core answers: of the plain surface nothing, if it is as the last time. */
export type Answer = Omit<Solved, 'plain' | 'pointErrors'> & Partial<Pick<Solved, 'plain' | 'pointErrors'>>;

export interface Solved {
  /** Absent where the scheme needs none. */
  control?: Shape;
  plain: Shape;
  surface: Shape;
  /** Distance from each given point to its limit on the plain surface. */
  pointErrors: Float32Array;
  certificate: Certificate;
  report: SolveReport;
  seconds: { solve: number; verify: number; surfaces: number };
}

export interface Curve {
  history: Iteration[];
  boundaryHistory: Iteration[];
}
/** By the solver's name; a solver that does not take the mesh is absent. */
export type Rivals = Record<string, Curve>;

export type Exportable = 'control' | 'surface' | 'given';
export interface Written {
  bytes: Uint8Array<ArrayBuffer>;
  notices: string[];
}

export interface Progress {
  stage: string;
  fraction: number;
  iteration: number;
  error: number;
}

/** The methods of the worker, as they are called through it. */
export interface CoreMethods {
  load(file: Uint8Array<ArrayBuffer>, name: string, mend: Mend): Loaded;
  solve(options: SolveOptions): Answer;
  rivals(options: SolveOptions): Rivals;
  written(what: Exportable, format: string): Written;
}
export type Method = keyof CoreMethods;

export interface Request {
  id: number;
  method: Method;
  arguments: unknown[];
}
export type Reply =
  | { id: number; progress: Progress }
  | { id: number; result: unknown }
  | { id: number; failure: Failure };

/** The first message to a worker. */
export interface Start {
  wasm: ArrayBuffer;
}
