#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "io/annotations.hpp"
#include "io/ply_channels.hpp"
#include "io/storage.hpp"
#include "io/text.hpp"
#include "io/writers.hpp"

namespace surpass::io {
namespace {

constexpr const char* kPly = "PLY";

// Where the numbers of a property come from: value(row) = from[row * stride].
struct OutColumn {
  std::string name;
  Storage type;
  const double* from;
  std::size_t stride;
};

// Numbers of one row, as text or as bytes.
class Row {
 public:
  Row(std::string& out, Encoding encoding)
      : out_(out),
        text_(encoding == Encoding::ascii),
        swap_((encoding == Encoding::big_endian) != (std::endian::native == std::endian::big)) {}

  template <class T>
  void add(T value) {
    if (!text_) {
      append(out_, value, swap_);
      return;
    }
    if (out_.back() != '\n') out_ += ' ';
    append_number(out_, value);
  }
  // As text, a float's value has a double's digits, so that no reader rounds it again.
  void add(Storage type, double value) {
    if (text_) {
      add(type == Storage::float32 ? rounded_to_float(value) : value);
    } else {
      with_type(type, [&](auto zero) { add(static_cast<decltype(zero)>(value)); });
    }
  }
  void end() {
    if (text_) out_ += '\n';
  }
  /// Bytes go out as they are held.
  [[nodiscard]] bool copies() const { return !text_ && !swap_; }

 private:
  std::string& out_;
  bool text_;
  bool swap_;
};

class PlyWriter {
 public:
  PlyWriter(const Mesh& mesh, const WriteOptions& options, std::string& out, Notes& notes)
      : mesh_(mesh),
        options_(options),
        out_(out),
        notes_(notes),
        encoding_(options.encoding == Encoding::automatic ? Encoding::little_endian
                                                          : options.encoding) {}

  void write();

 private:
  void choose_vertex_columns();
  void choose_face_columns();
  void choose_texture();
  template <class AnyChannel>
  void add_channel(const AnyChannel& channel, std::vector<OutColumn>& columns);
  void write_header();
  [[nodiscard]] std::size_t likely_size() const;
  void write_properties(const std::vector<OutColumn>& columns);
  void write_vertices();
  void write_faces();
  void copy_faces();
  void write_texture(Row& row, Index f);
  void write_edges();

  const Mesh& mesh_;
  const WriteOptions& options_;
  std::string& out_;
  Notes& notes_;
  Encoding encoding_;
  std::vector<double> sharpness_;
  std::vector<double> holes_;
  std::vector<OutColumn> vertex_columns_;
  std::vector<OutColumn> face_columns_;
  const CornerChannel* texture_ = nullptr;
  Storage texture_type_ = Storage::float32;
  bool long_lists_ = false;
};

bool is_known(const std::string& name, const std::vector<std::string>& parts) {
  for (const KnownChannel& known : known_channels()) {
    if (known.name == name && known.parts == parts) return true;
  }
  return false;
}

bool can_be_a_name(const std::string& name, const std::vector<OutColumn>& columns) {
  const bool word = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) > ' ' && c != '\\';
  });
  return word && std::none_of(columns.begin(), columns.end(),
                              [&](const OutColumn& column) { return column.name == name; });
}

template <class AnyChannel>
void PlyWriter::add_channel(const AnyChannel& channel, std::vector<OutColumn>& columns) {
  const std::size_t width = channel.parts.size();
  const bool known = is_known(channel.name, channel.parts);
  const Storage type = fits(channel.values, channel.storage) ? channel.storage : Storage::float64;
  std::vector<OutColumn> added = columns;
  for (std::size_t k = 0; k < width; ++k) {
    const std::string name = known        ? channel.parts[k]
                             : width == 1 ? channel.name
                                          : channel.name + "_" + channel.parts[k];
    if (!can_be_a_name(name, added)) {
      note_lost(kPly, "channel", channel.name, notes_);
      return;
    }
    added.push_back({name, type, channel.values.data() + k, width});
  }
  if (!known && width > 1) {
    notes_.push_back(fmt::format("the {} columns of channel '{}' become single properties of PLY",
                                 width, channel.name));
  }
  columns = std::move(added);
}

