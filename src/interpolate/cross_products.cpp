// The similarity of directions: Lai and Cheng 2006, equations 3 and 5. As |g x q|^2 = |g|^2 |q|^2 -
// (g.q)^2, each row's part of H is its weights' squares times the block |g|^2 I - g g'. Nothing is
// kept of the reference's derivatives g: to compute them again is faster than to read them.
#include <algorithm>
#include <array>

#include "interpolate/patch_energy.hpp"

namespace surpass {
namespace {

constexpr double kRegular = 0.09;     // share of the mean that regularises: 0.3 squared
constexpr double kVanishing = 1e-24;  // of the mean of |g|^2; below it g has no direction
constexpr std::size_t kLanes = PatchLayout::kLanes;

// A number, and a vector, of each of the patches that are treated abreast.
using Lanes = std::array<double, kLanes>;
using Vectors = std::array<Lanes, 3>;

// The rows of a kind without their zeros.
struct SparseKind {
  struct Row {
    std::size_t begin;
    std::size_t end;
    double count;
    std::size_t order;  // of the derivative, from 0
  };
  std::size_t columns = 0;
  std::vector<Row> rows;
  std::vector<Index> column;
  std::vector<double> weight;

  explicit SparseKind(const PatchKind& kind);
};

SparseKind::SparseKind(const PatchKind& kind) : columns(kind.columns) {
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    if (kind.derivative[r] == Derivative::mixed) continue;
    const std::size_t order = kind.derivative[r] == Derivative::first    ? 0
                              : kind.derivative[r] == Derivative::second ? 1
                                                                         : 2;
    const std::size_t begin = column.size();
    for (std::size_t c = 0; c < columns; ++c) {
      const double w = kind.row(r)[c];
      if (w == 0) continue;
      column.push_back(static_cast<Index>(c));
      weight.push_back(w);
    }
    rows.push_back({begin, column.size(), kind.count[r], order});
  }
}

// Sums of count |g|^2 and of count, by order.
struct Means {
  std::array<double, 3> squares = {};
  std::array<double, 3> counts = {};
  [[nodiscard]] double mean(std::size_t order) const {
    return counts[order] > 0 ? squares[order] / counts[order] : 0;
  }
};

// The points of a group of patches side by side; lanes without a patch are 0, and so is then all
// that is made of them.
void gather(const Index* local, std::size_t columns, std::size_t lanes, const double* x,
            std::vector<Vectors>& points) {
  points.assign(columns, Vectors{});
  for (std::size_t l = 0; l < lanes; ++l) {
    for (std::size_t c = 0; c < columns; ++c) {
      const double* p = x + std::size_t{3} * local[l * columns + c];
      for (std::size_t k = 0; k < 3; ++k) points[c][k][l] = p[k];
    }
  }
}

void scatter(const Index* local, std::size_t columns, std::size_t lanes,
             const std::vector<Vectors>& points, double* y) {
  for (std::size_t l = 0; l < lanes; ++l) {
    for (std::size_t c = 0; c < columns; ++c) {
      double* to = y + std::size_t{3} * local[l * columns + c];
      for (std::size_t k = 0; k < 3; ++k) to[k] += points[c][k][l];
    }
  }
}

inline void times(const SparseKind& kind, const SparseKind::Row& row,
                  const std::vector<Vectors>& points, Vectors& product) {
  product = {};
  for (std::size_t i = row.begin; i < row.end; ++i) {
    const double w = kind.weight[i];
    const Vectors& p = points[kind.column[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < kLanes; ++l) product[k][l] += w * p[k][l];
    }
  }
}

inline void dot(const Vectors& a, const Vectors& b, Lanes& product) {
  for (std::size_t l = 0; l < kLanes; ++l) {
    product[l] = a[0][l] * b[0][l] + a[1][l] * b[1][l] + a[2][l] * b[2][l];
  }
}

class CrossProducts final : public PatchEnergy {
 public:
  CrossProducts(const PatchLayout& layout, std::span<const double> reference, RowWeights weights,
                const Context& context)
      : layout_(layout), reference_(reference), weights_(weights) {
    for (const PatchKind& kind : layout.rows().kinds()) kinds_.emplace_back(kind);
    if (weights != RowWeights::none) find_means(context);
  }

