#include "interpolate/sparse_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Dense>

namespace surpass {
namespace {

using Dense = Eigen::MatrixXd;
using DenseBlock = Eigen::Ref<Dense, 0, Eigen::OuterStride<>>;
using ConstDense = Eigen::Map<const Dense>;

bool is_pivot(double x) { return std::isfinite(x) && x != 0; }

// The lower triangle becomes L below its diagonal and D on it.
bool decompose_small(double shift, DenseBlock a) {
  const Eigen::Index n = a.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    if (a(k, k) == 0) a(k, k) = shift;
    if (!is_pivot(a(k, k))) return false;
    const Eigen::Index rest = n - k - 1;
    for (Eigen::Index j = k + 1; j < n; ++j) {
      a.col(j).tail(n - j) -= a(j, k) / a(k, k) * a.col(k).tail(n - j);
    }
    a.col(k).tail(rest) /= a(k, k);
  }
  return true;
}

// The same for the first `width` columns, whose part is taken from the other columns.
bool decompose(double shift, Eigen::Index width, const Context& context, DenseBlock a) {
  constexpr Eigen::Index kStep = 64;
  Dense scaled;
  for (Eigen::Index k = 0; k < width; k += kStep) {
    if (context.cancelled()) return false;
    const Eigen::Index step = std::min(kStep, width - k);
    const Eigen::Index rest = a.rows() - k - step;
    auto corner = a.block(k, k, step, step);
    if (!decompose_small(shift, corner)) return false;
    if (rest == 0) break;
    auto below = a.block(k + step, k, rest, step);
    corner.triangularView<Eigen::UnitLower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    scaled = below;  // L times D
    below.array().rowwise() /= corner.diagonal().transpose().array();
    a.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>() -= scaled * below.transpose();
  }
  return true;
}

// Of each supernode what the matrix and the supernodes before say of its columns, and what these
// change of the columns of its rows. There is one from the first supernode that adds to it.
class Fronts {
 public:
  Fronts(const Symmetric& matrix, double shift, const Supernodes& nodes)
      : matrix_(matrix), shift_(shift), nodes_(nodes), fronts_(to_size(nodes.count())) {}

  Dense take(int s) { return std::move(begun(s)); }

  /// What the columns of a supernode take from others goes to its parent.
  void pass_on(int s, const Dense& front) {
    const int parent = nodes_.parent[to_size(s)];
    if (parent == -1) return;
    Dense& to = begun(parent);
    const auto rows = nodes_.rows(s);
    std::vector<Eigen::Index> there;
    for (const int row : rows) there.push_back(number(parent, row));
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const auto own = nodes_.width(s) + static_cast<Eigen::Index>(c);
      const double* const from = &front(own, own);
      double* const column = to.data() + to.rows() * there[c];
      for (std::size_t r = c; r < rows.size(); ++r) column[there[r]] += from[r - c];
    }
  }

 private:
  // Of a column among those of a supernode's front.
  [[nodiscard]] Eigen::Index number(int s, int column) const {
    const int width = nodes_.width(s);
    const int from_first = column - nodes_.first[to_size(s)];
    if (from_first < width) return from_first;
    const auto rows = nodes_.rows(s);
    return width + (std::lower_bound(rows.begin(), rows.end(), column) - rows.begin());
  }

  Dense& begun(int s) {
    Dense& front = fronts_[to_size(s)];
    if (front.size() > 0) return front;
    const int width = nodes_.width(s);
    const int first = nodes_.first[to_size(s)];
    const auto size = width + static_cast<Eigen::Index>(nodes_.rows(s).size());
    front.setZero(size, size);
    for (int k = 0; k < width; ++k) {
      for (Symmetric::InnerIterator entry(matrix_, nodes_.order[to_size(first + k)]); entry;
           ++entry) {
        const int i = nodes_.place[to_size(entry.row())];
        if (i >= first + k) front(number(s, i), k) += entry.value();
      }
      front(k, k) += shift_;
    }
    return front;
  }

  const Symmetric& matrix_;
  double shift_;
  const Supernodes& nodes_;
  std::vector<Dense> fronts_;
};

}  // namespace

