// Energies that see each coordinate alone: one small matrix for every kind of patch.
#include <Eigen/Core>

#include "interpolate/patch_energy.hpp"

namespace surpass {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// row' row, summed: a matrix, or the rows themselves where those are fewer numbers.
struct KindForm {
  Matrix matrix;  // symmetric, or empty
  Matrix rows;    // scaled by the root of their weight, or empty
};

KindForm form_of(const PatchKind& kind, RowWeight weight, double thin_plate, double membrane) {
  std::vector<std::size_t> used;
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    if (weight(kind, r, thin_plate, membrane) > 0) used.push_back(r);
  }
  Matrix rows(used.size(), kind.columns);
  for (std::size_t k = 0; k < used.size(); ++k) {
    const auto row = kind.row(used[k]);
    rows.row(static_cast<Eigen::Index>(k)) =
        std::sqrt(weight(kind, used[k], thin_plate, membrane)) *
        Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
  }
  if (kind.columns > 2 * used.size()) return {{}, std::move(rows)};
  return {rows.transpose() * rows, {}};
}

class SumOfSquares final : public PatchEnergy {
 public:
  SumOfSquares(const PatchLayout& layout, RowWeight weight, double thin_plate, double membrane)
      : layout_(layout) {
    for (const PatchKind& kind : layout.rows().kinds()) {
      forms_.push_back(form_of(kind, weight, thin_plate, membrane));
    }
  }

  void product(const Context& context, std::size_t width, std::span<const double> x,
               std::span<double> y) const override;
  [[nodiscard]] std::size_t block_size() const override { return 1; }
  [[nodiscard]] std::vector<double> diagonal(const Context& context) const override;
  void for_blocks(std::size_t patch, const UseBlock& use) const override;

 private:
  const PatchLayout& layout_;
  std::vector<KindForm> forms_;  // for each kind of patch
};

// y += matrix x for the points of one patch.
void apply_matrix(const Matrix& matrix, const Index* local, std::size_t width, const double* x,
                  double* y) {
  const auto n = static_cast<std::size_t>(matrix.cols());
  for (std::size_t a = 0; a < n; ++a) {
    const double* row = matrix.data() + a * n;
    for (std::size_t c = 0; c < width; ++c) {
      double sum = 0;
      for (std::size_t b = 0; b < n; ++b) sum += row[b] * x[local[b] * width + c];
      y[local[a] * width + c] += sum;
    }
  }
}

// The same for kLanes patches and three right-hand sides, the case that matters: n points with a
// patch in every lane.
template <class W>
[[gnu::always_inline]] inline void times_lanes(const double* matrix, std::size_t n,
                                               const LaneVectors* points, std::size_t first,
                                               LaneVectors* sums) {
  using Numbers = typename W::Numbers;
  for (std::size_t a = 0; a < n; ++a) {
    const double* row = matrix + a * n;
    Numbers sum[3] = {};
    for (std::size_t b = 0; b < n; ++b) {
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += row[b] * *reinterpret_cast<const Numbers*>(points[b].of[c] + first);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      *reinterpret_cast<Numbers*>(sums[a].of[c] + first) = sum[c];
    }
  }
}

void times_abreast(const double* matrix, std::size_t n, const LaneVectors* points,
                   LaneVectors* sums) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) {
      times_lanes<W>(matrix, n, points, l, sums);
    }
  });
}

void apply_matrix_abreast(const Matrix& matrix, const Index* local, const double* x, double* y,
                          std::vector<LaneVectors>& points, std::vector<LaneVectors>& sums) {
  const auto n = static_cast<std::size_t>(matrix.cols());
  points.resize(n);
  sums.resize(n);
  for (std::size_t l = 0; l < kLanes; ++l) {
    for (std::size_t b = 0; b < n; ++b) points[b].set(l, x + std::size_t{3} * local[l * n + b]);
  }
  times_abreast(matrix.data(), n, points.data(), sums.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    for (std::size_t a = 0; a < n; ++a) sums[a].add_to(l, y + std::size_t{3} * local[l * n + a]);
  }
}

