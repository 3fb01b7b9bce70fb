// CHOLMOD's supernodal factorisation of the symmetric system, through Eigen's wrapper.
#include <Eigen/CholmodSupport>

#include "contenders.hpp"
#include "judges.hpp"
#include "loop_system.hpp"

namespace surpass::bench {
namespace {

using Factor = Eigen::CholmodSupernodalLLT<ColumnMatrix>;

std::unique_ptr<Factor> factor_of(const ColumnMatrix& system) {
  auto factor = std::make_unique<Factor>();
  factor->compute(system);
  return factor;
}

Verdict judge(const Workload& workload, const Columns& control) {
  return judge_control(workload, as_points(control));
}

}  // namespace

void add_cholmod(Harness& harness, Index side) {
  harness.add(
      {.step = "solve from faces",
       .tool = "CHOLMOD",
       .counted = "assembly of S, analysis, factorisation and solve for 3 right-hand sides",
       .slow = true},
      side,
      [](const Workload& w) {
        return [&mesh = w.mesh()]() -> Columns {
          const ColumnMatrix system = symmetric_system(mesh);
          return factor_of(system)->solve(right_hand_sides(system, mesh.points));
        };
      },
      judge);
  harness.add(
      {.step = "solve again",
       .tool = "CHOLMOD",
       .counted = "right-hand sides and solve with the factor kept"},
      side,
      [](const Workload& w) {
        const ColumnMatrix system = symmetric_system(w.mesh());
        return [&mesh = w.mesh(), system, factor = factor_of(system)]() -> Columns {
          return factor->solve(right_hand_sides(system, mesh.points));
        };
      },
      judge);
}

}  // namespace surpass::bench
