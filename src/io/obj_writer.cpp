#include <algorithm>

#include "io/annotations.hpp"
#include "io/text.hpp"
#include "io/writers.hpp"

namespace surpass::io {
namespace {

constexpr const char* kObj = "OBJ";

// Rows of `vt` or `vn`, and the row that each corner names.
struct CornerRows {
  const char* keyword;
  std::size_t width = 0;
  std::span<const double> values = {};
  std::span<const Index> indices = {};

  [[nodiscard]] Index row(std::size_t corner) const {
    return indices.empty() ? kNone : indices[corner];
  }
};

class ObjWriter {
 public:
  ObjWriter(const Mesh& mesh, std::string& out, Notes& notes)
      : mesh_(mesh), out_(out), notes_(notes) {}

  void write();

 private:
  void choose_channels();
  void use_rows(CornerRows& rows, const CornerChannel& channel);
  void use_rows(CornerRows& rows, const Channel& channel);
  void choose_face_sets();
  bool can_be_held(const FaceSet& set) const;
  void write_vertices();
  void write_rows(const CornerRows& rows);
  void write_faces();
  void write_sets_at(Index face);
  void write_statement(FaceSet::Kind kind, const std::vector<std::size_t>& sets);
  void write_corner(std::size_t corner);
  void write_tags();

  const Mesh& mesh_;
  std::string& out_;
  Notes& notes_;
  const Channel* colour_ = nullptr;
  CornerRows texture_{"vt"};
  CornerRows normal_{"vn"};
  std::vector<std::pair<Index, std::size_t>> begins_;  // (face, set) where a run of faces begins
  std::vector<std::pair<Index, std::size_t>> ends_;    // (face behind, set)
  std::size_t next_begin_ = 0;
  std::size_t next_end_ = 0;
  std::vector<std::size_t> active_[4];  // sets by kind, ascending
};

bool is_seamless(const CornerRows& rows, std::size_t width) {
  return rows.width == 0 && width != 0;
}

void ObjWriter::use_rows(CornerRows& rows, const CornerChannel& channel) {
  rows.width = channel.width;
  rows.values = channel.values;
  rows.indices = channel.indices;
}

// A row per vertex: corners name their vertex's number.
void ObjWriter::use_rows(CornerRows& rows, const Channel& channel) {
  rows.width = channel.width();
  rows.values = channel.values;
  rows.indices = mesh_.face_vertices;
}

void ObjWriter::choose_channels() {
  for (const CornerChannel& channel : mesh_.corner_channels) {
    if (channel.name == "texture" && texture_.width == 0 && channel.width <= 3) {
      use_rows(texture_, channel);
    } else if (channel.name == "normal" && normal_.width == 0 && channel.width == 3) {
      use_rows(normal_, channel);
    } else {
      note_lost(kObj, "corner channel", channel.name, notes_);
    }
  }
  for (const Channel& channel : mesh_.channels) {
    const std::size_t width = channel.width();
    if (channel.name == "color" && colour_ == nullptr && (width == 3 || width == 4)) {
      colour_ = &channel;
    } else if (channel.name == "texture" && width <= 3 && is_seamless(texture_, width)) {
      use_rows(texture_, channel);
    } else if (channel.name == "normal" && width == 3 && is_seamless(normal_, width)) {
      use_rows(normal_, channel);
    } else {
      note_lost(kObj, "channel", channel.name, notes_);
    }
  }
  for (const FaceChannel& channel : mesh_.face_channels) {
    note_lost(kObj, "face channel", channel.name, notes_);
  }
  if (colour_ != nullptr && colour_->storage == Storage::uint8) {
    notes_.emplace_back("colours from 0 to 255 are written from 0 to 1, as is usual in OBJ");
  }
}

bool ObjWriter::can_be_held(const FaceSet& set) const {
  const std::string& name = set.name;
  if (name.empty() || name.front() == ' ' || name.back() == ' ' || name.front() == '#')
    return false;
  const bool one_word = set.kind == FaceSet::Kind::group;
  if (one_word && name.find_first_of(" #") != name.npos) return false;
  if (set.kind == FaceSet::Kind::smoothing && (name == "off" || name == "0")) return false;
  return name.find(" #") == name.npos && name.find_first_of("\t\r\n\\") == name.npos;
}

void ObjWriter::choose_face_sets() {
  for (std::size_t s = 0; s < mesh_.face_sets.size(); ++s) {
    const FaceSet& set = mesh_.face_sets[s];
    if (!can_be_held(set)) {
      note_lost(kObj, "set of faces", set.name, notes_);
      continue;
    }
    for (std::size_t k = 0; k < set.faces.size(); ++k) {
      if (k == 0 || set.faces[k] != set.faces[k - 1] + 1) begins_.emplace_back(set.faces[k], s);
      const bool last = k + 1 == set.faces.size() || set.faces[k + 1] != set.faces[k] + 1;
      if (last) ends_.emplace_back(set.faces[k] + 1, s);
    }
  }
  std::sort(begins_.begin(), begins_.end());
  std::sort(ends_.begin(), ends_.end());
}

void ObjWriter::write_vertices() {
  const double scale = colour_ != nullptr && colour_->storage == Storage::uint8 ? 255.0 : 1.0;
  for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
    out_ += 'v';
    for (const double x : mesh_.points[v]) append_spaced(out_, x);
    for (std::size_t k = 0; colour_ != nullptr && k < colour_->width(); ++k) {
      append_spaced(out_, colour_->values[v * colour_->width() + k] / scale);
    }
    out_ += '\n';
  }
}

void ObjWriter::write_rows(const CornerRows& rows) {
  for (std::size_t k = 0; k < rows.values.size(); ++k) {
    if (k % rows.width == 0) out_ += rows.keyword;
    append_spaced(out_, rows.values[k]);
    if (k % rows.width == rows.width - 1) out_ += '\n';
  }
}

void ObjWriter::write_corner(std::size_t corner) {
  append_spaced(out_, mesh_.face_vertices[corner] + std::uint64_t{1});
  const Index texture = texture_.row(corner);
  const Index normal = normal_.row(corner);
  if (texture == kNone && normal == kNone) return;
  out_ += '/';
  if (texture != kNone) append_number(out_, texture + std::uint64_t{1});
  if (normal == kNone) return;
  out_ += '/';
  append_number(out_, normal + std::uint64_t{1});
}

void ObjWriter::write_statement(FaceSet::Kind kind, const std::vector<std::size_t>& sets) {
  static constexpr const char* kKeywords[] = {"g", "o", "usemtl", "s"};
  out_ += kKeywords[static_cast<std::size_t>(kind)];
  if (kind == FaceSet::Kind::smoothing && sets.empty()) out_ += " off";
  const std::size_t most = kind == FaceSet::Kind::group ? sets.size() : 1;
  for (std::size_t k = 0; k < std::min(most, sets.size()); ++k) {
    out_ += ' ';
    out_ += mesh_.face_sets[sets[k]].name;
  }
  out_ += '\n';
  for (std::size_t k = most; k < sets.size(); ++k) {
    notes_.push_back(
        fmt::format("a face in OBJ is in one object, material and smoothing group "
                    "only; part of '{}' is left out",
                    mesh_.face_sets[sets[k]].name));
  }
}

// Statements where this face is in other sets than the one before it.
void ObjWriter::write_sets_at(Index face) {
  bool changed[4] = {};
  for (; next_end_ < ends_.size() && ends_[next_end_].first == face; ++next_end_) {
    const std::size_t set = ends_[next_end_].second;
    const auto kind = static_cast<std::size_t>(mesh_.face_sets[set].kind);
    std::erase(active_[kind], set);
    changed[kind] = true;
  }
  for (; next_begin_ < begins_.size() && begins_[next_begin_].first == face; ++next_begin_) {
    const std::size_t set = begins_[next_begin_].second;
    const auto kind = static_cast<std::size_t>(mesh_.face_sets[set].kind);
    active_[kind].insert(std::lower_bound(active_[kind].begin(), active_[kind].end(), set), set);
    changed[kind] = true;
  }
  for (std::size_t kind = 0; kind < 4; ++kind) {
    if (changed[kind]) write_statement(static_cast<FaceSet::Kind>(kind), active_[kind]);
  }
}

void ObjWriter::write_faces() {
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    write_sets_at(f);
    out_ += 'f';
    for (Index c = mesh_.face_offsets[f]; c < mesh_.face_offsets[f + 1]; ++c) write_corner(c);
    out_ += '\n';
  }
}

