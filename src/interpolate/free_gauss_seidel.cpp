#include <optional>

#include <Eigen/SparseCore>

#include "interpolate/free_progress.hpp"
#include "interpolate/linear_constraints.hpp"

namespace surpass {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Entry = Eigen::Triplet<double>;

// The place of coefficient (i, j) of a symmetric block of 3 in its upper triangle.
constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

// Unknowns: numbers of the free points; with blocks of 3 each coordinate by itself.
class Assembly {
 public:
  Assembly(const FreeSystem& system, const PatchLayout& layout)
      : system_(system), layout_(layout), parts_(system.energy.block_size() == 1 ? 1 : 3) {}

  /// Nothing if the computation was cancelled meanwhile: it takes as long as many sweeps.
  [[nodiscard]] std::optional<Sparse> matrix() const {
    const Sparse h = energy();
    if (system_.context.cancelled()) return std::nullopt;
    const Sparse z = extension();
    return Sparse(z.transpose()) * h * z;
  }
  [[nodiscard]] std::size_t parts() const { return parts_; }

 private:
  [[nodiscard]] Sparse energy() const {
    Sparse sum(size(), size());
    std::vector<Entry> entries;
    const auto flush = [&] {
      Sparse part(size(), size());
      part.setFromTriplets(entries.begin(), entries.end());
      sum += part;
      entries.clear();
    };
    constexpr std::size_t kEntries = 20000000;
    constexpr Index kPatches = 256;
    bool cancelled = false;
    layout_.for_patches([&](Index p, std::span<const Index> columns) {
      if (p % kPatches == 0) cancelled = cancelled || system_.context.cancelled();
      if (cancelled) return;
      system_.energy.for_blocks(p, columns, [&](std::size_t a, std::size_t b, const double* block) {
        for (std::size_t i = 0; i < parts_; ++i) {
          for (std::size_t j = 0; j < parts_; ++j) {
            entries.emplace_back(number(columns[a], i), number(columns[b], j),
                                 block[parts_ == 1 ? 0 : kPlace[i][j]]);
          }
        }
      });
      if (entries.size() > kEntries) flush();
    });
    flush();
    return sum;
  }

  // Columns of dependent points stay empty, and so do then their rows of the matrix.
  [[nodiscard]] Sparse extension() const {
    std::vector<Entry> entries;
    const Elimination& elimination = system_.elimination;
    for (Index j = 0; j < elimination.control_count(); ++j) {
      if (!elimination.is_free(j)) continue;
      for (std::size_t c = 0; c < parts_; ++c)
        entries.emplace_back(number(j, c), number(j, c), 1.0);
    }
    for (Index i = 0; i < elimination.given_count(); ++i) {
      elimination.for_each_coefficient(i, [&](Index j, double coefficient) {
        for (std::size_t c = 0; c < parts_; ++c) {
          entries.emplace_back(number(elimination.dependent(i), c), number(j, c), coefficient);
        }
      });
    }
    Sparse z(size(), size());
    z.setFromTriplets(entries.begin(), entries.end());
    return z;
  }

  [[nodiscard]] int number(Index v, std::size_t part) const {
    return static_cast<int>(v * parts_ + part);
  }
  [[nodiscard]] int size() const { return number(system_.elimination.control_count(), 0); }

  const FreeSystem& system_;
  const PatchLayout& layout_;
  std::size_t parts_;
};

// One sweep: each unknown in turn takes the value at which its own equation holds. `gradient` is
// kept that of `change`, which takes as long as the sweep itself.
void sweep(const Sparse& matrix, std::size_t width, std::span<double> gradient,
           std::span<double> change) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const double diagonal = matrix.coeff(i, i);
    if (!(diagonal > 0)) continue;
    for (std::size_t c = 0; c < width; ++c) {
      const std::size_t at = static_cast<std::size_t>(i) * width + c;
      const double step = -gradient[at] / diagonal;
      change[at] += step;
      for (Sparse::InnerIterator k(matrix, i); k; ++k) {  // the matrix is symmetric
        gradient[static_cast<std::size_t>(k.col()) * width + c] += step * k.value();
      }
    }
  }
}

// y = matrix x.
void apply(const Sparse& matrix, std::size_t width, std::span<const double> x,
           std::span<double> y) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    double* to = &y[static_cast<std::size_t>(i) * width];
    std::fill_n(to, width, 0.0);
    for (Sparse::InnerIterator k(matrix, i); k; ++k) {
      const double* from = &x[static_cast<std::size_t>(k.col()) * width];
      for (std::size_t c = 0; c < width; ++c) to[c] += k.value() * from[c];
    }
  }
}

// A sweep leaves the constraints. So what it would do about the gradient's part along them is
// projected onto them, a direction in which the energy falls (the lower triangle of a positive
// matrix, and the projection of its transpose on the other side), and followed to where the energy
// is least. False if it leads nowhere.
bool constrained_sweep(const FreeSystem& system, const Sparse& matrix, std::size_t width,
                       std::span<double> gradient, std::span<double> change) {
  std::vector<double> direction(gradient.size(), 0.0);
  std::vector<double> image(gradient.begin(), gradient.end());
  sweep(matrix, width, image, direction);
  system.constraints->keep(direction);
  apply(matrix, width, direction, image);
  const double curvature = system.dot(direction, image);
  if (!(curvature > 0)) return false;
  const double step = -system.dot(direction, gradient) / curvature;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    change[i] += step * direction[i];
    gradient[i] += step * image[i];
  }
  system.constraints->clear(gradient);
  return true;
}

}  // namespace

FreeOutcome gauss_seidel(const FreeSystem& system, const PatchLayout& layout, const StopAt& stop,
                         std::span<double> gradient, std::span<double> change) {
  if (system.constraints != nullptr) system.constraints->clear(gradient);
  FreeProgress progress(system, stop, gradient);
  if (!progress.goes_on()) return std::move(progress).outcome();
  const Assembly assembly(system, layout);
  const auto assembled = assembly.matrix();
  if (!assembled) return {.cancelled = true};
  const std::size_t width = system.width / assembly.parts();
  while (progress.goes_on()) {
    const Sparse& matrix = *assembled;
    if (system.constraints == nullptr) {
      sweep(matrix, width, gradient, change);
    } else if (!constrained_sweep(system, matrix, width, gradient, change)) {
      break;  // nothing is left but what the energy does not see
    }
    progress.note(system.dot(gradient, gradient));
  }
  system.elimination.meet(system.context, system.width, {}, change);
  return std::move(progress).outcome();
}

}  // namespace surpass
