// The similarity of directions: Lai and Cheng 2006, equations 3 and 5. As |g x q|^2 = |g|^2 |q|^2 -
// (g.q)^2, each row's part of H is its weights' squares times the block |g|^2 I - g g'.
#include "interpolate/patch_energy.hpp"

namespace surpass {
namespace {

constexpr double kRegular = 0.09;     // share of the mean that regularises: 0.3 squared
constexpr double kVanishing = 1e-24;  // of the mean of |g|^2; below it g has no direction

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector times(std::span<const double> row, const Index* local, const double* x) {
  Vector sum = {};
  for (std::size_t b = 0; b < row.size(); ++b) {
    const double* p = x + std::size_t{3} * local[b];
    sum[0] += row[b] * p[0];
    sum[1] += row[b] * p[1];
    sum[2] += row[b] * p[2];
  }
  return sum;
}

int order_of(Derivative which) {
  switch (which) {
    case Derivative::first: return 0;
    case Derivative::third: return 2;
    default: return 1;
  }
}

// Sums of count |g|^2 and of count, by order.
struct Means {
  std::array<double, 3> squares = {};
  std::array<double, 3> counts = {};
  [[nodiscard]] double mean(int order) const {
    const auto at = static_cast<std::size_t>(order);
    return counts[at] > 0 ? squares[at] / counts[at] : 0;
  }
};

class CrossProducts final : public PatchEnergy {
 public:
  CrossProducts(const PatchLayout& layout, std::span<const double> reference, RowWeights weights,
                const Context& context)
      : layout_(layout), reference_(reference), weights_(weights) {
    find_means(context);
  }

  void product(const Context& context, std::size_t width, std::span<const double> x,
               std::span<double> y) const override;
  [[nodiscard]] std::size_t block_size() const override { return 6; }
  [[nodiscard]] std::vector<double> diagonal(const Context& context) const override;
  void for_blocks(std::size_t patch, const UseBlock& use) const override;

 private:
  void find_means(const Context& context);
  [[nodiscard]] double weight(const PatchKind& kind, std::size_t row, double square) const;
  [[nodiscard]] std::vector<double> local_points(const PatchLayout::Chunk& chunk,
                                                 std::span<const double> x) const;
  // use(row, g, w) for each row of the patch that has a weight.
  template <class Use>
  void for_rows(std::size_t patch, const Index* local, const double* reference, Use&& use) const {
    const PatchKind& kind = layout_.rows().kind(patch);
    for (std::size_t r = 0; r < kind.row_count(); ++r) {
      if (kind.derivative[r] == Derivative::mixed) continue;
      const auto row = kind.row(r);
      const Vector g = times(row, local, reference);
      const double w = weight(kind, r, dot(g, g));
      if (w > 0) use(row, g, w);
    }
  }

  const PatchLayout& layout_;
  std::span<const double> reference_;
  RowWeights weights_;
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
  if (weights_ == RowWeights::none) return;
  means_ = layout_.reduce(
      context, Means{},
      [&](const PatchLayout::Chunk& chunk) {
        Means sums;
        const auto reference = local_points(chunk, reference_);
        const Index* local = chunk.local;
        for (std::size_t p = chunk.first; p < chunk.last; ++p) {
          const PatchKind& kind = layout_.rows().kind(p);
          for (std::size_t r = 0; r < kind.row_count(); ++r) {
            if (kind.derivative[r] == Derivative::mixed) continue;
            const Vector g = times(kind.row(r), local, reference.data());
            const auto order = static_cast<std::size_t>(order_of(kind.derivative[r]));
            sums.squares[order] += kind.count[r] * dot(g, g);
            sums.counts[order] += kind.count[r];
          }
          local += kind.columns;
        }
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

double CrossProducts::weight(const PatchKind& kind, std::size_t row, double square) const {
  const double count = kind.count[row];
  const double first = means_.mean(0);
  const auto inverse = [&](double x) { return x > 0 ? count / x : 0.0; };
  switch (weights_) {
    case RowWeights::none: break;
    case RowWeights::unit: return square > kVanishing * first ? inverse(square) : 0;
    case RowWeights::order:
      return inverse(std::max(means_.mean(order_of(kind.derivative[row])), kVanishing * first));
    case RowWeights::regularised: return inverse(square + kRegular * first);
  }
  return count;
}

void CrossProducts::product(const Context& context, std::size_t, std::span<const double> x,
                            std::span<double> y) const {
  layout_.add_up(context, 3, y, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto reference = local_points(chunk, reference_);
    const auto own = local_points(chunk, x);
    const Index* local = chunk.local;
    for (std::size_t p = chunk.first; p < chunk.last; ++p) {
      for_rows(p, local, reference.data(), [&](auto row, const Vector& g, double w) {
        const Vector q = times(row, local, own.data());
        const double square = w * dot(g, g);
        const double along = w * dot(g, q);
        Vector stress;
        for (std::size_t c = 0; c < 3; ++c) stress[c] = square * q[c] - along * g[c];
        for (std::size_t b = 0; b < row.size(); ++b) {
          double* to = values.data() + std::size_t{3} * local[b];
          for (std::size_t c = 0; c < 3; ++c) to[c] += row[b] * stress[c];
        }
      });
      local += layout_.rows().kind(p).columns;
    }
  });
}

// The upper triangle of w (|g|^2 I - g g').
std::array<double, 6> block_of(const Vector& g, double w) {
  const double square = dot(g, g);
  return {w * (square - g[0] * g[0]), -w * g[0] * g[1], -w * g[0] * g[2],
          w * (square - g[1] * g[1]), -w * g[1] * g[2], w * (square - g[2] * g[2])};
}

std::vector<double> CrossProducts::diagonal(const Context& context) const {
  std::vector<double> sum(std::size_t{6} * layout_.control_count());
  layout_.add_up(context, 6, sum, [&](const PatchLayout::Chunk& chunk, std::span<double> values) {
    const auto reference = local_points(chunk, reference_);
    const Index* local = chunk.local;
    for (std::size_t p = chunk.first; p < chunk.last; ++p) {
      for_rows(p, local, reference.data(), [&](auto row, const Vector& g, double w) {
        const auto block = block_of(g, w);
        for (std::size_t b = 0; b < row.size(); ++b) {
          double* to = values.data() + std::size_t{6} * local[b];
          for (std::size_t c = 0; c < 6; ++c) to[c] += row[b] * row[b] * block[c];
        }
      });
      local += layout_.rows().kind(p).columns;
    }
  });
  return sum;
}

void CrossProducts::for_blocks(std::size_t patch, const UseBlock& use) const {
  const auto columns = layout_.rows().columns(patch);
  const std::size_t n = columns.size();
  std::vector<double> blocks(6 * n * n, 0.0);
  for_rows(patch, columns.data(), reference_.data(), [&](auto row, const Vector& g, double w) {
    const auto block = block_of(g, w);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        for (std::size_t c = 0; c < 6; ++c)
          blocks[6 * (a * n + b) + c] += row[a] * row[b] * block[c];
      }
    }
  });
  for (std::size_t k = 0; k < n * n; ++k) use(k / n, k % n, blocks.data() + 6 * k);
}

}  // namespace

std::unique_ptr<PatchEnergy> cross_products(const PatchLayout& layout,
                                            std::span<const double> reference, RowWeights weights,
                                            const Context& context) {
  return std::make_unique<CrossProducts>(layout, reference, weights, context);
}

}  // namespace surpass