// y += rows' rows x.
void apply_rows(const Matrix& rows, const Index* local, std::size_t width, const double* x,
                double* y) {
  const auto n = static_cast<std::size_t>(rows.cols());
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    const double* row = rows.data() + static_cast<std::size_t>(r) * n;
    for (std::size_t c = 0; c < width; ++c) {
      double sum = 0;
      for (std::size_t b = 0; b < n; ++b) sum += row[b] * x[local[b] * width + c];
      for (std::size_t b = 0; b < n; ++b) y[local[b] * width + c] += row[b] * sum;
    }
  }
}

void SumOfSquares::product(const Context& context, std::size_t width, std::span<const double> x,
                           std::span<double> y) const {
  layout_.add_up(context, width, y, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto own = chunk.copy(width, x);
    std::vector<LaneVectors> points;
    std::vector<LaneVectors> sums;
    layout_.for_groups(chunk, [&](Index kind, const Index* local, std::size_t lanes) {
      const KindForm& f = forms_[kind];
      if (f.matrix.size() != 0 && width == 3 && lanes == kLanes) {
        apply_matrix_abreast(f.matrix, local, own.data(), values.data(), points, sums);
        return;
      }
      for (std::size_t l = 0; l < lanes; ++l, local += layout_.rows().kinds()[kind].columns) {
        if (f.rows.size() != 0) apply_rows(f.rows, local, width, own.data(), values.data());
        if (f.matrix.size() != 0) apply_matrix(f.matrix, local, width, own.data(), values.data());
      }
    });
  });
}

double diagonal_of(const KindForm& form, std::size_t column) {
  const auto at = static_cast<Eigen::Index>(column);
  if (form.rows.size() != 0) return form.rows.col(at).squaredNorm();
  return form.matrix.size() != 0 ? form.matrix(at, at) : 0;
}

std::vector<double> SumOfSquares::diagonal(const Context& context) const {
  std::vector<std::vector<double>> diagonals(forms_.size());
  for (std::size_t k = 0; k < forms_.size(); ++k) {
    for (std::size_t a = 0; a < layout_.rows().kinds()[k].columns; ++a) {
      diagonals[k].push_back(diagonal_of(forms_[k], a));
    }
  }
  std::vector<double> sum(layout_.control_count());
  layout_.add_up(context, 1, sum, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    layout_.for_groups(chunk, [&](Index kind, const Index* local, std::size_t lanes) {
      const std::vector<double>& diagonal = diagonals[kind];
      for (std::size_t k = 0; k < lanes * diagonal.size(); ++k) {
        values[local[k]] += diagonal[k % diagonal.size()];
      }
    });
  });
  return sum;
}

void SumOfSquares::for_blocks(std::size_t patch, const UseBlock& use) const {
  const KindForm& f = forms_[layout_.rows().kind_number(patch)];
  const Matrix matrix = f.rows.size() != 0 ? Matrix(f.rows.transpose() * f.rows) : f.matrix;
  for (Eigen::Index a = 0; a < matrix.rows(); ++a) {
    for (Eigen::Index b = 0; b < matrix.cols(); ++b) {
      use(static_cast<std::size_t>(a), static_cast<std::size_t>(b), &matrix(a, b));
    }
  }
}

}  // namespace

double vectors_weight(const PatchKind& kind, std::size_t row, double, double) {
  return kind.derivative[row] == Derivative::mixed ? 0 : kind.count[row];
}

double fair_weight(const PatchKind& kind, std::size_t row, double thin_plate, double membrane) {
  switch (kind.derivative[row]) {
    case Derivative::first: return membrane * kind.area[row];
    case Derivative::second: return thin_plate * kind.area[row];
    case Derivative::mixed: return 2 * thin_plate * kind.area[row];
    case Derivative::third: break;
  }
  return 0;
}

std::unique_ptr<PatchEnergy> sum_of_squares(const PatchLayout& layout, RowWeight weight,
                                            double thin_plate, double membrane) {
  return std::make_unique<SumOfSquares>(layout, weight, thin_plate, membrane);
}

}  // namespace surpass
