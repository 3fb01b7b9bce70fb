// Numbers that were rounded, made to agree.
#pragma once

#include <Eigen/Core>

#include "interpolate/independent_rows.hpp"

namespace surpass {

/// The values of all rows, those of kept ones changed so that the squares of these changes and of
/// what the dropped rows then miss their values by are least in sum. So what rounding did to
/// consistent values is not multiplied by the shares. `dropped` rows are sums of kept ones. Cost:
/// that of a sparse Cholesky decomposition of as many rows as are dropped. As they were if
/// cancelled.
[[nodiscard]] Eigen::VectorXd balanced_values(const std::vector<DependentRow>& dropped,
                                              const Eigen::VectorXd& values,
                                              const Context& context);

}  // namespace surpass
