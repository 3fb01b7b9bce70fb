// Named sets of faces from files that say "from here on".
#pragma once

#include <surpass/mesh.hpp>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace surpass::io {

class FaceSetBuilder {
 public:
  /// Faces from number `face` on are in these sets, and in no others of their kind.
  void select(FaceSet::Kind kind, const std::vector<std::string_view>& names, Index face);

  /// The sets that have faces, in order of kind, first face, and first mention.
  [[nodiscard]] std::vector<FaceSet> finish(Index face_count);

 private:
  struct Selection {
    std::vector<std::size_t> sets;
    Index since = 0;
  };
  void close(Selection& selection, Index face);

  std::vector<FaceSet> sets_;
  std::map<std::pair<FaceSet::Kind, std::string>, std::size_t> numbers_;
  std::map<FaceSet::Kind, Selection> current_;
};

}  // namespace surpass::io
