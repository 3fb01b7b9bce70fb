// Comments of the form `surpass scheme=loop boundary=edge-and-corner`, by which the text formats
// and STL's headers keep a mesh's annotations.
#pragma once

#include <surpass/mesh.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace surpass::io {

/// Takes the annotations from a comment's text; false, and nothing changes, if it is another
/// comment.
bool read_annotations(std::string_view comment, Mesh& mesh);

/// The comment's text, or "" where there is nothing to keep. Annotations with blanks or "=" in them
/// cannot be held and are named in `notes`.
[[nodiscard]] std::string annotation_comment(const Mesh& mesh, std::vector<std::string>& notes);

}  // namespace surpass::io
