#include "scheme/steps.hpp"

namespace surpass {
namespace {

// A channel with room for `rows` values.
Channel channel_like(const Channel& channel, Index rows) {
  return {channel.name, channel.parts, std::vector<double>(rows * channel.width()),
          channel.storage};
}

}  // namespace

void AppliedRows::expect(Index rows) {
  points_.resize(rows);
  for (const Channel& channel : from_.channels) channels_.push_back(channel_like(channel, rows));
}

void AppliedRows::take(Index first, const RowTile& rows) {
  const double* const x = flat(std::span(from_.points)).data();
  for (Index i = 0; i < rows.row_count(); ++i) points_[first + i] = rows.row(i).times_3(x);
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const std::size_t width = channels_[k].width();
    for (Index i = 0; i < rows.row_count(); ++i) {
      double* const y = channels_[k].values.data() + (std::size_t{first} + i) * width;
      rows.row(i).times(width, from_.channels[k].values.data(),
                        [&](std::size_t c, double product) { y[c] = product; });
    }
  }
}

void AppliedRows::put_into(Mesh& mesh) && {
  mesh.points = std::move(points_);
  mesh.channels = std::move(channels_);
}

void apply(const TiledRows& rows, const Mesh& from, Mesh& to, const Context& context) {
  to.points.resize(rows.row_count());
  rows.apply(context, 3, flat(std::span(from.points)), flat(std::span(to.points)));
  for (const Channel& channel : from.channels) {
    Channel& made = to.channels.emplace_back(channel_like(channel, rows.row_count()));
    rows.apply(context, channel.width(), channel.values, made.values);
  }
}

void Steps::move(Mesh& mesh, const SparseRows& rows, const Context& context) {
  mesh.points = rows.apply(context, mesh.points);
  for (Channel& channel : mesh.channels) {
    Channel moved = channel_like(channel, rows.row_count());
    rows.apply(context, channel.width(), channel.values, moved.values);
    channel = std::move(moved);
  }
  if (!keep_) return;
  make_rows(context, rows.row_count(), kept_.emplace_back(), [&](Index i, RowTile& tile) {
    const auto [columns, weights] = tile.add_row(rows.row_length(i));
    std::copy(rows.row_columns(i).begin(), rows.row_columns(i).end(), columns.begin());
    std::copy(rows.row_weights(i).begin(), rows.row_weights(i).end(), weights.begin());
  });
}

void Steps::pick(const std::vector<Index>& vertices, const Context& context) {
  if (!keep_) return;
  make_rows(context, static_cast<Index>(vertices.size()), kept_.emplace_back(),
            [&](Index i, RowTile& tile) {
              const auto [columns, weights] = tile.add_row(1);
              columns[0] = vertices[i];
              weights[0] = 1;  // exact: sums that begin with 0 are never -0
            });
}

}  // namespace surpass