void PlyWriter::choose_vertex_columns() {
  const Storage type = options_.single_precision ? Storage::float32 : Storage::float64;
  const std::span<const double> positions = flat(mesh_.points);
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    vertex_columns_.push_back({kAxes[k], type, positions.empty() ? nullptr : &positions[k], 3});
  }
  const bool sharp = std::any_of(mesh_.corners.begin(), mesh_.corners.end(),
                                 [](const Corner& corner) { return corner.sharpness > 0; });
  if (sharp) {
    sharpness_.resize(mesh_.points.size());
    for (const Corner& corner : mesh_.corners) {
      sharpness_[corner.vertex] = static_cast<double>(corner.sharpness);
    }
    vertex_columns_.push_back({"sharpness", Storage::float32, sharpness_.data(), 1});
  }
  for (const Channel& channel : mesh_.channels) add_channel(channel, vertex_columns_);
}

void PlyWriter::choose_face_columns() {
  if (!mesh_.hole_faces.empty()) {
    holes_.resize(mesh_.face_count());
    for (const Index f : mesh_.hole_faces) holes_[f] = 1;
    face_columns_.push_back({"hole", Storage::uint8, holes_.data(), 1});
  }
  for (const FaceChannel& channel : mesh_.face_channels) add_channel(channel, face_columns_);
}

// Some faces have texture coordinates, at all of their corners.
bool covers_whole_faces(const Mesh& mesh, const CornerChannel& channel) {
  bool any = false;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index* first = channel.indices.data() + mesh.face_offsets[f];
    const Index* last = channel.indices.data() + mesh.face_offsets[f + 1];
    const auto missing = std::count(first, last, kNone);
    if (missing != 0 && missing != last - first) return false;
    any = any || missing == 0;
  }
  return any;
}

void PlyWriter::choose_texture() {
  for (const CornerChannel& channel : mesh_.corner_channels) {
    const bool held = texture_ == nullptr && channel.name == "texture" && channel.width == 2 &&
                      covers_whole_faces(mesh_, channel);
    if (!held) {
      note_lost(kPly, "corner channel", channel.name, notes_);
      continue;
    }
    texture_ = &channel;
    if (!fits(channel.values, Storage::float32)) texture_type_ = Storage::float64;
  }
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    const std::size_t longest = mesh_.face(f).size() * (texture_ != nullptr ? 2 : 1);
    long_lists_ = long_lists_ || longest > 255;
  }
}

void PlyWriter::write_properties(const std::vector<OutColumn>& columns) {
  for (const OutColumn& column : columns) {
    out_ += fmt::format("property {} {}\n", ply_name(column.type), column.name);
  }
}

void PlyWriter::write_header() {
  const char* encoding = encoding_ == Encoding::ascii        ? "ascii"
                         : encoding_ == Encoding::big_endian ? "binary_big_endian"
                                                             : "binary_little_endian";
  out_ += fmt::format("ply\nformat {} 1.0\n", encoding);
  append_comment(out_, "comment", annotation_comment(mesh_, notes_));
  for (const std::string& comment : options_.comments) append_comment(out_, "comment", comment);
  out_ += fmt::format("element vertex {}\n", mesh_.points.size());
  write_properties(vertex_columns_);
  const char* length = long_lists_ ? "int" : "uchar";
  const char* number = mesh_.points.size() > 0x7FFFFFFFU ? "uint" : "int";
  out_ += fmt::format("element face {}\nproperty list {} {} vertex_indices\n", mesh_.face_count(),
                      length, number);
  if (texture_ != nullptr) {
    out_ += fmt::format("property list {} {} texcoord\n", length, ply_name(texture_type_));
  }
  write_properties(face_columns_);
  if (!mesh_.creases.empty()) {
    out_ += fmt::format(
        "element edge {}\nproperty {} vertex1\nproperty {} vertex2\n"
        "property float sharpness\n",
        mesh_.creases.size(), number, number);
  }
  out_ += "end_header\n";
}

