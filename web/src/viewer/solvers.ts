// Solvers as they are called and coloured, wherever they are.

interface Look {
  name: string;
  /** Numbers of --curve-N in viewer.css: of the curve, and of the one on creases and boundary. */
  colour: { full: number; dashed: number };
}

const kOthers = { full: 4, dashed: 5 };
const kLooks: Record<string, Look> = {
  'richardson': { name: 'Richardson', colour: { full: 0, dashed: 2 } },
  'chebyshev': { name: 'Chebyshev', colour: { full: 1, dashed: 3 } },
  'conjugate-gradient': { name: 'Conjugate gradients', colour: kOthers },
  'gauss-seidel': { name: 'Gauss-Seidel', colour: kOthers },
  'minres': { name: 'MINRES', colour: kOthers },
  'bicgstab': { name: 'BiCGSTAB', colour: kOthers },
};

/** By the name that reports have. Where there was nothing to solve, they have none. */
export function solverLook(solver: string): Look {
  return kLooks[solver] ?? { name: solver || 'none needed', colour: kOthers };
}
