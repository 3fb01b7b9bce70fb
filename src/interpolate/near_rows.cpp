#include "interpolate/near_rows.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mesh/disjoint_sets.hpp"
#include "parallel/parallel.hpp"

namespace surpass {
namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double kRounding = 1e-15;  // of rows of length 1

// What the independent rows leave of each.
Rows remainders(const Rows& rows, std::span<const DependentRow> near) {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rest(rows.cols());
  for (std::size_t i = 0; i < near.size(); ++i) {
    rest = rows.row(near[i].row).transpose();
    for (const auto& [other, share] : near[i].shares) rest -= share * rows.row(other).transpose();
    for (Eigen::Index k = 0; k < rest.size(); ++k) {
      if (std::abs(rest[k]) > kRounding) {
        entries.emplace_back(static_cast<int>(i), static_cast<int>(k), rest[k]);
      }
    }
  }
  Rows left(static_cast<Eigen::Index>(near.size()), rows.cols());
  left.setFromTriplets(entries.begin(), entries.end());
  return left;
}

// Rows that have to do with each other, by way of others too.
std::vector<std::vector<Eigen::Index>> connected(const Rows& rows) {
  DisjointSets sets(static_cast<Index>(rows.rows()));
  std::map<Eigen::Index, Index> first_with;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Rows::InnerIterator k(rows, i); k; ++k) {
      sets.unite(static_cast<Index>(i),
                 first_with.emplace(k.col(), static_cast<Index>(i)).first->second);
    }
  }
  std::map<Index, std::vector<Eigen::Index>> parts;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    parts[sets.find(static_cast<Index>(i))].push_back(i);
  }
  std::vector<std::vector<Eigen::Index>> lists;
  lists.reserve(parts.size());
  for (auto& [smallest, list] : parts) lists.push_back(std::move(list));
  return lists;
}

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Matrix dense(const Rows& rows, const std::vector<Eigen::Index>& which) {
  std::map<Eigen::Index, Eigen::Index> place;
  for (const Eigen::Index i : which) {
    for (Rows::InnerIterator k(rows, i); k; ++k) {
      place.emplace(k.col(), static_cast<Eigen::Index>(place.size()));
    }
  }
  Matrix part = Matrix::Zero(static_cast<Eigen::Index>(which.size()),
                             static_cast<Eigen::Index>(place.size()));
  for (std::size_t i = 0; i < which.size(); ++i) {
    for (Rows::InnerIterator k(rows, which[i]); k; ++k) {
      part(static_cast<Eigen::Index>(i), place[k.col()]) = k.value();
    }
  }
  return part;
}

// Rows of which each is made orthogonal to those that are taken, and the sums of the rows as they
// came that they are now.
class GramSchmidt {
 public:
  explicit GramSchmidt(Matrix rows)
      : rest_(std::move(rows)),
        sums_(Matrix::Identity(rest_.rows(), rest_.rows())),
        length_(rest_.rowwise().norm()),
        open_(Eigen::VectorXd::Ones(rest_.rows())) {}

  // The longest of those that are not taken, unless it is nothing.
  [[nodiscard]] std::optional<Eigen::Index> longest() const {
    Eigen::Index at = 0;
    if (length_.cwiseProduct(open_).maxCoeff(&at) <= kDependent) return std::nullopt;
    return at;
  }

  void take(Eigen::Index at, const Context& context) {
    open_[at] = 0;
    const Eigen::RowVectorXd direction = rest_.row(at) / length_[at];
    const Eigen::RowVectorXd sum = sums_.row(at) / length_[at];
    constexpr std::size_t kRowsATask = 64;
    parallel::for_ranges(
        context, static_cast<std::size_t>(rest_.rows()),
        [&](std::size_t begin, std::size_t end) {
          for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i) {
            if (open_[i] != 0) clear(i, direction, sum);
          }
        },
        kRowsATask);
  }

  [[nodiscard]] bool is_taken(Eigen::Index at) const { return open_[at] == 0; }
  [[nodiscard]] double length(Eigen::Index at) const { return length_[at]; }
  [[nodiscard]] double sum(Eigen::Index at, Eigen::Index of) const { return sums_(at, of); }

 private:
  void clear(Eigen::Index i, const Eigen::RowVectorXd& direction, const Eigen::RowVectorXd& sum) {
    const double along = rest_.row(i).dot(direction);
    if (along == 0) return;
    rest_.row(i) -= along * direction;
    sums_.row(i) -= along * sum;
    length_[i] = rest_.row(i).norm();
  }

  Matrix rest_;
  Matrix sums_;
  Eigen::VectorXd length_;
  Eigen::VectorXd open_;  // 1, or 0 where taken
};

// `which`: the numbers, in `near`, of the rows that were orthogonalised. `shares`: 0 for every row,
// as it is left.
DependentRow expressed_by(const GramSchmidt& rests, Eigen::Index at,
                          const std::vector<Eigen::Index>& which,
                          std::span<const DependentRow> near, std::vector<double>& shares) {
  const auto share_of = [&](int row) -> double& { return shares[static_cast<std::size_t>(row)]; };
  for (std::size_t k = 0; k < which.size(); ++k) {
    const DependentRow& other = near[static_cast<std::size_t>(which[k])];
    const double w = rests.sum(at, static_cast<Eigen::Index>(k));
    if (w == 0) continue;
    for (const auto& [row, share] : other.shares) share_of(row) += w * share;
    if (static_cast<Eigen::Index>(k) != at) share_of(other.row) -= w;
  }
  DependentRow result{near[static_cast<std::size_t>(which[static_cast<std::size_t>(at)])].row,
                      rests.length(at),
                      {}};
  for (std::size_t row = 0; row < shares.size(); ++row) {
    if (shares[row] == 0) continue;
    result.shares.emplace_back(static_cast<int>(row), shares[row]);
    shares[row] = 0;
  }
  return result;
}

}  // namespace

NearRows near_rows(const Rows& rows, std::span<const DependentRow> near, const Context& context) {
  NearRows result;
  const Rows left = remainders(rows, near);
  std::vector<double> shares(static_cast<std::size_t>(rows.rows()), 0.0);
  for (const std::vector<Eigen::Index>& which : connected(left)) {
    GramSchmidt rests(dense(left, which));
    std::optional<Eigen::Index> next;
    while (!context.cancelled() && (next = rests.longest())) rests.take(*next, context);
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(which.size()); ++i) {
      (rests.is_taken(i) ? result.kept : result.dropped)
          .push_back(expressed_by(rests, i, which, near, shares));
    }
  }
  return result;
}

}  // namespace surpass
