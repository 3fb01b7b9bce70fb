// Conjugate gradients for L, which is self-adjoint in the inner product <a, b> = sum d_i a_i b_i.
#include <algorithm>

#include "interpolate/solvers.hpp"

namespace surpass {

Verdict conjugate_gradient(const LinearSystem& system, Monitor& monitor, std::span<double> x) {
  const std::vector<double>* d = &system.op.symmetric_weight;
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
  std::vector<double> r(system.values(), 0.0);
  std::vector<double> product(system.values(), 0.0);
  // The residual is carried along by a recurrence and drifts from the true one by rounding. Where
  // it claims success the true one is asked, and if it disagrees the iteration starts anew from
  // here.
  for (;;) {
    Verdict verdict = monitor.record(system.residual(x, r));
    if (verdict != Verdict::go_on) return verdict;
    std::vector<double> p(r);
    std::vector<double> rr = system.dot(r, r, d);
    const double given_up = *std::max_element(rr.begin(), rr.end()) * 1e-8;
    for (;;) {
      system.product(p, product);
      const std::vector<double> pp = system.dot(p, product, d);
      system.for_values([&](std::size_t at, std::size_t c) {
        const double step = pp[c] > 0 ? rr[c] / pp[c] : 0;
        x[at] += step * p[at];
        r[at] -= step * product[at];
      });
      const std::vector<double> next = system.dot(r, r, d);
      if (*std::max_element(next.begin(), next.end()) <= given_up) break;
      verdict = monitor.record(system.block_norms(r));
      if (verdict == Verdict::reached) break;
      if (verdict != Verdict::go_on) return verdict;
      system.for_values([&](std::size_t at, std::size_t c) {
        const double share = rr[c] > 0 ? next[c] / rr[c] : 0;
        p[at] = r[at] + share * p[at];
      });
      rr = next;
    }
  }
}

}  // namespace surpass
