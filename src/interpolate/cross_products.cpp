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
            std::vector<LaneVectors>& points) {
  points.assign(columns, {});
  for (std::size_t l = 0; l < lanes; ++l) {
    for (std::size_t c = 0; c < columns; ++c) {
      points[c].set(l, x + std::size_t{3} * local[l * columns + c]);
    }
  }
}

void scatter(const Index* local, std::size_t columns, std::size_t lanes,
             const std::vector<LaneVectors>& points, double* y) {
  for (std::size_t l = 0; l < lanes; ++l) {
    for (std::size_t c = 0; c < columns; ++c) {
      points[c].add_to(l, y + std::size_t{3} * local[l * columns + c]);
    }
  }
}

LaneVectors times(const SparseKind& kind, const SparseKind::Row& row,
                  const std::vector<LaneVectors>& points) {
  LaneVectors sum;
  for (std::size_t i = row.begin; i < row.end; ++i) {
    sum.add(Lanes::all(kind.weight[i]), points[kind.column[i]]);
  }
  return sum;
}

// sums += the row's weights times a vector.
void add_times(const SparseKind& kind, const SparseKind::Row& row, const LaneVectors& vector,
               std::vector<LaneVectors>& sums) {
  for (std::size_t i = row.begin; i < row.end; ++i) {
    sums[kind.column[i]].add(Lanes::all(kind.weight[i]), vector);
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
  // From |g|^2 to the weight of the row; any will do where a lane has no patch.
  [[nodiscard]] Lanes weight(const SparseKind::Row& row, const Lanes& square) const;
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
        std::vector<LaneVectors> points;
        layout_.for_groups(chunk, [&](Index number, const Index* local, std::size_t lanes) {
          const SparseKind& kind = kinds_[number];
          gather(local, kind.columns, lanes, reference.data(), points);
          for (const SparseKind::Row& row : kind.rows) {
            const LaneVectors g = times(kind, row, points);
            const Lanes square = dot(g, g);
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

Lanes CrossProducts::weight(const SparseKind::Row& row, const Lanes& square) const {
  const double first = means_.mean(0);
  switch (weights_) {
    case RowWeights::none: break;
    case RowWeights::unit: {
      Lanes weight;
      for (std::size_t l = 0; l < kLanes; ++l) {
        if (square[l] > kVanishing * first) weight.set(l, row.count / square[l]);
      }
      return weight;
    }
    case RowWeights::order: {
      const double mean = std::max(means_.mean(row.order), kVanishing * first);
      return Lanes::all(mean > 0 ? row.count / mean : 0);
    }
    case RowWeights::regularised:
      if (!(first > 0)) return {};
      return Lanes::all(row.count) / (square + Lanes::all(kRegular * first));
  }
  return Lanes::all(row.count);
}

void CrossProducts::product(const Context& context, std::size_t, std::span<const double> x,
                            std::span<double> y) const {
  layout_.add_up(context, 3, y, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto reference = local_points(chunk, reference_);
    const auto own = local_points(chunk, x);
    std::vector<LaneVectors> at_reference;
    std::vector<LaneVectors> at_x;
    std::vector<LaneVectors> sums;
    layout_.for_groups(chunk, [&](Index number, const Index* local, std::size_t lanes) {
      const SparseKind& kind = kinds_[number];
      gather(local, kind.columns, lanes, reference.data(), at_reference);
      gather(local, kind.columns, lanes, own.data(), at_x);
      sums.assign(kind.columns, {});
      for (const SparseKind::Row& row : kind.rows) {
        const LaneVectors g = times(kind, row, at_reference);
        const LaneVectors q = times(kind, row, at_x);
        const Lanes square = dot(g, g);
        const Lanes w = weight(row, square);
        LaneVectors stress;
        stress.add(w * square, q);
        stress.add(Lanes() - w * dot(g, q), g);
        add_times(kind, row, stress, sums);
      }
      scatter(local, kind.columns, lanes, sums, values.data());
    });
  });
}

// The upper triangle of w (|g|^2 I - g g').
std::array<double, 6> block_of(const LaneVectors& g, double w, std::size_t lane) {
  const std::array<double, 3> v = {g.x[lane], g.y[lane], g.z[lane]};
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  return {w * (square - v[0] * v[0]), -w * v[0] * v[1], -w * v[0] * v[2],
          w * (square - v[1] * v[1]), -w * v[1] * v[2], w * (square - v[2] * v[2])};
}

std::vector<double> CrossProducts::diagonal(const Context& context) const {
  std::vector<double> sum(std::size_t{6} * layout_.control_count());
  layout_.add_up(context, 6, sum, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto reference = local_points(chunk, reference_);
    std::vector<LaneVectors> points;
    layout_.for_groups(chunk, [&](Index number, const Index* local, std::size_t lanes) {
      const SparseKind& kind = kinds_[number];
      gather(local, kind.columns, lanes, reference.data(), points);
      for (const SparseKind::Row& row : kind.rows) {
        const LaneVectors g = times(kind, row, points);
        const Lanes weights = weight(row, dot(g, g));
        for (std::size_t l = 0; l < lanes; ++l) {
          const auto block = block_of(g, weights[l], l);
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
  std::vector<LaneVectors> points;
  gather(layout_.rows().columns(patch).data(), n, 1, reference_.data(), points);
  std::vector<double> blocks(6 * n * n, 0.0);
  for (const SparseKind::Row& row : kind.rows) {
    const LaneVectors g = times(kind, row, points);
    const auto block = block_of(g, weight(row, dot(g, g))[0], 0);
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
