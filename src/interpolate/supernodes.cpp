#include "interpolate/supernodes.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/OrderingMethods>

namespace surpass {
namespace {

using Ints = std::vector<int>;

// The columns in the order in which minimum degree takes them.
Ints by_minimum_degree(const Symmetric& matrix) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(matrix, order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

Ints inverse_of(const Ints& order) {
  Ints place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[to_size(order[k])] = static_cast<int>(k);
  return place;
}

// use(k, i) for the entries above the diagonal, column k after column k, of the matrix in order.
template <class Use>
void for_upper(const Symmetric& matrix, const Ints& order, const Ints& place, Use&& use) {
  for (int k = 0; k < static_cast<int>(order.size()); ++k) {
    for (Symmetric::InnerIterator entry(matrix, order[to_size(k)]); entry; ++entry) {
      const int i = place[to_size(entry.row())];
      if (i < k) use(k, i);
    }
  }
}

// The elimination tree: the parent of a column is the first row below its diagonal, or -1.
// Liu, A compact row storage scheme for Cholesky factors using elimination trees, 1986.
Ints elimination_tree(const Symmetric& matrix, const Ints& order, const Ints& place) {
  Ints parent(order.size(), -1);
  Ints ancestor(order.size(), -1);
  for_upper(matrix, order, place, [&](int k, int i) {
    while (i != -1 && i != k) {
      const int next = std::exchange(ancestor[to_size(i)], k);
      if (next == -1) parent[to_size(i)] = k;
      i = next;
    }
  });
  return parent;
}

// Columns such that each subtree is together, children before their parent.
Ints by_subtrees(const Ints& parent) {
  Ints first_child(parent.size(), -1);
  Ints next_child(parent.size(), -1);
  Ints open;
  for (int k = static_cast<int>(parent.size()) - 1; k >= 0; --k) {
    if (parent[to_size(k)] == -1) {
      open.push_back(k);
    } else {
      next_child[to_size(k)] = std::exchange(first_child[to_size(parent[to_size(k)])], k);
    }
  }
  Ints order;
  order.reserve(parent.size());
  while (!open.empty()) {
    const int k = open.back();
    if (const int child = first_child[to_size(k)]; child != -1) {
      first_child[to_size(k)] = next_child[to_size(child)];
      open.push_back(child);
    } else {
      order.push_back(k);
      open.pop_back();
    }
  }
  return order;
}

// Entries of each column of the factor, without the diagonal.
Ints column_counts(const Symmetric& matrix, const Ints& order, const Ints& place,
                   const Ints& parent) {
  Ints counts(order.size(), 0);
  Ints seen(order.size(), -1);
  for_upper(matrix, order, place, [&](int k, int i) {
    seen[to_size(k)] = k;
    for (; seen[to_size(i)] != k; i = parent[to_size(i)]) {
      seen[to_size(i)] = k;
      ++counts[to_size(i)];
    }
  });
  return counts;
}

struct Columns {
  int first;
  int width;
  int below;         // rows
  double zeros = 0;  // that joining added

  [[nodiscard]] double size() const {
    return width * (width + 1.0) / 2 + static_cast<double>(width) * below;
  }
};

// Whether the columns before those of `last` join them. Their rows are among those of `last`.
bool join(const Columns& before, Columns& last) {
  constexpr int kNarrow = 16;  // columns: to visit them costs more than zeros among them
  constexpr double kOfNarrow = 0.5;
  constexpr double kOfWide = 0.1;
  Columns both{before.first, before.width + last.width, last.below};
  both.zeros = both.size() - (before.size() - before.zeros) - (last.size() - last.zeros);
  if (both.zeros > (both.width <= kNarrow ? kOfNarrow : kOfWide) * both.size()) return false;
  last = both;
  return true;
}

// Columns whose rows are the same, and those that may join.
std::vector<Columns> together(const Ints& parent, const Ints& counts) {
  std::vector<Columns> found;
  const int size = static_cast<int>(parent.size());
  for (int k = 0; k < size;) {
    Columns last{k, 1, counts[to_size(k)]};
    while (k + last.width < size && last.below > 0) {
      const int next = k + last.width;
      if (parent[to_size(next - 1)] != next || counts[to_size(next)] != last.below - 1) break;
      ++last.width;
      --last.below;
    }
    k += last.width;
    while (!found.empty() && parent[to_size(last.first - 1)] != -1 &&
           parent[to_size(last.first - 1)] < k && join(found.back(), last)) {
      found.pop_back();
    }
    found.push_back(last);
  }
  return found;
}

// The rows of all supernodes, from the matrix and from those that each is the parent of.
void find_rows(const Symmetric& matrix, const Ints& parent_column, Supernodes& found) {
  Ints of_column(found.order.size());
  for (int s = 0; s < found.count(); ++s) {
    std::fill_n(of_column.begin() + found.first[to_size(s)], found.width(s), s);
  }
  Ints first_child(to_size(found.count()), -1);
  Ints next_child(to_size(found.count()), -1);
  Ints seen(found.order.size(), -1);
  found.start = {0};
  for (int s = 0; s < found.count(); ++s) {
    const int end = found.first[to_size(s) + 1];
    const auto add = [&](int i) {
      if (i >= end && std::exchange(seen[to_size(i)], s) != s) found.row.push_back(i);
    };
    for (int k = found.first[to_size(s)]; k < end; ++k) {
      for (Symmetric::InnerIterator entry(matrix, found.order[to_size(k)]); entry; ++entry) {
        add(found.place[to_size(entry.row())]);
      }
    }
    for (int child = first_child[to_size(s)]; child != -1; child = next_child[to_size(child)]) {
      for (std::size_t r = found.start[to_size(child)]; r < found.start[to_size(child) + 1]; ++r) {
        add(found.row[r]);
      }
    }
    std::sort(found.row.begin() + static_cast<std::ptrdiff_t>(found.start.back()), found.row.end());
    found.start.push_back(found.row.size());
    const int above = parent_column[to_size(end - 1)];
    if (above == -1) continue;
    found.parent[to_size(s)] = of_column[to_size(above)];
    next_child[to_size(s)] = std::exchange(first_child[to_size(of_column[to_size(above)])], s);
  }
}

}  // namespace

Supernodes find_supernodes(const Symmetric& matrix) {
  const Ints least = by_minimum_degree(matrix);
  Supernodes found;
  // The tree first tells the order, then is that of the columns in this order.
  for (const int k : by_subtrees(elimination_tree(matrix, least, inverse_of(least)))) {
    found.order.push_back(least[to_size(k)]);
  }
  found.place = inverse_of(found.order);
  const Ints parent = elimination_tree(matrix, found.order, found.place);
  const Ints counts = column_counts(matrix, found.order, found.place, parent);
  for (const Columns& c : together(parent, counts)) found.first.push_back(c.first);
  found.parent.assign(found.first.size(), -1);
  found.first.push_back(static_cast<int>(found.order.size()));
  find_rows(matrix, parent, found);
  return found;
}

}  // namespace surpass
