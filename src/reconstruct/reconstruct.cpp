// The steps from points to a mesh, in their order. What each does and why is in its own file.
#include <surpass/reconstruct.hpp>
#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "mesh/wording.hpp"
#include "reconstruct/advancing_front.hpp"
#include "reconstruct/clean_up.hpp"
#include "reconstruct/cloud.hpp"
#include "reconstruct/features.hpp"
#include "reconstruct/remarks.hpp"
#include "reconstruct/simplify.hpp"

namespace surpass {
namespace {

using namespace reconstruction;  // NOLINT(google-build-using-namespace): our own parts

constexpr double kSmoothFrom = 0.15;  // noise in spacings
constexpr double kSmoothTwiceFrom = 0.5;
constexpr double kBoundWithOutliers = 8;
constexpr double kUntie = 1e-4;        // spacings: nothing beside what scanners scatter
constexpr double kSmallPiece = 0.005;  // of the faces
constexpr std::size_t kBytesAPoint = 2400;
constexpr char kSource[] = "source";  // a channel while vertices change their numbers

Result<void> check(const ReconstructOptions& options) {
  const auto refuse = [](const char* what) {
    return fail(ErrorCode::invalid_argument, std::string(what));
  };
  if (options.perimeter && !(*options.perimeter >= 0)) {
    return refuse("the bound of perimeters must not be negative");
  }
  if (options.tolerance && !(*options.tolerance > 0)) {
    return refuse("the tolerance of a simplification must be positive");
  }
  if (options.vertices && *options.vertices < 4) {
    return refuse("a simplified mesh needs at least four vertices");
  }
  if (options.feature_angle && !(*options.feature_angle > 0 && *options.feature_angle < 180)) {
    return refuse("the feature angle must be between 0 and 180 degrees");
  }
  return {};
}

// So many unused points more or less do not matter.
std::size_t few_points(const ReconstructReport& report) {
  return (report.points - report.not_finite - report.duplicates) / 200;
}

// In boundary loops or unused points, and not worse in the other or by handles, which scatter
// makes.
bool is_better(const ReconstructReport& a, const ReconstructReport& b) {
  if (a.open_loops > b.open_loops) return false;
  if (a.open_loops + a.genus.value_or(0) > b.open_loops + b.genus.value_or(0)) return false;
  if (a.open_loops == b.open_loops) return a.unused + few_points(b) < b.unused;
  return a.unused <= b.unused + few_points(b);
}

Result<void> check_memory(std::size_t points) {
  const double needed = static_cast<double>(points) * kBytesAPoint;
  const double there =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= 0.9 * there) return {};
  return fail(ErrorCode::too_large,
              fmt::format("{} points need about {:.1f} GB of memory, but there are {:.1f} GB; take "
                          "fewer points",
                          points, needed / 1e9, there / 1e9));
}

class Run {
 public:
  Run(std::span<const Point> points, std::span<const Channel> channels,
      const ReconstructOptions& options, const Context& context)
      : given_(points), channels_(channels), options_(options), context_(context) {}

  Result<Reconstruction> run() {
    for (const auto step : {&Run::clean_points, &Run::leave_out_outliers, &Run::measure,
                            &Run::smooth_points, &Run::connect, &Run::clean_mesh,
                            &Run::try_without_smoothing, &Run::simplify_mesh, &Run::finish}) {
      if (const auto done = (this->*step)(); !done) return tl::make_unexpected(done.error());
      if (context_.cancelled()) {
        return fail(ErrorCode::cancelled, "the reconstruction was interrupted");
      }
    }
    count_parts(result_.mesh, report());
    add_warnings(share_of_sheets_, options_.vertices, result_.mesh.vertex_count(), report());
    return std::move(result_);
  }

 private:
  Result<void> clean_points();
  Result<void> leave_out_outliers();
  Result<void> meet_neighbours();
  Result<void> measure();
  Result<void> smooth_points();
  Result<void> connect();
  Result<void> clean_mesh();
  Result<void> make_manifold();
  Result<void> try_without_smoothing();
  Result<void> simplify_mesh();
  Result<void> finish();
  void note_unused();
  void carry_channels();
  [[nodiscard]] std::size_t points_without(const Channel& channel) const;
  [[nodiscard]] std::vector<Point> given_normals() const;
  [[nodiscard]] ReconstructReport& report() { return result_.report; }

