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
  [[nodiscard]] const KindForm& form(std::size_t patch) const {
    return forms_[layout_.rows().kind_number(patch)];
  }

  const PatchLayout& layout_;
  std::vector<KindForm> forms_;  // for each kind of patch
};

// y += matrix x for the points of one patch.
template <std::size_t kWidth>
void apply_form(const Matrix& matrix, const Index* local, std::size_t width, const double* x,
                double* y) {
  const std::size_t w = kWidth != 0 ? kWidth : width;
  const auto n = static_cast<std::size_t>(matrix.cols());
  for (std::size_t a = 0; a < n; ++a) {
    const double* row = matrix.data() + a * n;
    double* to = y + local[a] * w;
    if constexpr (kWidth == 3) {
      double s0 = 0;
      double s1 = 0;
      double s2 = 0;
      for (std::size_t b = 0; b < n; ++b) {
        const double* p = x + std::size_t{3} * local[b];
        s0 += row[b] * p[0];
        s1 += row[b] * p[1];
        s2 += row[b] * p[2];
      }
      to[0] += s0;
      to[1] += s1;
      to[2] += s2;
    } else {
      for (std::size_t c = 0; c < w; ++c) {
        double s = 0;
        for (std::size_t b = 0; b < n; ++b) s += row[b] * x[local[b] * w + c];
        to[c] += s;
      }
    }
  }
}

// y += rows' rows x.
void apply_rows(const Matrix& rows, const Index* local, std::size_t width, const double* x,
                double* y) {
  const auto n = static_cast<std::size_t>(rows.cols());
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    const double* row = rows.data() + static_cast<std::size_t>(r) * n;
    for (std::size_t c = 0; c < width; ++c) {
      double s = 0;
      for (std::size_t b = 0; b < n; ++b) s += row[b] * x[local[b] * width + c];
      for (std::size_t b = 0; b < n; ++b) y[local[b] * width + c] += row[b] * s;
    }
  }
}

void SumOfSquares::product(const Context& context, std::size_t width, std::span<const double> x,
                           std::span<double> y) const {
  layout_.add_up(context, width, y, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    std::vector<double> own(values.size());
    for (std::size_t k = 0; k < chunk.points.size(); ++k) {
      std::copy_n(x.data() + chunk.points[k] * width, width, own.data() + k * width);
    }
    const Index* local = chunk.local;
    for (std::size_t p = chunk.first; p < chunk.last; ++p) {
      const KindForm& f = form(p);
      if (f.rows.size() != 0) {
        apply_rows(f.rows, local, width, own.data(), values.data());
      } else if (width == 3) {
        apply_form<3>(f.matrix, local, width, own.data(), values.data());
      } else {
        apply_form<0>(f.matrix, local, width, own.data(), values.data());
      }
      local += layout_.rows().kind(p).columns;
    }
  });
}

std::vector<double> SumOfSquares::diagonal(const Context& context) const {
  std::vector<double> sum(layout_.control_count());
  layout_.add_up(context, 1, sum, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const Index* local = chunk.local;
    for (std::size_t p = chunk.first; p < chunk.last; ++p) {
      const KindForm& f = form(p);
      const std::size_t n = layout_.rows().kind(p).columns;
      for (std::size_t a = 0; a < n; ++a) {
        const auto at = static_cast<Eigen::Index>(a);
        values[local[a]] += f.rows.size() != 0     ? f.rows.col(at).squaredNorm()
                            : f.matrix.size() != 0 ? f.matrix(at, at)
                                                   : 0.0;
      }
      local += n;
    }
  });
  return sum;
}

void SumOfSquares::for_blocks(std::size_t patch, const UseBlock& use) const {
  const KindForm& f = form(patch);
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
