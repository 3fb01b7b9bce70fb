#include "interpolate/blocks.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "mesh/disjoint_sets.hpp"

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

Block describe_block(const LimitOperator& op, std::vector<Index> vertices, Role role) {
  Block block;
  block.vertices = std::move(vertices);
  double sum = 0;
  bool anchored = false;  // some row of its own keeps the block from being singular
  for (const Index v : block.vertices) {
    // Curve rows inside the surface block break its symmetry: their neighbours do not answer.
    const bool symmetric =
        op.symmetric_weight[v] > 0 && (op.on_curve[v] != 0) == (role == Role::curve);
    const double lowest = op.lowest_eigenvalue[v];
    sum += lowest;
    if (symmetric) block.lowest = std::min(block.lowest, lowest);
    if (symmetric && lowest > 0) anchored = true;
    if (!symmetric) block.symmetric = false;
    if (block.obstacle == kNone && (!symmetric || lowest <= 0)) block.obstacle = v;
  }
  if (!block.vertices.empty()) block.mean_lowest = sum / static_cast<double>(block.vertices.size());
  block.suspect = !block.proven() && (!anchored || block.lowest < 0);
  return block;
}

std::vector<Index> with_role(const std::vector<Role>& roles, Role role) {
  std::vector<Index> vertices;
  vertices.reserve(static_cast<std::size_t>(std::count(roles.begin(), roles.end(), role)));
  for (std::size_t v = 0; v < roles.size(); ++v) {
    if (roles[v] == role) vertices.push_back(static_cast<Index>(v));
  }
  return vertices;
}

int sign(double x) { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }

// Parts that can share a solver become one block, in the order of their first part.
std::vector<Block> group_parts(const LimitOperator& op, const std::vector<Index>& vertices) {
  using Kind = std::tuple<bool, int, bool>;
  std::map<Kind, std::size_t> place;
  std::vector<std::vector<Index>> groups;
  for (const std::vector<Index>& part : connected_parts(op.rows, vertices)) {
    const Block block = describe_block(op, part, Role::surface);
    const auto [at, added] =
        place.try_emplace({block.symmetric, sign(block.lowest), block.suspect}, groups.size());
    if (added) groups.emplace_back();
    groups[at->second].insert(groups[at->second].end(), part.begin(), part.end());
  }
  std::vector<Block> blocks;
  for (std::vector<Index>& group : groups) {
    std::sort(group.begin(), group.end());
    blocks.push_back(describe_block(op, std::move(group), Role::surface));
  }
  // A union of suspect parts may look anchored by one of them.
  for (const auto& [kind, at] : place) blocks[at].suspect = std::get<2>(kind);
  return blocks;
}

}  // namespace

std::vector<std::vector<Index>> connected_parts(const SparseRows& rows,
                                                const std::vector<Index>& vertices) {
  std::vector<Index> number(rows.row_count(), kNone);
  for (std::size_t i = 0; i < vertices.size(); ++i) number[vertices[i]] = static_cast<Index>(i);
  DisjointSets sets(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (const Index w : rows.row_columns(vertices[i])) {
      if (number[w] != kNone) sets.unite(static_cast<Index>(i), number[w]);
    }
  }
  std::vector<std::vector<Index>> parts;
  std::vector<std::size_t> part_of(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Index root = sets.find(static_cast<Index>(i));
    if (root == i) {
      part_of[i] = parts.size();
      parts.emplace_back();
    }
    parts[part_of[root]].push_back(vertices[i]);
  }
  return parts;
}

Blocks find_blocks(const LimitOperator& op, const std::vector<unsigned char>& listed) {
  const Index n = op.rows.row_count();
  std::vector<Role> roles(n, Role::fixed);
  Blocks blocks;
  for (Index v = 0; v < n; ++v) {
    if (listed[v] == 0) continue;
    ++blocks.interpolated;
    const bool own_limit = op.rows.row_columns(v).size() == 1;
    if (!own_limit) roles[v] = op.on_curve[v] != 0 ? Role::curve : Role::surface;
  }
  demote_open_curves(op.rows, roles);
  blocks.curve = describe_block(op, with_role(roles, Role::curve), Role::curve);
  Block whole = describe_block(op, with_role(roles, Role::surface), Role::surface);
  if (whole.proven()) {
    blocks.surface.push_back(std::move(whole));
  } else {
    blocks.surface = group_parts(op, whole.vertices);
  }
  return blocks;
}

}  // namespace surpass