  void product(const Context& context, std::size_t width, std::span<const double> x,
               std::span<double> y) const override;
  [[nodiscard]] std::size_t block_size() const override { return 6; }
  [[nodiscard]] std::vector<double> diagonal(const Context& context) const override;
  void for_blocks(std::size_t patch, const UseBlock& use) const override;

 private:
  void find_means(const Context& context);
  // From |g|^2 to the weight of the row; 0 stays 0 or becomes what does no harm to lanes of zeros.
  void weigh(const SparseKind::Row& row, const Lanes& square, Lanes& weight) const;
  [[nodiscard]] std::vector<double> local_points(const PatchLayout::Chunk& chunk,
                                                 std::span<const double> x) const;

  const PatchLayout& layout_;
  std::span<const double> reference_;
  RowWeights weights_;
  std::vector<SparseKind> kinds_;
  Means means_;
};

std::vector<double> CrossProducts::local_points(const PatchLayout::Chunk& chunk,
                                                std::span<const double> x) const {
  std::vector<double> own(3 * chunk.points.size());
  for (std::size_t k = 0; k < chunk.points.size(); ++k) {
    std::copy_n(x.data() + std::size_t{3} * chunk.points[k], 3, own.data() + 3 * k);
  }
  return own;
}

void CrossProducts::find_means(const Context& context) {
  means_ = layout_.reduce(
      context, Means{},
      [&](const PatchLayout::Chunk& chunk) {
        Means sums;
        const auto reference = local_points(chunk, reference_);
        std::vector<Vectors> points;
        layout_.for_groups(chunk, [&](Index number, const Index* local, std::size_t lanes) {
          const SparseKind& kind = kinds_[number];
          gather(local, kind.columns, lanes, reference.data(), points);
          for (const SparseKind::Row& row : kind.rows) {
            Vectors g;
            Lanes square;
            times(kind, row, points, g);
            dot(g, g, square);
            for (std::size_t l = 0; l < lanes; ++l) {
              sums.squares[row.order] += row.count * square[l];
              sums.counts[row.order] += row.count;
            }
          }
        });
        return sums;
      },
      [](Means sum, const Means& part) {
        for (std::size_t k = 0; k < 3; ++k) {
          sum.squares[k] += part.squares[k];
          sum.counts[k] += part.counts[k];
        }
        return sum;
      });
}

void CrossProducts::weigh(const SparseKind::Row& row, const Lanes& square, Lanes& weight) const {
  const double first = means_.mean(0);
  const auto inverse = [&](double x) { return x > 0 ? row.count / x : 0.0; };
  switch (weights_) {
    case RowWeights::none: weight.fill(row.count); return;
    case RowWeights::unit:
      for (std::size_t l = 0; l < kLanes; ++l) {
        weight[l] = square[l] > kVanishing * first ? inverse(square[l]) : 0;
      }
      return;
    case RowWeights::order:
      weight.fill(inverse(std::max(means_.mean(row.order), kVanishing * first)));
      return;
    case RowWeights::regularised:
      for (std::size_t l = 0; l < kLanes; ++l) weight[l] = inverse(square[l] + kRegular * first);
      return;
  }
}

void CrossProducts::product(const Context& context, std::size_t, std::span<const double> x,
                            std::span<double> y) const {
  layout_.add_up(context, 3, y, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto reference = local_points(chunk, reference_);
    const auto own = local_points(chunk, x);
    std::vector<Vectors> at_reference;
    std::vector<Vectors> at_x;
    std::vector<Vectors> sums;
    layout_.for_groups(chunk, [&](Index number, const Index* local, std::size_t lanes) {
      const SparseKind& kind = kinds_[number];
      gather(local, kind.columns, lanes, reference.data(), at_reference);
      gather(local, kind.columns, lanes, own.data(), at_x);
      sums.assign(kind.columns, Vectors{});
      for (const SparseKind::Row& row : kind.rows) {
        Vectors g;
        Vectors q;
        Lanes square;
        Lanes along;
        Lanes weight;
        times(kind, row, at_reference, g);
        times(kind, row, at_x, q);
        dot(g, g, square);
        dot(g, q, along);
        weigh(row, square, weight);
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t l = 0; l < kLanes; ++l) {
            q[k][l] = weight[l] * (square[l] * q[k][l] - along[l] * g[k][l]);
          }
        }
        for (std::size_t i = row.begin; i < row.end; ++i) {
          const double w = kind.weight[i];
          Vectors& to = sums[kind.column[i]];
          for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t l = 0; l < kLanes; ++l) to[k][l] += w * q[k][l];
          }
        }
      }
      scatter(local, kind.columns, lanes, sums, values.data());
    });
  });
}

