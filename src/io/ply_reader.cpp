// PLY after Greg Turk, "The PLY Polygon File Format", 1994: any elements, in any order, of any
// types. Besides vertices and faces we read edges with a sharpness (creases), vertices with a
// sharpness (corners), faces marked `hole`, and triangle strips.
#include <limits>

#include "io/ply_body.hpp"
#include "io/readers.hpp"

namespace surpass::io {
namespace {

// A double beyond a float's range is as sharp as the largest float.
float as_sharpness(double value) {
  return static_cast<float>(std::min(value, double{std::numeric_limits<float>::max()}));
}

template <class Source>
class PlyReader {
 public:
  PlyReader(Scanner& scan, const PlyHeader& header, LoadedMesh& out)
      : scan_(scan), header_(header), source_(scan), out_(out), mesh_(out.mesh) {
    if (const PlyElement* vertices = header.find("vertex")) vertex_count_ = vertices->count;
  }

  bool read();

 private:
  bool check_size(const PlyElement& element);
  bool read_element(const PlyElement& element);
  bool read_vertices(const PlyElement& element);
  bool read_faces(const PlyElement& element);
  bool read_edges(const PlyElement& element);
  bool read_strips(const PlyElement& element);
  bool skip_element(const PlyElement& element);

  bool read_points(const PlyElement& element, const std::vector<Column>& columns,
                   const std::vector<double>& sharpness);
  bool read_indices(const PlyProperty& property, std::size_t length);
  bool read_texture(const PlyProperty& property, std::size_t length);
  bool end_face(const char* place);
  bool read_strip(const PlyProperty& property, std::size_t length);
  bool add_crease(double a, double b, double sharpness, const char* place);
  bool is_vertex(double number) const {
    return number >= 0 && number < static_cast<double>(vertex_count_) &&
           number == std::floor(number);
  }
  bool refuse_vertex(double number, const char* place);
  bool skip_list(const PlyProperty& property, std::size_t length);
  void note_skipped_lists(const PlyElement& element, std::initializer_list<const char*> used);
  bool require(const PlyElement& element, const char* property, bool list);