bool SparseCholesky::compute(const Symmetric& matrix, double shift, const Context& context) {
  nodes_ = find_supernodes(matrix);
  start_ = {0};
  for (int s = 0; s < nodes_.count(); ++s) {
    const std::size_t width = to_size(nodes_.width(s));
    start_.push_back(start_.back() + width * (width + nodes_.rows(s).size()));
  }
  values_.resize(start_.back());
  Fronts fronts(matrix, shift, nodes_);
  for (int s = 0; s < nodes_.count(); ++s) {
    Dense front = fronts.take(s);
    const Eigen::Index width = nodes_.width(s);
    if (!decompose(shift, width, context, front)) return false;
    std::copy_n(front.data(), start_[to_size(s) + 1] - start_[to_size(s)],
                &values_[start_[to_size(s)]]);
    fronts.pass_on(s, front);
    context.report({.stage = "decompose",
                    .fraction = static_cast<double>(start_[to_size(s) + 1]) /
                                static_cast<double>(start_.back())});
  }
  return true;
}

Eigen::VectorXd SparseCholesky::pivots() const {
  Eigen::VectorXd in_order(static_cast<Eigen::Index>(nodes_.place.size()));
  for (int s = 0; s < nodes_.count(); ++s) {
    const std::size_t width = to_size(nodes_.width(s));
    const std::size_t length = width + nodes_.rows(s).size();
    for (std::size_t k = 0; k < width; ++k) {
      in_order[nodes_.first[to_size(s)] + static_cast<int>(k)] =
          values_[start_[to_size(s)] + k * (length + 1)];
    }
  }
  Eigen::VectorXd pivots(in_order.size());
  for (Eigen::Index i = 0; i < pivots.size(); ++i) pivots[i] = in_order[nodes_.place[to_size(i)]];
  return pivots;
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right) const {
  if (right.size() == 0) return right;
  Dense x(right.rows(), right.cols());
  for (Eigen::Index i = 0; i < x.rows(); ++i) x.row(nodes_.place[to_size(i)]) = right.row(i);
  Dense below;
  // step(the columns of a supernode, their upper part, the rows below, what x has for the columns)
  const auto use = [&](int s, auto&& step) {
    const auto rows = nodes_.rows(s);
    const Eigen::Index width = nodes_.width(s);
    const auto size = static_cast<Eigen::Index>(rows.size());
    const ConstDense columns(&values_[start_[to_size(s)]], width + size, width);
    auto own = x.middleRows(nodes_.first[to_size(s)], width);
    below.resize(size, x.cols());
    step(columns, columns.topRows(width).triangularView<Eigen::UnitLower>(), rows, own);
  };
  for (int s = 0; s < nodes_.count(); ++s) {
    use(s, [&](const auto& columns, const auto& corner, auto rows, auto& own) {
      corner.solveInPlace(own);
      if (rows.empty()) return;
      below.noalias() = columns.bottomRows(below.rows()) * own;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        x.row(rows[r]) -= below.row(static_cast<Eigen::Index>(r));
      }
    });
  }
  for (int s = nodes_.count() - 1; s >= 0; --s) {
    use(s, [&](const auto& columns, const auto& corner, auto rows, auto& own) {
      for (std::size_t r = 0; r < rows.size(); ++r) {
        below.row(static_cast<Eigen::Index>(r)) = x.row(rows[r]);
      }
      own.array().colwise() /= columns.diagonal().array();
      if (!rows.empty()) own.noalias() -= columns.bottomRows(below.rows()).transpose() * below;
      corner.transpose().solveInPlace(own);
    });
  }
  Dense solution(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < x.rows(); ++i) solution.row(i) = x.row(nodes_.place[to_size(i)]);
  return solution;
}

bool SparseCholesky::is_accurate(const Symmetric& matrix) const {
  constexpr double kDigits = 1e-8;
  // Anything that no eigenvector is orthogonal to.
  const auto scattered = [](Eigen::Index i) {
    return static_cast<double>(static_cast<std::uint32_t>(i) * 2654435761U) / 4294967296.0 - 0.5;
  };
  const Eigen::VectorXd right = Eigen::VectorXd::NullaryExpr(matrix.rows(), scattered);
  return (right - matrix * solve(right)).norm() <= kDigits * right.norm();
}

}  // namespace surpass
