// The similarity of directions: Lai and Cheng 2006, equations 3 and 5. As |g x q|^2 = |g|^2 |q|^2 -
// (g.q)^2, each row's part of H is its weights' squares times the block |g|^2 I - g g'. Nothing is
// kept of the reference's derivatives g: they are two gigabytes at a million faces, and reading
// them takes about as long as computing them again.
#include <algorithm>
#include <array>
#include <memory>

#include "interpolate/cross_kernels.hpp"
#include "interpolate/lane_points.hpp"
#include "interpolate/patch_energy.hpp"

namespace surpass {
namespace {

constexpr double kRegular = 0.09;     // share of the mean that regularises: 0.3 squared
constexpr double kVanishing = 1e-24;  // of the mean of |g|^2; below it g has no direction

// Sums of count |g|^2 and of count, by order.
struct Means {
  std::array<double, 3> squares = {};
  std::array<double, 3> counts = {};
  [[nodiscard]] double mean(std::size_t order) const {
    return counts[order] > 0 ? squares[order] / counts[order] : 0;
  }
};

using Law = RowLaw<double>;

Law law_of(RowWeights weights, const CrossKind::Row& row, const Means& means) {
  const double first = means.mean(0);
  switch (weights) {
    case RowWeights::none: break;
    case RowWeights::unit: return {row.count, 1, 0, kVanishing * first};
    case RowWeights::order: {
      const double mean = std::max(means.mean(row.order), kVanishing * first);
      return {mean > 0 ? row.count / mean : 0};
    }
    case RowWeights::regularised:
      if (!(first > 0)) return {};
      return {row.count / (kRegular * first), 1 / (kRegular * first), 1};
  }
  return {row.count};
}

// Whether what matters is how long derivatives are, and not each direction by itself. Third
// derivatives of fine meshes are less than what single precision makes of the points.
bool sees_lengths(RowWeights weights) {
  return weights == RowWeights::none || weights == RowWeights::regularised;
}

RowLaw<float> in_single_precision(const Law& law) {
  const auto round = [](double x) { return static_cast<float>(x); };
  return {round(law.numerator), round(law.slope), round(law.constant), round(law.threshold)};
}

// Their places in it are written before they are read, so zeros would be for nothing.
template <class T>
std::unique_ptr<T[]> room_for(std::size_t count) {
  return std::make_unique_for_overwrite<T[]>(count);
}

class CrossProducts final : public PatchEnergy {
 public:
  CrossProducts(const PatchLayout& layout, std::span<const double> reference, RowWeights weights,
                const Context& context);

  double product(const Context& context, std::size_t, Precision precision,
                 std::span<const double> x, std::span<double> y) const override {
    return precision == Precision::single && may_be_single_ ? product_in<float>(context, x, y)
                                                            : product_in<double>(context, x, y);
  }
  [[nodiscard]] std::size_t block_size() const override { return 6; }
  [[nodiscard]] std::vector<double> diagonal(const Context& context) const override {
    return diagonal_in<double>(context);
  }
  [[nodiscard]] std::vector<float> diagonal_in_single(const Context& context) const override {
    return may_be_single_ ? diagonal_in<float>(context) : std::vector<float>{};
  }
  void for_blocks(std::size_t patch, std::span<const Index> columns,
                  const UseBlock& use) const override;

 private:
  [[nodiscard]] Means means(const Context& context) const;
  template <class Real>
  double product_in(const Context& context, std::span<const double> x, std::span<double> y) const;
  template <class Real>
  [[nodiscard]] std::vector<Real> diagonal_in(const Context& context) const;
  template <class Real>
  [[nodiscard]] const RowLaw<Real>* laws_in(Index kind) const {
    if constexpr (kIsSingle<Real>)
      return single_laws_[kind].data();
    else
      return scaled_laws_[kind].data();
  }
  [[nodiscard]] const double* reference_of(const PatchLayout::Chunk& chunk) const {
    return local_reference_.data() + kPointStride * chunk.start;
  }