  std::span<const Point> given_;
  std::span<const Channel> channels_;
  const ReconstructOptions& options_;
  const Context& context_;
  Cloud cloud_;
  std::vector<Index> distinct_;  // the given points that are finite and no repetitions
  std::optional<Neighbours> neighbours_;
  double spacing_ = 0;  // in the cloud's box, as all lengths here
  double share_of_sheets_ = 0;
  std::vector<Point> smoothed_;  // empty if they are not
  ReconstructReport before_connecting_;
  Mesh mesh_;  // its points are in the cloud's box
  Features features_;
  Reconstruction result_;
};

Result<void> Run::clean_points() {
  context_.report({.stage = "clean"});
  Result<Cloud> cloud = clean(given_);
  if (!cloud) return tl::make_unexpected(cloud.error());
  cloud_ = std::move(*cloud);
  report().points = given_.size();
  report().not_finite = cloud_.not_finite;
  report().duplicates = cloud_.duplicates;
  report().box_side = cloud_.box_side;
  distinct_ = cloud_.source;
  return check_memory(cloud_.points.size());
}

Result<void> Run::leave_out_outliers() {
  if (options_.outliers == Choice::off) return {};
  if (const auto met = meet_neighbours(); !met) return met;
  auto found =
      find_outliers(cloud_, *neighbours_, spacing_, options_.outliers == Choice::on, context_);
  if (!found) return tl::make_unexpected(found.error());
  report().outliers = static_cast<std::size_t>(std::count(found->begin(), found->end(), 1));
  if (report().outliers == 0) return {};
  if (cloud_.points.size() - report().outliers < 4) {
    return fail(ErrorCode::empty_mesh, "all points stand alone; try without leaving out outliers");
  }
  for (unsigned char& f : *found) f = f == 0 ? 1 : 0;
  neighbours_.reset();
  cloud_ = subset(cloud_, *found);
  return {};
}

// Of the cloud as it is now: where no outlier is left out, those of the step before serve again.
Result<void> Run::meet_neighbours() {
  if (neighbours_) return {};
  neighbours_.emplace(cloud_.points);
  const Result<double> spacing = spacing_of(cloud_, *neighbours_, context_);
  if (!spacing) return tl::make_unexpected(spacing.error());
  spacing_ = *spacing;
  return {};
}

Result<void> Run::measure() {
  if (const auto met = meet_neighbours(); !met) return met;
  const Result<Roughness> rough = roughness_of(cloud_, *neighbours_, spacing_, context_);
  neighbours_.reset();
  if (!rough) return tl::make_unexpected(rough.error());
  share_of_sheets_ = rough->share_of_sheets;
  report().spacing = spacing_;
  report().noise = rough->noise;
  report().sheet_gap = rough->sheet_gap;
  return {};
}

Result<void> Run::smooth_points() {
  // Smoothing would pull two sheets that near into one.
  constexpr double kManySheets = 0.2;
  const double noise = report().noise.value_or(0);
  const bool needed = noise > kSmoothFrom && share_of_sheets_ < kManySheets;
  const bool wanted =
      options_.smoothing == Choice::on || (options_.smoothing == Choice::automatic && needed);
  if (!wanted || cloud_.points.size() < 7) return {};
  report().smoothing_passes = noise > kSmoothTwiceFrom ? 3 : 1;
  Result<std::vector<Point>> moved = smooth(cloud_, report().smoothing_passes, context_);
  if (!moved) return tl::make_unexpected(moved.error());
  smoothed_ = std::move(*moved);
  report().smoothed_positions = options_.positions == Positions::smoothed ||
                                (options_.positions == Positions::automatic && noise >= kMuchNoise);
  return {};
}

Result<void> Run::connect() {
  before_connecting_ = report();
  report().perimeter = options_.perimeter.value_or(report().outliers > 0 ? kBoundWithOutliers : 0);
  const std::vector<Point> sites =
      untied(smoothed_.empty() ? cloud_.points : smoothed_, kUntie * spacing_);
  const auto triangles = advancing_front(sites, report().perimeter * spacing_, context_);
  if (!triangles) return tl::make_unexpected(triangles.error());
  if (triangles->empty()) {
    return fail(ErrorCode::unsuitable_for_scheme,
                "the points span no surface: they lie on one line, or too far apart for the bound "
                "of the perimeter");
  }
  mesh_.points = report().smoothed_positions ? smoothed_ : cloud_.points;
  for (const auto& triangle : *triangles) mesh_.add_face(triangle);
  Channel source{kSource, {kSource}, {}};
  for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
    source.values.push_back(static_cast<double>(v));
  }
  mesh_.channels = {std::move(source)};
  // At once, so that nothing that follows depends on the sides that the front happened to take.
  orient_pieces(mesh_, given_normals());
  return {};
}

