// Each face is read from its smallest vertex towards the smaller neighbour of that; faces whose
// readings hash alike are compared.
#include "mesh/repeated_faces.hpp"

#include <algorithm>
#include <cstdint>

namespace surpass {
namespace {

// A face read in its canonical direction.
class Cycle {
 public:
  explicit Cycle(std::span<const Index> face)
      : face_(face),
        start_(
            static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin())) {
    const std::size_t n = face.size();
    forward_ = face[(start_ + 1) % n] <= face[(start_ + n - 1) % n];
  }
  [[nodiscard]] std::size_t size() const { return face_.size(); }
  [[nodiscard]] Index operator[](std::size_t i) const {
    const std::size_t n = face_.size();
    return face_[(start_ + (forward_ ? i : n - i)) % n];
  }
  [[nodiscard]] std::uint64_t hash() const {
    std::uint64_t h = size();
    for (std::size_t i = 0; i < size(); ++i) {
      h = (h ^ (*this)[i]) * 0x9E3779B97F4A7C15U;
      h ^= h >> 32;
    }
    return h;
  }
  bool operator==(const Cycle& other) const {
    if (size() != other.size()) return false;
    for (std::size_t i = 0; i < size(); ++i) {
      if ((*this)[i] != other[i]) return false;
    }
    return true;
  }

 private:
  std::span<const Index> face_;
  std::size_t start_;
  bool forward_;
};

struct HashedFace {
  std::uint64_t hash;
  Index face;
};

}  // namespace

std::vector<RepeatedFace> find_repeated_faces(const Mesh& mesh,
                                              std::span<const unsigned char> skip) {
  std::vector<HashedFace> hashed;
  hashed.reserve(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!skip.empty() && skip[f] != 0) continue;
    hashed.push_back({Cycle(mesh.face(f)).hash(), f});
  }
  std::sort(hashed.begin(), hashed.end(), [](const HashedFace& a, const HashedFace& b) {
    return a.hash != b.hash ? a.hash < b.hash : a.face < b.face;
  });
  std::vector<RepeatedFace> repeats;
  std::vector<Index> firsts;  // of the run of equal hashes: one, unless hashes collide
  for (std::size_t i = 0; i < hashed.size(); ++i) {
    if (i == 0 || hashed[i].hash != hashed[i - 1].hash) firsts.clear();
    const Cycle cycle(mesh.face(hashed[i].face));
    const auto first = std::find_if(firsts.begin(), firsts.end(),
                                    [&](Index f) { return Cycle(mesh.face(f)) == cycle; });
    if (first == firsts.end()) {
      firsts.push_back(hashed[i].face);
    } else {
      repeats.push_back({hashed[i].face, *first});
    }
  }
  std::sort(repeats.begin(), repeats.end(),
            [](const RepeatedFace& a, const RepeatedFace& b) { return a.face < b.face; });
  return repeats;
}

bool is_back_to_back(const Mesh& mesh, const EdgeTable& edges, Index repeated_face) {
  for (Index h = mesh.face_offsets[repeated_face]; h < mesh.face_offsets[repeated_face + 1]; ++h) {
    if (!edges.is_regular(edges.edge(h))) return false;
  }
  return true;
}

}  // namespace surpass