void PlyWriter::write_vertices() {
  Row row(out_, encoding_);
  const bool as_held = vertex_columns_.size() == 3 && vertex_columns_[0].type == Storage::float64;
  if (row.copies() && as_held) {
    const std::span<const double> positions = flat(mesh_.points);
    out_.append(reinterpret_cast<const char*>(positions.data()), positions.size_bytes());
    return;
  }
  for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
    for (const OutColumn& column : vertex_columns_) {
      row.add(column.type, column.from[v * column.stride]);
    }
    row.end();
  }
}

void PlyWriter::write_texture(Row& row, Index f) {
  const std::span<const Index> rows =
      std::span(texture_->indices).subspan(mesh_.face_offsets[f], mesh_.face(f).size());
  const std::size_t count = !rows.empty() && rows.front() != kNone ? 2 * rows.size() : 0;
  row.add(long_lists_ ? Storage::int32 : Storage::uint8, static_cast<double>(count));
  for (std::size_t k = 0; k < count; ++k) {
    row.add(texture_type_, texture_->values[std::size_t{2} * rows[k / 2] + k % 2]);
  }
}

// Faces with nothing but corners, fewer than 256 each, in the machine's byte order.
void PlyWriter::copy_faces() {
  std::array<char, 1 + 255 * sizeof(Index)> bytes;
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    const std::span<const Index> face = mesh_.face(f);
    bytes[0] = static_cast<char>(face.size());
    std::memcpy(&bytes[1], face.data(), face.size_bytes());
    out_.append(bytes.data(), 1 + face.size_bytes());
  }
}

void PlyWriter::write_faces() {
  Row row(out_, encoding_);
  if (row.copies() && texture_ == nullptr && face_columns_.empty() && !long_lists_) {
    return copy_faces();
  }
  const Storage length = long_lists_ ? Storage::int32 : Storage::uint8;
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    const std::span<const Index> face = mesh_.face(f);
    row.add(length, static_cast<double>(face.size()));
    for (const Index v : face) row.add(v);  // int and uint have the same bytes here
    if (texture_ != nullptr) write_texture(row, f);
    for (const OutColumn& column : face_columns_) {
      row.add(column.type, column.from[f * column.stride]);
    }
    row.end();
  }
}

void PlyWriter::write_edges() {
  Row row(out_, encoding_);
  for (const Crease& crease : mesh_.creases) {
    row.add(crease.vertices[0]);
    row.add(crease.vertices[1]);
    row.add(Storage::float32, static_cast<double>(crease.sharpness));
    row.end();
  }
}

// Of all rows: growing by doubling would copy most of the file once more. Text has up to 17 digits
// a number; what is too much is never touched.
std::size_t PlyWriter::likely_size() const {
  const auto size_of = [&](Storage type) -> std::size_t {
    if (encoding_ == Encoding::ascii) return 20;
    return with_type(type, [](auto zero) { return sizeof(zero); });
  };
  const auto row = [&](const std::vector<OutColumn>& columns) {
    std::size_t size = 0;
    for (const OutColumn& column : columns) size += size_of(column.type);
    return size;
  };
  const std::size_t numbers = texture_ != nullptr ? 2 * mesh_.face_vertices.size() : 0;
  const std::size_t lists = texture_ != nullptr ? 2 : 1;
  return mesh_.points.size() * row(vertex_columns_) +
         mesh_.face_count() * (row(face_columns_) + lists * size_of(Storage::uint8)) +
         mesh_.face_vertices.size() * size_of(Storage::int32) + numbers * size_of(texture_type_) +
         mesh_.creases.size() * 3 * size_of(Storage::int32);
}

void PlyWriter::write() {
  choose_vertex_columns();
  choose_face_columns();
  choose_texture();
  out_.reserve(out_.size() + likely_size() + 4096);  // and the header
  write_header();
  write_vertices();
  write_faces();
  write_edges();
}

}  // namespace

Result<void> write_ply(const Mesh& mesh, const WriteOptions& options, std::string& bytes,
                       Notes& notes) {
  note_losses(mesh, {.format = kPly, .sharpness = true, .holes = true}, notes);
  PlyWriter(mesh, options, bytes, notes).write();
  return {};
}

}  // namespace surpass::io