// The front's triangles always were so far, but nothing proves it.
Result<void> Run::make_manifold() {
  if (Topology::build(mesh_)) return {};
  Mended mended = repair(mesh_);
  for (const std::string& sentence : mended.done) report().warnings.push_back(sentence);
  mesh_ = std::move(mended.mesh);
  const auto topology = Topology::build(mesh_);
  return topology ? Result<void>() : tl::make_unexpected(topology.error());
}

Result<void> Run::clean_mesh() {
  const double faces = mesh_.face_count();
  const bool rough = report().outliers > 0 || report().noise.value_or(0) > kMuchNoise;
  report().dropped_pieces =
      drop_small_pieces(mesh_, rough ? kSmallPiece : std::min(kSmallPiece, 10 / faces));
  if (const auto made = make_manifold(); !made) return made;
  const Index unfilled = mesh_.face_count();
  Result<Holes> holes = fill_holes(mesh_, options_.close, context_);
  if (!holes) return tl::make_unexpected(holes.error());
  if (holes->filled > 0 && !Topology::build(mesh_)) {  // a loop through a vertex twice, perhaps
    mesh_.face_vertices.resize(mesh_.face_offsets[unfilled]);
    mesh_.face_offsets.resize(unfilled + 1);
    holes = Holes{0, holes->filled + holes->left};
  }
  report().filled_loops = holes->filled;
  report().open_loops = holes->left;
  mesh_ = drop_isolated_vertices(mesh_).mesh;
  orient_pieces(mesh_, given_normals());
  report().full_vertices = mesh_.vertex_count();
  note_unused();
  return {};
}

// Of a mesh that is closed and uses all points there is none better; else both are made.
Result<void> Run::try_without_smoothing() {
  const bool may_be_better =
      report().open_loops > 0 || report().unused > report().outliers + few_points(report());
  if (options_.smoothing != Choice::automatic || smoothed_.empty() || !may_be_better) return {};
  count_parts(mesh_, report());
  const ReconstructReport with = report();
  Mesh mesh = std::exchange(mesh_, {});
  std::vector<Index> unused = std::exchange(result_.unused, {});
  std::vector<Point> points = std::exchange(smoothed_, {});
  report() = before_connecting_;
  report().smoothing_passes = 0;
  report().smoothed_positions = false;
  auto done = connect();
  if (done) done = clean_mesh();
  if (!done && done.error().code == ErrorCode::cancelled) return done;
  if (done) count_parts(mesh_, report());
  if (done && is_better(report(), with)) {
    report().warnings.push_back(fmt::format(
        "the points are not smoothed, although they scatter: that would leave {} and {}, "
        "not {} and {}",
        counted(with.open_loops, "boundary loop", "boundary loops"),
        counted(with.unused, "unused point", "unused points"), report().open_loops,
        report().unused));
    return {};
  }
  report() = with;
  mesh_ = std::move(mesh);
  result_.unused = std::move(unused);
  smoothed_ = std::move(points);
  return {};
}

// Of the mesh's vertices, where every point came with one.
std::vector<Point> Run::given_normals() const {
  for (const Channel& channel : channels_) {
    if (channel.name != "normal" || channel.width() != 3) continue;
    std::vector<Point> normals;
    for (const double v : mesh_.channels.front().values) {
      const double* n = &channel.values[3 * cloud_.source[static_cast<std::size_t>(v)]];
      if (!std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2])) return {};
      normals.push_back({n[0], n[1], n[2]});
    }
    return normals;
  }
  return {};
}

