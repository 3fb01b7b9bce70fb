#include "io/ply_channels.hpp"

namespace surpass::io {
namespace {

using Members = std::vector<std::size_t>;  // numbers of properties

bool is_free(const PlyElement& element, const std::vector<Column>& columns, std::size_t k) {
  return !element.properties[k].count_type && !columns[k].taken;
}

// The properties named so, or none if one of them is missing or taken.
Members find_all(const PlyElement& element, const std::vector<Column>& columns,
                 const std::vector<std::string>& names) {
  Members members;
  for (const std::string& name : names) {
    const auto k = element.find(name);
    if (!k || !is_free(element, columns, *k)) return {};
    members.push_back(*k);
  }
  return members;
}

bool contains(const Members& members, std::size_t k) {
  for (const std::size_t member : members) {
    if (member == k) return true;
  }
  return false;
}

}  // namespace

const std::vector<KnownChannel>& known_channels() {
  static const std::vector<KnownChannel> known = {
      {"normal", {"nx", "ny", "nz"}},
      {"color", {"red", "green", "blue", "alpha"}},
      {"color", {"red", "green", "blue"}},
      {"texture", {"s", "t"}},
      {"texture", {"u", "v"}},
      {"texture", {"texture_u", "texture_v"}},
  };
  return known;
}

Column column_of(std::span<double> values, std::size_t part, std::size_t width) {
  return {values.empty() ? nullptr : values.data() + part, width, true};
}

template <class AnyChannel>
std::vector<AnyChannel> make_channels(const PlyElement& element, std::vector<Column>& columns) {
  std::vector<AnyChannel> channels;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (!is_free(element, columns, k)) continue;
    const PlyProperty& property = element.properties[k];
    AnyChannel channel{property.name, {property.name}, {}, property.type};
    Members members = {k};
    for (const KnownChannel& known : known_channels()) {
      Members all = find_all(element, columns, known.parts);
      if (!contains(all, k)) continue;
      channel.name = known.name;
      channel.parts = known.parts;
      members = std::move(all);
      break;
    }
    const std::size_t width = members.size();
    channel.values.resize(static_cast<std::size_t>(element.count) * width);
    for (std::size_t part = 0; part < width; ++part) {
      columns[members[part]] = column_of(channel.values, part, width);
      if (element.properties[members[part]].type != property.type) {
        channel.storage = Storage::float64;
      }
    }
    channels.push_back(std::move(channel));
  }
  return channels;
}

template std::vector<Channel> make_channels(const PlyElement&, std::vector<Column>&);
template std::vector<FaceChannel> make_channels(const PlyElement&, std::vector<Column>&);

}  // namespace surpass::io
