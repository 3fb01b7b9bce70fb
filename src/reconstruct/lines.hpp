// Boundaries and creases through a simplification: curves that keep their course, their ends and
// their junctions.
#pragma once

#include <surpass/topology.hpp>

#include <array>
#include <vector>

#include "reconstruct/features.hpp"

namespace surpass::reconstruction {

/// What a vertex may be merged into.
enum class Freedom : unsigned char {
  anywhere,    ///< any neighbour
  along_line,  ///< the two neighbours on its curve
  nowhere,     ///< it stays
};

class Lines {
 public:
  /// Bow-ties, corners, ends of creases and vertices where more than one curve passes stay.
  Lines(const Topology& topology, const Features& features);

  [[nodiscard]] Freedom freedom(Index v) const { return freedom_[v]; }
  [[nodiscard]] bool allows(Index v, Index w) const {
    return freedom_[v] == Freedom::anywhere ||
           (freedom_[v] == Freedom::along_line && (line_[v][0] == w || line_[v][1] == w) &&
            !would_close_up(v, w));
  }
  /// To be told after v was merged into w.
  void collapse(Index v, Index w);

  /// The crease edges that there are now.
  [[nodiscard]] std::vector<std::array<Index, 2>> creases() const;

 private:
  [[nodiscard]] bool would_close_up(Index v, Index w) const;
  [[nodiscard]] Index other_end(Index v, Index w) const {
    return line_[v][0] == w ? line_[v][1] : line_[v][0];
  }
  void relink(Index v, Index from, Index to);

  std::vector<Freedom> freedom_;
  std::vector<std::array<Index, 2>> line_;     // of vertices along a line
  std::vector<unsigned char> is_crease_;       // #V: its line is a crease, no boundary
  std::vector<unsigned char> gone_;            // #V
  std::vector<std::array<Index, 2>> between_;  // creases between vertices that stay
};

}  // namespace surpass::reconstruction
