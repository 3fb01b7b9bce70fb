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

  double product(const Context& context, std::size_t width, Precision, std::span<const double> x,
                 std::span<double> y) const override;
  [[nodiscard]] std::size_t block_size() const override { return 1; }
  [[nodiscard]] std::vector<double> diagonal(const Context& context) const override;
  void for_blocks(std::size_t patch, std::span<const Index> columns,
                  const UseBlock& use) const override;

 private:
  const PatchLayout& layout_;
  std::vector<KindForm> forms_;  // for each kind of patch
};

// What is done for each of the patches of a group: `local` numbers its points, of which each has
// `width` numbers, `stride` apart.
struct Group {
  const LocalIndex* local;
  std::size_t width;
  std::size_t stride;
  const double* x;
  double* y;
};

// y += matrix x for the points of one patch.
void apply_matrix(const Matrix& matrix, const Group& at) {
  const auto n = static_cast<std::size_t>(matrix.cols());
  for (std::size_t a = 0; a < n; ++a) {
    const double* row = matrix.data() + a * n;
    for (std::size_t c = 0; c < at.width; ++c) {
      double sum = 0;
      for (std::size_t b = 0; b < n; ++b) sum += row[b] * at.x[at.local[b] * at.stride + c];
      at.y[at.local[a] * at.stride + c] += sum;
    }
  }
}

// y += rows' rows x.
void apply_rows(const Matrix& rows, const Group& at) {
  const auto n = static_cast<std::size_t>(rows.cols());
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    const double* row = rows.data() + static_cast<std::size_t>(r) * n;
    for (std::size_t c = 0; c < at.width; ++c) {
      double sum = 0;
      for (std::size_t b = 0; b < n; ++b) sum += row[b] * at.x[at.local[b] * at.stride + c];
      for (std::size_t b = 0; b < n; ++b) at.y[at.local[b] * at.stride + c] += row[b] * sum;
    }
  }
}

// The matrix for a patch in every lane and three right-hand sides, the case that matters: n points.
// kRows rows at once, so that a sum need not wait for the one before.
template <class W, std::size_t kRows>
[[gnu::always_inline]] inline void times_rows(const double* rows, std::size_t n,
                                              const LaneVectors<double>* points, std::size_t first,
                                              LaneVectors<double>* sums) {
  using Numbers = typename W::Numbers;
  Numbers sum[kRows][3] = {};
  for (std::size_t b = 0; b < n; ++b) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Numbers& x = *reinterpret_cast<const Numbers*>(points[b].of[c] + first);
      for (std::size_t a = 0; a < kRows; ++a) sum[a][c] += rows[a * n + b] * x;
    }
  }
  for (std::size_t a = 0; a < kRows; ++a) {
    for (std::size_t c = 0; c < 3; ++c) {
      *reinterpret_cast<Numbers*>(sums[a].of[c] + first) = sum[a][c];
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void times_lanes(const double* matrix, std::size_t n,
                                               const LaneVectors<double>* points, std::size_t first,
                                               LaneVectors<double>* sums) {
  constexpr std::size_t kAtOnce = 4;
  std::size_t a = 0;
  for (; a + kAtOnce <= n; a += kAtOnce) {
    times_rows<W, kAtOnce>(matrix + a * n, n, points, first, sums + a);
  }
  for (; a < n; ++a) times_rows<W, 1>(matrix + a * n, n, points, first, sums + a);
}

void times_abreast(const double* matrix, std::size_t n, std::size_t lanes,
                   const LaneVectors<double>* points, LaneVectors<double>* sums) {
  run_on_lanes<double>([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < lanes; l += kCount<W>) {
      times_lanes<W>(matrix, n, points, l, sums);
    }
  });
}

void apply_matrix_abreast(const Matrix& matrix, std::size_t lanes, const Group& at,
                          std::vector<LaneVectors<double>>& points,
                          std::vector<LaneVectors<double>>& sums) {
  const auto n = static_cast<std::size_t>(matrix.cols());
  if (points.size() < n) {
    points.resize(n);
    sums.resize(n);
  }
  gather_points(at.local, n, lanes, at.x, points.data());
  times_abreast(matrix.data(), n, lanes, points.data(), sums.data());
  scatter_points(at.local, n, lanes, sums.data(), at.y);
}

double SumOfSquares::product(const Context& context, std::size_t width, Precision,
                             std::span<const double> x, std::span<double> y) const {
  const bool abreast = width == 3;
  const std::size_t stride = abreast ? kPointStride : width;
  const auto work = [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const std::size_t size = stride * chunk.points.size();
    const auto own = std::make_unique_for_overwrite<double[]>(size);
    chunk.copy_to(width, stride, x, own.get());
    std::vector<LaneVectors<double>> points;
    std::vector<LaneVectors<double>> sums;
    layout_.for_groups<kLanes<double>>(chunk, [&](Index kind, const LocalIndex* local,
                                                  std::size_t lanes) {
      const KindForm& f = forms_[kind];
      Group at{local, width, stride, own.get(), values.data()};
      if (f.matrix.size() != 0 && abreast) {
        apply_matrix_abreast(f.matrix, lanes, at, points, sums);
        return;
      }
      for (std::size_t l = 0; l < lanes; ++l, at.local += layout_.rows().kinds()[kind].columns) {
        if (f.rows.size() != 0) apply_rows(f.rows, at);
        if (f.matrix.size() != 0) apply_matrix(f.matrix, at);
      }
    });
    return dot_of_points({own.get(), size}, values);
  };
  return layout_.add_up<double>(context, width, stride, y, work);
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
  layout_.add_up<double>(context, 1, 1, std::span(sum),
                         [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
                           layout_.for_groups<kLanes<double>>(
                               chunk, [&](Index kind, const LocalIndex* local, std::size_t lanes) {
                                 const std::vector<double>& diagonal = diagonals[kind];
                                 for (std::size_t k = 0; k < lanes * diagonal.size(); ++k) {
                                   values[local[k]] += diagonal[k % diagonal.size()];
                                 }
                               });
                           return 0;
                         });
  return sum;
}

void SumOfSquares::for_blocks(std::size_t patch, std::span<const Index> /*columns*/,
                              const UseBlock& use) const {
  const KindForm& f = forms_[layout_.rows().kind_number(patch)];
  const Matrix matrix = f.rows.size() != 0 ? Matrix(f.rows.transpose() * f.rows) : f.matrix;
  for (Eigen::Index a = 0; a < matrix.rows(); ++a) {
    for (Eigen::Index b = 0; b < matrix.cols(); ++b) {
      if (matrix(a, b) == 0) continue;
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