  const PatchLayout& layout_;
  bool may_be_single_;
  std::span<const double> reference_;
  std::vector<double> local_reference_;  // of the points of all chunks, kPointStride apart
  std::vector<CrossKind> kinds_;
  // Of each kind.
  std::vector<std::vector<Law>> laws_;
  std::vector<std::vector<Law>> scaled_laws_;
  std::vector<std::vector<RowLaw<float>>> single_laws_;  // the same, rounded
  std::size_t most_columns_ = 0;
  std::size_t most_rows_ = 0;
  std::size_t most_places_ = 0;
};

CrossProducts::CrossProducts(const PatchLayout& layout, std::span<const double> reference,
                             RowWeights weights, const Context& context)
    : layout_(layout),
      may_be_single_(sees_lengths(weights)),
      reference_(reference),
      local_reference_(kPointStride * layout.point_count()) {
  layout.for_chunks(context, [&](const PatchLayout::Chunk& chunk, std::size_t) {
    chunk.copy_to(3, kPointStride, reference, &local_reference_[kPointStride * chunk.start]);
  });
  for (const PatchKind& kind : layout.rows().kinds()) {
    kinds_.emplace_back(kind);
    most_columns_ = std::max(most_columns_, kinds_.back().columns);
    most_rows_ = std::max(most_rows_, kinds_.back().rows.size());
    most_places_ = std::max(most_places_, kinds_.back().work_size());
  }
  const Means found = weights == RowWeights::none ? Means{} : means(context);
  for (const CrossKind& kind : kinds_) {
    auto& laws = laws_.emplace_back();
    for (const CrossKind::Row& row : kind.rows) laws.push_back(law_of(weights, row, found));
    scaled_laws_.push_back(scaled_laws(kind, laws));
    auto& rounded = single_laws_.emplace_back();
    for (const Law& law : scaled_laws_.back()) rounded.push_back(in_single_precision(law));
  }
}

Means CrossProducts::means(const Context& context) const {
  return layout_.reduce(
      context, Means{},
      [&](const PatchLayout::Chunk& chunk) {
        Means sums;
        const double* const reference = reference_of(chunk);
        const auto points = room_for<LaneVectors<double>>(most_columns_);
        const auto squares = room_for<LaneNumbers>(most_rows_);
        const auto places = room_for<LaneVectors<double>>(most_places_);
        layout_.for_groups<kLanes<double>>(
            chunk, [&](Index number, const LocalIndex* local, std::size_t lanes) {
              const CrossKind& kind = kinds_[number];
              gather_points(local, kind.columns, lanes, reference, points.get());
              squares_of_patches(kind, points.get(), squares.get(), places.get());
              for (std::size_t r = 0; r < kind.rows.size(); ++r) {
                const CrossKind::Row& row = kind.rows[r];
                double sum = 0;
                for (std::size_t l = 0; l < lanes; ++l) sum += squares[r].value[l];
                sums.squares[row.order] += row.count * row.scale * row.scale * sum;
                sums.counts[row.order] += row.count * static_cast<double>(lanes);
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

template <class Real>
double CrossProducts::product_in(const Context& context, std::span<const double> x,
                                 std::span<double> y) const {
  const auto work = [&](const PatchLayout::Chunk& chunk, std::span<Real> values) {
    const double* const reference = reference_of(chunk);
    const std::size_t size = kPointStride * chunk.points.size();
    const auto own = std::make_unique_for_overwrite<double[]>(size);
    chunk.copy_to(3, kPointStride, x, own.get());
    const auto at_reference = room_for<LaneVectors<Real>>(most_columns_);
    const auto at_x = room_for<LaneVectors<Real>>(most_columns_);
    const auto sums = room_for<LaneVectors<Real>>(most_columns_);
    const auto places = room_for<LaneVectors<Real>>(most_places_);
    layout_.for_groups<kLanes<Real>>(
        chunk, [&](Index number, const LocalIndex* local, std::size_t lanes) {
          const CrossKind& kind = kinds_[number];
          gather_points(local, kind.columns, lanes, reference, at_reference.get());
          gather_points(local, kind.columns, lanes, own.get(), at_x.get());
          gradient_of_patches(kind, laws_in<Real>(number), at_reference.get(), at_x.get(),
                              sums.get(), places.get());
          scatter_points(local, kind.columns, lanes, sums.get(), values.data());
        });
    return dot_of_points(std::span<const double>(own.get(), size), std::span<const Real>(values));
  };
  return layout_.add_up<Real>(context, 3, kPointStride, y, work);
}

template <class Real>
std::vector<Real> CrossProducts::diagonal_in(const Context& context) const {
  std::vector<Real> sum(std::size_t{6} * layout_.control_count());
  layout_.add_up<Real>(
      context, 6, 6, std::span(sum), [&](const PatchLayout::Chunk& chunk, std::span<Real> values) {
        const double* const reference = reference_of(chunk);
        const auto points = room_for<LaneVectors<Real>>(most_columns_);
        const auto sums = room_for<LaneBlock<Real>>(most_columns_);
        const auto places = room_for<LaneVectors<Real>>(most_places_);
        layout_.for_groups<kLanes<Real>>(chunk, [&](Index number, const LocalIndex* local,
                                                    std::size_t lanes) {
          const CrossKind& kind = kinds_[number];
          gather_points(local, kind.columns, lanes, reference, points.get());
          diagonal_of_patches(kind, laws_in<Real>(number), points.get(), sums.get(), places.get());
          for (std::size_t l = 0; l < lanes; ++l) {
            for (std::size_t c = 0; c < kind.columns; ++c) {
              Real* to = values.data() + std::size_t{6} * local[l * kind.columns + c];
              for (std::size_t k = 0; k < 6; ++k) to[k] += sums[c].of[k][l];
            }
          }
        });
        return 0;
      });
  return sum;
}

void CrossProducts::for_blocks(std::size_t patch, std::span<const Index> columns,
                               const UseBlock& use) const {
  const Index number = layout_.rows().kind_number(patch);
  const CrossKind& kind = kinds_[number];
  const std::size_t n = kind.columns;
  std::vector<double> blocks(6 * n * n, 0.0);
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    const CrossKind::Row& row = kind.rows[r];
    std::array<double, 3> g = {};
    for (std::size_t i = row.begin; i < row.end; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        g[c] += kind.weight[i] * reference_[std::size_t{3} * columns[kind.column[i]] + c];
      }
    }
    const double square = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    const Law& law = laws_[number][r];
    if (!(square > law.threshold)) continue;
    const double w = law.numerator / (law.slope * square + law.constant);
    const std::array<double, 6> block = {w * (square - g[0] * g[0]), -w * g[0] * g[1],
                                         -w * g[0] * g[2],           w * (square - g[1] * g[1]),
                                         -w * g[1] * g[2],           w * (square - g[2] * g[2])};
    for (std::size_t i = row.begin; i < row.end; ++i) {
      for (std::size_t j = row.begin; j < row.end; ++j) {
        double* to = &blocks[6 * (kind.column[i] * n + kind.column[j])];
        for (std::size_t c = 0; c < 6; ++c) to[c] += kind.weight[i] * kind.weight[j] * block[c];
      }
    }
  }
  for (std::size_t k = 0; k < n * n; ++k) {
    const double* block = blocks.data() + 6 * k;
    if (std::any_of(block, block + 6, [](double b) { return b != 0; })) use(k / n, k % n, block);
  }
}

}  // namespace

std::unique_ptr<PatchEnergy> cross_products(const PatchLayout& layout,
                                            std::span<const double> reference, RowWeights weights,
                                            const Context& context) {
  return std::make_unique<CrossProducts>(layout, reference, weights, context);
}

}  // namespace surpass