// The upper triangle of w (|g|^2 I - g g').
std::array<double, 6> block_of(const Vectors& g, double w, std::size_t lane) {
  const std::array<double, 3> v = {g[0][lane], g[1][lane], g[2][lane]};
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  return {w * (square - v[0] * v[0]), -w * v[0] * v[1], -w * v[0] * v[2],
          w * (square - v[1] * v[1]), -w * v[1] * v[2], w * (square - v[2] * v[2])};
}

std::vector<double> CrossProducts::diagonal(const Context& context) const {
  std::vector<double> sum(std::size_t{6} * layout_.control_count());
  layout_.add_up(context, 6, sum, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto reference = local_points(chunk, reference_);
    std::vector<Vectors> points;
    layout_.for_groups(chunk, [&](Index number, const Index* local, std::size_t lanes) {
      const SparseKind& kind = kinds_[number];
      gather(local, kind.columns, lanes, reference.data(), points);
      for (const SparseKind::Row& row : kind.rows) {
        Vectors g;
        Lanes square;
        Lanes weight;
        times(kind, row, points, g);
        dot(g, g, square);
        weigh(row, square, weight);
        for (std::size_t l = 0; l < lanes; ++l) {
          const auto block = block_of(g, weight[l], l);
          for (std::size_t i = row.begin; i < row.end; ++i) {
            const double w = kind.weight[i] * kind.weight[i];
            double* to = values.data() + std::size_t{6} * local[l * kind.columns + kind.column[i]];
            for (std::size_t c = 0; c < 6; ++c) to[c] += w * block[c];
          }
        }
      }
    });
  });
  return sum;
}

void CrossProducts::for_blocks(std::size_t patch, const UseBlock& use) const {
  const SparseKind& kind = kinds_[layout_.rows().kind_number(patch)];
  const std::size_t n = kind.columns;
  std::vector<Vectors> points;
  gather(layout_.rows().columns(patch).data(), n, 1, reference_.data(), points);
  std::vector<double> blocks(6 * n * n, 0.0);
  for (const SparseKind::Row& row : kind.rows) {
    Vectors g;
    Lanes square;
    Lanes weight;
    times(kind, row, points, g);
    dot(g, g, square);
    weigh(row, square, weight);
    const auto block = block_of(g, weight[0], 0);
    for (std::size_t i = row.begin; i < row.end; ++i) {
      for (std::size_t j = row.begin; j < row.end; ++j) {
        double* to = &blocks[6 * (kind.column[i] * n + kind.column[j])];
        for (std::size_t c = 0; c < 6; ++c) to[c] += kind.weight[i] * kind.weight[j] * block[c];
      }
    }
  }
  for (std::size_t k = 0; k < n * n; ++k) use(k / n, k % n, blocks.data() + 6 * k);
}

}  // namespace

std::unique_ptr<PatchEnergy> cross_products(const PatchLayout& layout,
                                            std::span<const double> reference, RowWeights weights,
                                            const Context& context) {
  return std::make_unique<CrossProducts>(layout, reference, weights, context);
}

}  // namespace surpass
