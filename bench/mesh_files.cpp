#include "mesh_files.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

namespace surpass::bench {
namespace {

// Text that goes to its file block by block, for a large mesh has a gigabyte of it.
class File {
 public:
  explicit File(const std::string& path) : path_(path), file_(path, std::ios::binary) {}
  void add(const char* bytes, std::size_t count) {
    block_.append(bytes, count);
    flush_from(kBlock);
  }
  template <class... Values>
  void add_line(fmt::format_string<const Values&...> format, const Values&... values) {
    fmt::format_to(std::back_inserter(block_), format, values...);
    flush_from(kBlock);
  }
  void finish() {
    flush_from(0);
    if (!file_.flush()) throw std::runtime_error("cannot write " + path_);
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 20;
  void flush_from(std::size_t size) {
    if (block_.size() < size) return;
    file_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
    block_.clear();
  }

  std::string path_;
  std::ofstream file_;
  std::string block_;
};

}  // namespace

void write_obj(const Mesh& mesh, const std::string& path) {
  File file(path);
  for (const Point& p : mesh.points) file.add_line("v {} {} {}\n", p[0], p[1], p[2]);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    file.add_line("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
  }
  file.finish();
}

void write_ply(const Mesh& mesh, const std::string& path) {
  File file(path);
  file.add_line(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      mesh.points.size(), mesh.face_count());
  for (const Point& p : mesh.points) file.add(reinterpret_cast<const char*>(p.data()), sizeof p);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const char degree = 3;
    file.add(&degree, 1);
    file.add(reinterpret_cast<const char*>(mesh.face(f).data()), 3 * sizeof(Index));
  }
  file.finish();
}

}  // namespace surpass::bench
