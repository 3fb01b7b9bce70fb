// MINRES: Paige, Saunders, Solution of sparse indefinite systems of linear equations, 1975; here in
// the inner product <a, b> = sum d_i a_i b_i, in which L is self-adjoint. Each right-hand side by
// itself. Where L is singular and the data compatible, the iterates keep off the null vectors.
#include <algorithm>
#include <cmath>

#include "interpolate/solvers.hpp"

namespace surpass {
namespace {

double quotient(double a, double b) { return b != 0 ? a / b : 0; }

// The state of one right-hand side: the last entries of the tridiagonal matrix and the rotations
// that make it triangular.
struct Rotations {
  double beta = 0;
  double eta = 0;
  double c_old = 1, c = 1;
  double s_old = 0, s = 0;
  double rho[3] = {};

  void advance(double alpha, double beta_next) {
    const double diagonal = c * alpha - c_old * s * beta;
    rho[0] = std::hypot(diagonal, beta_next);
    rho[1] = s * alpha + c_old * c * beta;
    rho[2] = s_old * beta;
    c_old = c;
    s_old = s;
    c = quotient(diagonal, rho[0]);
    s = quotient(beta_next, rho[0]);
    beta = beta_next;
  }
};

}  // namespace

Verdict minimal_residual(const LinearSystem& system, Monitor& monitor, std::span<double> x) {
  const std::vector<double>* d = &system.op.symmetric_weight;
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
  const std::size_t n = system.values();
  std::vector<double> r(n, 0.0);
  std::vector<double> product(n, 0.0);
  // As with conjugate gradients, the residual of the recurrence drifts, so that the iteration
  // starts anew from the true one when it claims success.
  for (;;) {
    Verdict verdict = monitor.record(system.residual(x, r));
    if (verdict != Verdict::go_on) return verdict;
    std::vector<Rotations> state(system.width);
    const std::vector<double> rr = system.dot(r, r, d);
    // The dot products are scaled by scale^2, and so is every length here.
    for (std::size_t c = 0; c < system.width; ++c) state[c].eta = std::sqrt(rr[c]);
    const double given_up = *std::max_element(rr.begin(), rr.end()) * 1e-16;
    std::vector<double> v(n, 0.0);
    std::vector<double> v_old(n, 0.0);
    std::vector<double> w(n, 0.0);
    std::vector<double> w_old(n, 0.0);
    system.for_values(
        [&](std::size_t at, std::size_t c) { v[at] = quotient(r[at], state[c].eta); });
    for (;;) {
      system.product(v, product);
      std::vector<double> alpha = system.dot(v, product, d);
      system.for_values([&](std::size_t at, std::size_t c) {
        product[at] -= alpha[c] * v[at] + state[c].beta * v_old[at];
      });
      const std::vector<double> squared = system.dot(product, product, d);
      for (std::size_t c = 0; c < system.width; ++c) {
        state[c].advance(alpha[c], std::sqrt(squared[c]));
      }
      system.for_values([&](std::size_t at, std::size_t c) {
        const Rotations& q = state[c];
        const double next = quotient(v[at] - q.rho[2] * w_old[at] - q.rho[1] * w[at], q.rho[0]);
        w_old[at] = w[at];
        w[at] = next;
        x[at] += q.c * q.eta * next;
        v_old[at] = v[at];
        v[at] = quotient(product[at], q.beta);
        r[at] = q.s * q.s * r[at] - q.c * q.s * q.eta * v[at];
      });
      double largest = 0;
      for (Rotations& q : state) {
        q.eta *= -q.s;
        largest = std::max(largest, q.eta * q.eta);
      }
      if (largest <= given_up) break;
      verdict = monitor.record(system.block_norms(r));
      if (verdict == Verdict::reached) break;
      if (verdict != Verdict::go_on) return verdict;
    }
  }
}

}  // namespace surpass