  Scanner& scan_;
  const PlyHeader& header_;
  Source source_;
  LoadedMesh& out_;
  Mesh& mesh_;
  std::uint64_t vertex_count_ = 0;
  std::size_t texture_length_ = 0;  // of the face that is being read
  CornerChannel texture_{"texture", 2, {}, {}};
};

template <class Source>
bool PlyReader<Source>::read() {
  for (const PlyElement& element : header_.elements) {
    if (!check_size(element) || !read_element(element)) return false;
  }
  if (!Source::kBinary) scan_.skip_space();
  if (!scan_.done()) {
    out_.notices.push_back(
        fmt::format("{} bytes behind the last element are not used", scan_.left()));
  }
  return true;
}

// No memory is taken for rows that the file cannot hold.
template <class Source>
bool PlyReader<Source>::check_size(const PlyElement& element) {
  std::uint64_t least = 0;
  for (const PlyProperty& property : element.properties) {
    least += source_.least_size(property.count_type.value_or(property.type));
  }
  if (least == 0 || element.count <= source_.left() / least) {
    if (element.count < kNone) return true;
    return scan_.fail(ErrorCode::too_large, "more than 4294967294 rows", element.place);
  }
  return source_.fail(ErrorCode::unexpected_end,
                      fmt::format("the header announces {} rows of element {}, at least {} bytes "
                                  "each, but only {} bytes follow; the file is damaged or cut off",
                                  element.count, element.name, least, scan_.left()),
                      source_.at());
}

template <class Source>
bool PlyReader<Source>::read_element(const PlyElement& element) {
  if (element.count == 0 || element.properties.empty()) return true;
  if (element.name == "vertex") return read_vertices(element);
  if (element.name == "face") return read_faces(element);
  if (element.name == "tristrips") return read_strips(element);
  const bool creases = element.name == "edge" && element.find("vertex1") &&
                       element.find("vertex2") && element.find("sharpness");
  return creases ? read_edges(element) : skip_element(element);
}

template <class Source>
bool PlyReader<Source>::require(const PlyElement& element, const char* property, bool list) {
  const auto k = element.find(property);
  if (k && element.properties[*k].count_type.has_value() == list) return true;
  return scan_.fail(ErrorCode::syntax,
                    fmt::format("element {} has no {} '{}'; without it there is no mesh",
                                element.name, list ? "list" : "single-valued property", property),
                    element.place);
}

template <class Source>
bool PlyReader<Source>::read_vertices(const PlyElement& element) {
  for (const char* axis : {"x", "y", "z"}) {
    if (!require(element, axis, false)) return false;
  }
  const auto count = static_cast<std::size_t>(element.count);
  mesh_.points.reserve(count);  // and grows while it is read
  mesh_.points.resize(1);
  std::vector<Column> columns(element.properties.size());
  const std::span<double> positions(mesh_.points.front().data(), 3 * count);
  columns[*element.find("x")] = column_of(positions, 0, 3);
  columns[*element.find("y")] = column_of(positions, 1, 3);
  columns[*element.find("z")] = column_of(positions, 2, 3);
  std::vector<double> sharpness;
  if (const auto k = element.find("sharpness"); k && !element.properties[*k].count_type) {
    sharpness.resize(count);
    columns[*k] = column_of(sharpness, 0, 1);
  }
  mesh_.channels = make_channels<Channel>(element, columns);
  note_skipped_lists(element, {});
  if (!read_points(element, columns, sharpness)) return false;
  for (std::size_t v = 0; v < sharpness.size(); ++v) {
    if (sharpness[v] > 0) {
      mesh_.corners.push_back({static_cast<Index>(v), as_sharpness(sharpness[v])});
    }
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::read_points(const PlyElement& element, const std::vector<Column>& columns,
                                    const std::vector<double>& sharpness) {
  const bool no_lists =
      std::none_of(element.properties.begin(), element.properties.end(),
                   [](const PlyProperty& property) { return property.count_type.has_value(); });
  if constexpr (Source::kBinary) {
    const char* start = source_.at();
    const auto negative = [](double value) { return value < 0; };
    const auto grow = [&](std::size_t rows) { mesh_.points.resize(rows); };
    if (no_lists && source_.gather(element, columns, grow)) {
      if (std::none_of(sharpness.begin(), sharpness.end(), negative)) return true;
    }
    scan_.move_to(start);  // row by row the offending value is found
  }
  mesh_.points.resize(static_cast<std::size_t>(element.count));
  return read_rows(
      source_, element, columns,
      [&](std::size_t k, std::size_t length) { return skip_list(element.properties[k], length); },
      [&](const char* place, std::size_t row) {
        return sharpness.empty() || sharpness[row] >= 0 ||
               source_.fail(ErrorCode::syntax, "the vertex has a negative sharpness; 0 is smooth",
                            place);
      });
}

template <class Source>
bool PlyReader<Source>::read_faces(const PlyElement& element) {
  const char* list = element.find("vertex_index") ? "vertex_index" : "vertex_indices";
  if (!require(element, list, true)) return false;
  const std::size_t indices = *element.find(list);
  if (is_floating(element.properties[indices].type)) {
    return scan_.fail(ErrorCode::syntax, "the vertices of faces must be of a whole-number type",
                      element.place);
  }
  const auto texture = element.find("texcoord");
  const auto count = static_cast<std::size_t>(element.count);
  mesh_.face_offsets.reserve(count + 1);
  mesh_.face_vertices.reserve(std::min<std::size_t>(3 * count, scan_.left()));
  if constexpr (Source::kBinary) {
    if (source_.gather_lists(element, vertex_count_, mesh_.face_vertices, mesh_.face_offsets)) {
      return true;
    }
    mesh_.face_vertices.clear();  // row by row the offending value is found, if there is one
    mesh_.face_offsets.resize(1);
  }
  std::vector<Column> columns(element.properties.size());
  std::vector<double> hole;
  if (const auto k = element.find("hole"); k && !element.properties[*k].count_type) {
    hole.resize(count);
    columns[*k] = column_of(hole, 0, 1);
  }
  mesh_.face_channels = make_channels<FaceChannel>(element, columns);
  note_skipped_lists(element, {list, "texcoord"});
  const auto on_list = [&](std::size_t k, std::size_t length) {
    if (k == indices) return read_indices(element.properties[k], length);
    if (k == texture) return read_texture(element.properties[k], length);
    return skip_list(element.properties[k], length);
  };
  const auto end_row = [&](const char* place, std::size_t) { return end_face(place); };
  if (!read_rows(source_, element, columns, on_list, end_row)) return false;
  for (std::size_t f = 0; f < hole.size(); ++f) {
    if (hole[f] != 0) mesh_.hole_faces.push_back(static_cast<Index>(f));
  }
  if (!texture_.values.empty()) {
    texture_.indices.resize(mesh_.face_vertices.size(), kNone);
    mesh_.corner_channels.push_back(std::move(texture_));
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::read_indices(const PlyProperty& property, std::size_t length) {
  if (length == 0) {
    return source_.fail(ErrorCode::syntax, "the face has no vertices; remove it", source_.at());
  }
  for (std::size_t k = 0; k < length; ++k) {
    const char* place = source_.at();
    double number = 0;
    if (!source_.value(property.type, property.name, number)) return false;
    if (!is_vertex(number)) return refuse_vertex(number, place);
    mesh_.face_vertices.push_back(static_cast<Index>(number));
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::refuse_vertex(double number, const char* place) {
  return source_.fail(ErrorCode::index_out_of_range,
                      fmt::format("vertex {} is named here, but the file has {}, counted from 0",
                                  number, vertex_count_),
                      place);
}

template <class Source>
bool PlyReader<Source>::read_texture(const PlyProperty& property, std::size_t length) {
  texture_length_ = length;
  for (std::size_t k = 0; k < length; ++k) {
    if (!source_.value(property.type, property.name, texture_.values.emplace_back())) return false;
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::end_face(const char* place) {
  const std::size_t first = mesh_.face_offsets.back();
  const std::size_t corners = mesh_.face_vertices.size() - first;
  if (mesh_.face_vertices.size() >= kNone) {
    return source_.fail(ErrorCode::too_large, "more than 4294967294 face corners", place);
  }
  mesh_.face_offsets.push_back(static_cast<Index>(mesh_.face_vertices.size()));
  if (texture_length_ == 0) return true;
  if (texture_length_ != 2 * corners) {
    return source_.fail(ErrorCode::syntax,
                        fmt::format("the list texcoord has {} numbers for a face of {} corners; "
                                    "two each are expected, or none at all",
                                    texture_length_, corners),
                        place);
  }
  texture_.indices.resize(first, kNone);
  const std::size_t row = texture_.values.size() / 2 - corners;
  for (std::size_t k = 0; k < corners; ++k) {
    texture_.indices.push_back(static_cast<Index>(row + k));
  }
  texture_length_ = 0;
  return true;
}

template <class Source>
bool PlyReader<Source>::read_edges(const PlyElement& element) {
  for (const char* name : {"vertex1", "vertex2", "sharpness"}) {
    if (!require(element, name, false)) return false;
  }
  std::vector<Column> columns(element.properties.size());
  const std::vector<Channel> read = make_channels<Channel>(element, columns);
  const Column a = columns[*element.find("vertex1")];
  const Column b = columns[*element.find("vertex2")];
  const Column sharpness = columns[*element.find("sharpness")];
  return read_rows(
      source_, element, columns,
      [&](std::size_t k, std::size_t length) { return skip_list(element.properties[k], length); },
      [&](const char* place, std::size_t row) {
        return add_crease(a.to[row * a.stride], b.to[row * b.stride],
                          sharpness.to[row * sharpness.stride], place);
      });
}

template <class Source>
bool PlyReader<Source>::add_crease(double a, double b, double sharpness, const char* place) {
  if (!is_vertex(a)) return refuse_vertex(a, place);
  if (!is_vertex(b)) return refuse_vertex(b, place);
  if (sharpness < 0) {
    return source_.fail(ErrorCode::syntax, "the edge has a negative sharpness; 0 is smooth", place);
  }
  mesh_.creases.push_back(
      {{static_cast<Index>(a), static_cast<Index>(b)}, as_sharpness(sharpness)});
  return true;
}

template <class Source>
bool PlyReader<Source>::read_strips(const PlyElement& element) {
  if (const PlyElement* faces = header_.find("face"); faces != nullptr && faces->count != 0) {
    return scan_.fail(ErrorCode::unsupported,
                      "the file has faces and triangle strips; save it with faces only",
                      element.place);
  }
  const char* list = element.find("vertex_index") ? "vertex_index" : "vertex_indices";
  if (!require(element, list, true)) return false;
  const std::size_t indices = *element.find(list);
  std::vector<Column> columns(element.properties.size());
  const std::vector<FaceChannel> ignored = make_channels<FaceChannel>(element, columns);
  const Index faces_before = mesh_.face_count();
  const bool read = read_rows(
      source_, element, columns,
      [&](std::size_t k, std::size_t length) {
        return k == indices ? read_strip(element.properties[k], length)
                            : skip_list(element.properties[k], length);
      },
      [](const char*, std::size_t) { return true; });
  if (!read) return false;
  out_.notices.push_back(
      fmt::format("triangle strips were read as {} triangles", mesh_.face_count() - faces_before));
  return true;
}

// Each vertex makes a triangle with the two before it, turned round every second time; -1 begins a
// new strip. Triangles with a repeated vertex only lead the strip elsewhere.
template <class Source>
bool PlyReader<Source>::read_strip(const PlyProperty& property, std::size_t length) {
  std::array<Index, 3> last = {};
  std::size_t since_start = 0;
  for (std::size_t k = 0; k < length; ++k) {
    const char* place = source_.at();
    double number = 0;
    if (!source_.value(property.type, property.name, number)) return false;
    if (number == -1) {
      since_start = 0;
      continue;
    }
    if (!is_vertex(number)) return refuse_vertex(number, place);
    last = {last[1], last[2], static_cast<Index>(number)};
    const bool leads_on = last[0] == last[1] || last[1] == last[2] || last[2] == last[0];
    if (++since_start < 3 || leads_on) continue;
    if (since_start % 2 == 1) {
      mesh_.add_face(last);
    } else {
      mesh_.add_face(std::array{last[1], last[0], last[2]});
    }
  }
  return true;
}

template <class Source>
bool PlyReader<Source>::skip_element(const PlyElement& element) {
  std::vector<Column> columns(element.properties.size());
  std::vector<double> ignored(1);
  for (Column& column : columns) column = column_of(ignored, 0, 0);
  out_.notices.push_back(
      fmt::format("{} rows of element {} are skipped", element.count, element.name));
  return read_rows(
      source_, element, columns,
      [&](std::size_t k, std::size_t length) { return skip_list(element.properties[k], length); },
      [](const char*, std::size_t) { return true; });
}

template <class Source>
bool PlyReader<Source>::skip_list(const PlyProperty& property, std::size_t length) {
  for (std::size_t k = 0; k < length; ++k) {
    if (!source_.skip(property.type, property.name)) return false;
  }
  return true;
}

template <class Source>
void PlyReader<Source>::note_skipped_lists(const PlyElement& element,
                                           std::initializer_list<const char*> used) {
  for (const PlyProperty& property : element.properties) {
    const bool is_used = std::find(used.begin(), used.end(), property.name) != used.end();
    if (property.count_type && !is_used) {
      out_.notices.push_back(
          fmt::format("the list {} of element {} is skipped", property.name, element.name));
    }
  }
}

}  // namespace

bool read_ply(Scanner& scan, LoadedMesh& out) {
  PlyHeader header;
  if (!read_ply_header(scan, header, out.mesh)) return false;
  if (header.encoding == Encoding::ascii) return PlyReader<PlyText>(scan, header, out).read();
  const bool little = header.encoding == Encoding::little_endian;
  if (little == (std::endian::native == std::endian::little)) {
    return PlyReader<PlyBytes<false>>(scan, header, out).read();
  }
  return PlyReader<PlyBytes<true>>(scan, header, out).read();
}

}  // namespace surpass::io
