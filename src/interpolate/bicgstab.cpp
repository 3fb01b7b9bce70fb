// BiCGSTAB: H. van der Vorst, SIAM J. Sci. Stat. Comput. 13, 1992. Each right-hand side by itself.
#include "interpolate/solvers.hpp"

namespace surpass {
namespace {

double quotient(double a, double b) { return b != 0 ? a / b : 0; }

}  // namespace

Verdict bicgstab(const LinearSystem& system, Monitor& monitor, std::span<double> x) {
  system.for_values([&](std::size_t at, std::size_t) { x[at] = system.target[at]; });
  const std::size_t n = system.values();
  std::vector<double> r(n, 0.0);
  std::vector<double> p(n, 0.0);
  std::vector<double> lp(n, 0.0);
  std::vector<double> ls(n, 0.0);
  for (;;) {  // restarts with the true residual when the recurrence has run down
    Verdict verdict = monitor.record(system.residual(x, r));
    if (verdict != Verdict::go_on) return verdict;
    const std::vector<double> shadow = r;
    p = r;
    std::vector<double> rho = system.dot(shadow, r, nullptr);
    constexpr unsigned kRestart = 100;
    for (unsigned k = 0; k < kRestart; ++k) {
      system.product(p, lp);
      const std::vector<double> shadow_lp = system.dot(shadow, lp, nullptr);
      std::vector<double> alpha(system.width);
      for (std::size_t c = 0; c < system.width; ++c) alpha[c] = quotient(rho[c], shadow_lp[c]);
      system.for_values([&](std::size_t at, std::size_t c) { r[at] -= alpha[c] * lp[at]; });
      system.product(r, ls);
      const std::vector<double> ls_r = system.dot(ls, r, nullptr);
      const std::vector<double> ls_ls = system.dot(ls, ls, nullptr);
      std::vector<double> omega(system.width);
      for (std::size_t c = 0; c < system.width; ++c) omega[c] = quotient(ls_r[c], ls_ls[c]);
      system.for_values([&](std::size_t at, std::size_t c) {
        x[at] += alpha[c] * p[at] + omega[c] * r[at];
        r[at] -= omega[c] * ls[at];
      });
      verdict = monitor.record(system.block_norms(r));
      if (verdict == Verdict::reached || verdict == Verdict::stalled) break;
      if (verdict != Verdict::go_on) return verdict;
      const std::vector<double> next = system.dot(shadow, r, nullptr);
      std::vector<double> beta(system.width);
      for (std::size_t c = 0; c < system.width; ++c) {
        beta[c] = quotient(next[c], rho[c]) * quotient(alpha[c], omega[c]);
      }
      system.for_values([&](std::size_t at, std::size_t c) {
        p[at] = r[at] + beta[c] * (p[at] - omega[c] * lp[at]);
      });
      rho = next;
    }
    if (verdict == Verdict::stalled) return verdict;
  }
}

}  // namespace surpass
