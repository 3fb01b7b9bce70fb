#include "interpolate/blocks.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace surpass {
namespace {

enum class Role : unsigned char { fixed, curve, surface };

// A curve vertex that looks at a surface vertex (through a dart, or while a semi-sharp crease
// fades) belongs to the surface, and so do the curve vertices that look at it in turn.
void demote_open_curves(const SparseRows& rows, std::vector<Role>& roles) {
  std::vector<Index> queue;
  for (Index v = 0; v < rows.row_count(); ++v) {
    if (roles[v] == Role::curve) queue.push_back(v);
  }
  while (!queue.empty()) {
    const Index v = queue.back();
    queue.pop_back();
    if (roles[v] != Role::curve) continue;
    const auto columns = rows.row_columns(v);
    const bool closed = std::none_of(columns.begin(), columns.end(),
                                     [&](Index w) { return roles[w] == Role::surface; });
    if (closed) continue;
    roles[v] = Role::surface;
    for (const Index w : columns) {
      if (roles[w] == Role::curve) queue.push_back(w);
    }
  }
}

Block collect(const LimitOperator& op, const std::vector<Role>& roles, Role role) {
  Block block;
  for (Index v = 0; v < op.rows.row_count(); ++v) {
    if (roles[v] != role) continue;
    block.vertices.push_back(v);
    block.lowest = std::min(block.lowest, op.lowest_eigenvalue[v]);
    // Curve rows inside the surface block break its symmetry: their neighbours do not answer.
    const bool symmetric =
        op.symmetric_weight[v] > 0 && (op.on_curve[v] != 0) == (role == Role::curve);
    if (!symmetric) block.symmetric = false;
    if (block.obstacle == kNone && (!symmetric || op.lowest_eigenvalue[v] <= 0)) block.obstacle = v;
  }
  return block;
}

}  // namespace

Result<Blocks> find_blocks(const LimitOperator& op, const std::vector<Index>& only) {
  const Index n = op.rows.row_count();
  std::vector<unsigned char> listed(n, only.empty() ? 1 : 0);
  for (const Index v : only) {
    if (v >= n) {
      return fail(
          ErrorCode::invalid_argument,
          fmt::format("the list of vertices to interpolate names {}, but there are {}", v, n),
          {.vertex = v});
    }
    listed[v] = 1;
  }
  std::vector<Role> roles(n, Role::fixed);
  Blocks blocks;
  for (Index v = 0; v < n; ++v) {
    if (listed[v] == 0) continue;
    ++blocks.interpolated;
    const bool own_limit = op.rows.row_columns(v).size() == 1;
    if (!own_limit) roles[v] = op.on_curve[v] != 0 ? Role::curve : Role::surface;
  }
  demote_open_curves(op.rows, roles);
  blocks.curve = collect(op, roles, Role::curve);
  blocks.surface = collect(op, roles, Role::surface);
  return blocks;
}

}  // namespace surpass
