#include "io/face_sets.hpp"

#include <algorithm>

namespace surpass::io {

void FaceSetBuilder::select(FaceSet::Kind kind, const std::vector<std::string_view>& names,
                            Index face) {
  Selection& selection = current_[kind];
  close(selection, face);
  selection.sets.clear();
  for (const std::string_view name : names) {
    const auto [entry, is_new] = numbers_.try_emplace({kind, std::string(name)}, sets_.size());
    if (is_new) sets_.push_back({kind, std::string(name), {}});
    const bool repeated = std::find(selection.sets.begin(), selection.sets.end(), entry->second) !=
                          selection.sets.end();
    if (!repeated) selection.sets.push_back(entry->second);
  }
}

void FaceSetBuilder::close(Selection& selection, Index face) {
  for (const std::size_t set : selection.sets) {
    for (Index f = selection.since; f < face; ++f) sets_[set].faces.push_back(f);
  }
  selection.since = face;
}

std::vector<FaceSet> FaceSetBuilder::finish(Index face_count) {
  for (auto& [kind, selection] : current_) close(selection, face_count);
  std::erase_if(sets_, [](const FaceSet& set) { return set.faces.empty(); });
  std::stable_sort(sets_.begin(), sets_.end(), [](const FaceSet& a, const FaceSet& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.faces.front() < b.faces.front();
  });
  return std::move(sets_);
}

}  // namespace surpass::io