void Run::note_unused() {
  std::vector<unsigned char> used(given_.size(), 0);
  for (const double v : mesh_.channels.front().values) {
    used[cloud_.source[static_cast<std::size_t>(v)]] = 1;
  }
  for (const Index i : distinct_) {
    if (used[i] == 0) result_.unused.push_back(i);
  }
  report().unused = result_.unused.size();
}

Result<void> Run::simplify_mesh() {
  const auto topology = Topology::build(mesh_);
  if (!topology) return tl::make_unexpected(topology.error());
  if (options_.feature_angle) {
    features_ = find_features(mesh_, *topology, *options_.feature_angle);
  }
  if (!options_.tolerance && !options_.vertices) return {};
  Result<Simplified> simple =
      simplify_and_measure(mesh_, features_, options_.tolerance, options_.vertices, context_);
  if (!simple) return tl::make_unexpected(simple.error());
  report().polyhedron_max = simple->distances.max;
  report().polyhedron_rms = simple->distances.rms;
  mesh_ = std::move(simple->mesh);
  features_ = std::move(simple->features);
  return {};
}

// Files have no place for them, and no renderer a use.
std::size_t Run::points_without(const Channel& channel) const {
  const std::size_t width = channel.width();
  return static_cast<std::size_t>(std::count_if(distinct_.begin(), distinct_.end(), [&](Index i) {
    const double* row = channel.values.data() + i * width;
    return !std::all_of(row, row + width, [](double x) { return std::isfinite(x); });
  }));
}

void Run::carry_channels() {
  for (const Channel& channel : channels_) {
    const std::size_t width = channel.width();
    if (const std::size_t without = points_without(channel); without > 0) {
      report().warnings.push_back(
          fmt::format("the channel '{}' is left out: at {} of {} points it is not finite",
                      channel.name, without, distinct_.size()));
      continue;
    }
    Channel carried{channel.name, channel.parts, {}, channel.storage};
    carried.values.reserve(result_.source.size() * width);
    for (const Index i : result_.source) {
      const auto row = channel.values.begin() + static_cast<std::ptrdiff_t>(i * width);
      carried.values.insert(carried.values.end(), row, row + static_cast<std::ptrdiff_t>(width));
    }
    result_.mesh.channels.push_back(std::move(carried));
  }
}

Result<void> Run::finish() {
  Mesh& mesh = result_.mesh;
  for (const auto& edge : features_.creases) mesh_.creases.push_back({edge, kInfinitelySharp});
  for (const Index v : features_.corners) mesh_.corners.push_back({v, kInfinitelySharp});
  mesh = drop_isolated_vertices(mesh_).mesh;
  const Box box = [&] {
    std::vector<Point> finite;
    for (const Index i : cloud_.source) finite.push_back(given_[i]);
    return bounding_box(finite);
  }();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto own = static_cast<std::size_t>(mesh.channels.front().values[v]);
    result_.source.push_back(cloud_.source[own]);
    Point& p = mesh.points[v];
    if (!report().smoothed_positions) p = given_[cloud_.source[own]];
    for (std::size_t k = 0; report().smoothed_positions && k < 3; ++k) {
      p[k] = box.low[k] + cloud_.box_side * p[k];
    }
  }
  mesh.channels.clear();
  carry_channels();
  return {};
}

Result<void> check_channels(std::span<const Channel> channels, std::size_t points) {
  for (const Channel& channel : channels) {
    if (channel.values.size() == points * channel.width()) continue;
    return fail(
        ErrorCode::mismatch,
        fmt::format("channel '{}' has {} numbers, but {} points of {} each need {}", channel.name,
                    channel.values.size(), points, channel.width(), points * channel.width()));
  }
  return {};
}

}  // namespace

Result<Reconstruction> reconstruct(std::span<const Point> points, std::span<const Channel> channels,
                                   const ReconstructOptions& options, const Context& context) {
  if (const auto fine = check(options); !fine) return tl::make_unexpected(fine.error());
  if (const auto fine = check_channels(channels, points.size()); !fine) {
    return tl::make_unexpected(fine.error());
  }
  if (points.size() >= kNone) return fail(ErrorCode::too_large, "more than 4294967294 points");
  return Run(points, channels, options, context).run();
}

}  // namespace surpass