void ObjWriter::write_tags() {
  for (const Crease& crease : mesh_.creases) {
    out_ += fmt::format("t crease 2/1/0 {} {} {}\n", crease.vertices[0], crease.vertices[1],
                        crease.sharpness);
  }
  for (const Corner& corner : mesh_.corners) {
    out_ += fmt::format("t corner 1/1/0 {} {}\n", corner.vertex, corner.sharpness);
  }
  if (!mesh_.hole_faces.empty()) {
    out_ += fmt::format("t hole {}/0/0 {}\n", mesh_.hole_faces.size(),
                        fmt::join(mesh_.hole_faces, " "));
  }
  for (const std::string& tag : mesh_.tags) out_ += tag + '\n';
}

void ObjWriter::write() {
  choose_channels();
  choose_face_sets();
  for (const std::string& library : mesh_.material_libraries) out_ += "mtllib " + library + '\n';
  write_vertices();
  write_rows(texture_);
  write_rows(normal_);
  write_faces();
  write_tags();
}

}  // namespace

Result<void> write_obj(const Mesh& mesh, const WriteOptions& options, std::string& bytes,
                       Notes& notes) {
  append_comment(bytes, "#", annotation_comment(mesh, notes));
  for (const std::string& comment : options.comments) append_comment(bytes, "#", comment);
  ObjWriter(mesh, bytes, notes).write();
  return {};
}

}  // namespace surpass::io
