#include <utility>

#include <fmt/format.h>

#include "mesh/select.hpp"
#include "scheme/nonstationary_checks.hpp"
#include "scheme/nonstationary_impl.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {

using nonstationary::State;

namespace {

/// Where targets lie; the other given vertices are met themselves.
std::vector<Point> aimed_points(const Mesh& mesh, const Topology& topology,
                                const std::vector<LineTarget>& targets) {
  std::vector<Point> aims = mesh.points;
  for (const LineTarget& target : targets) {
    Point centroid = {};
    const auto share = 1 / static_cast<double>(topology.valence(target.vertex));
    topology.for_each_outgoing(target.vertex, [&](Index h) {
      for (std::size_t c = 0; c < 3; ++c) {
        centroid[c] += share * mesh.points[topology.head(h)][c];
      }
    });
    for (std::size_t c = 0; c < 3; ++c) {
      aims[target.vertex][c] += target.along * (centroid[c] - mesh.points[target.vertex][c]);
    }
  }
  return aims;
}

}  // namespace

NonstationaryLoop::NonstationaryLoop(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NonstationaryLoop::NonstationaryLoop(NonstationaryLoop&&) noexcept = default;
NonstationaryLoop& NonstationaryLoop::operator=(NonstationaryLoop&&) noexcept = default;
NonstationaryLoop::~NonstationaryLoop() = default;

Result<NonstationaryLoop> NonstationaryLoop::create(const Mesh& control,
                                                    const NonstationaryOptions& options,
                                                    const Context& context) {
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while solving");
  if (auto ok = nonstationary::check_options(options, control.vertex_count()); !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto impl = std::make_unique<Impl>();
  impl->mesh = control;
  impl->state.options = options;
  auto around = impl->neighbourhood();
  if (!around) return tl::make_unexpected(around.error());
  const auto& [topology, sharpness] = *around;
  if (auto ok = nonstationary::check_mesh(control, topology, sharpness, options); !ok) {
    return tl::make_unexpected(ok.error());
  }
  State& state = impl->state;
  state.options.shape = nonstationary::allowed_shape(options, topology, sharpness, impl->notes);
  auto parameters = nonstationary::first_parameters(state.options, topology, sharpness);
  if (!parameters) return tl::make_unexpected(parameters.error());
  state.vertices = std::move(*parameters);
  if (options.rule == NonstationaryRule::mean) state.own = state.vertices;
  impl->aims = aimed_points(control, topology, options.targets);
  const bool curves = topology.boundary_edge_count() > 0 || !control.creases.empty();
  impl->first_step_is_its_own = options.rule == NonstationaryRule::quadratic || curves;
  if (curves && options.corners_at_folds && state.interpolates()) {
    if (auto ok = impl->make_corners_at_folds(*around, context); !ok) {
      return tl::make_unexpected(ok.error());
    }
  }
  return NonstationaryLoop(std::move(impl));
}

Result<NonstationaryLoop::Impl::Neighbourhood> NonstationaryLoop::Impl::neighbourhood() const {
  auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  auto sharpness = Sharpness::build(mesh, *topology, state.options.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  return Neighbourhood{std::move(*topology), std::move(*sharpness)};
}

Result<void> NonstationaryLoop::Impl::refine(const Context& context) {
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while subdividing");
  const auto around = neighbourhood();
  if (!around) return tl::make_unexpected(around.error());
  const Topology& topology = around->topology;
  const Sharpness& sharpness = around->sharpness;
  Steps steps;
  auto refined = steps.take(mesh, context, [&](RowSink& sink) {
    return nonstationary::refinement(state, mesh, topology, sharpness, context, sink);
  });
  if (!refined) return tl::make_unexpected(refined.error());
  if (!state.own.empty()) {
    std::vector<double>& own = state.own;
    const Index n = topology.vertex_count();
    own.resize(refined->points.size());
    for (Index e = 0; e < topology.edge_count(); ++e) {
      const auto [a, b] = topology.edge_vertices(e);
      own[n + e] = (own[a] + own[b]) / 2;
    }
    for (double& v : own) v = nonstationary::iterated(v, 1, state.options);
  }
  mesh = std::move(*refined);
  ++state.level;
  return {};
}

Result<NonstationaryLoop::Impl> NonstationaryLoop::Impl::at_limit(const Mesh& values,
                                                                  bool with_normals,
                                                                  const Context& context) const {
  if (state.level == 0 && first_step_is_its_own) {
    Impl next = *this;
    if (auto ok = next.refine(context); !ok) return tl::make_unexpected(ok.error());
    // `values` are those of the mesh, or its positions alone.
    if (values.channels.empty()) next.mesh.channels.clear();
    auto found = next.at_limit(next.mesh, with_normals, context);
    if (!found) return found;
    const Index n = mesh.vertex_count();
    found->mesh.points.resize(n);
    for (Channel& channel : found->mesh.channels) channel.values.resize(n * channel.width());
    if (with_normals) found->normals.resize(n);
    return found;
  }
  const auto around = neighbourhood();
  if (!around) return tl::make_unexpected(around.error());
  const auto& [topology, sharpness] = *around;
  Impl found;
  AppliedRows rows(values);
  nonstationary::limit_rows(state, topology, sharpness, context, rows);
  std::move(rows).put_into(found.mesh);
  if (with_normals) {
    found.normals = nonstationary::normals(state, mesh, topology, sharpness, context);
  }
  return found;
}

Result<void> NonstationaryLoop::refine(const Context& context) { return impl_->refine(context); }

int NonstationaryLoop::level() const { return impl_->state.level; }
const Mesh& NonstationaryLoop::mesh() const { return impl_->mesh; }
double NonstationaryLoop::shape() const { return impl_->state.options.shape; }
std::span<const double> NonstationaryLoop::vertex_parameters() const {
  return impl_->state.vertices;
}
const std::vector<std::string>& NonstationaryLoop::notes() const { return impl_->notes; }
const std::vector<Point>& NonstationaryLoop::aims() const { return impl_->aims; }

Result<std::vector<Point>> NonstationaryLoop::limit_positions(const Context& context) const {
  Mesh values;
  values.points = impl_->mesh.points;
  auto found = impl_->at_limit(values, false, context);
  if (!found) return tl::make_unexpected(found.error());
  return std::move(found->mesh.points);
}

Result<std::vector<Point>> NonstationaryLoop::limit_normals(const Context& context) const {
  Mesh values;
  values.points = impl_->mesh.points;
  auto found = impl_->at_limit(values, true, context);
  if (!found) return tl::make_unexpected(found.error());
  return std::move(found->normals);
}

Result<Mesh> NonstationaryLoop::limit_mesh(const Context& context) const {
  auto found = impl_->at_limit(impl_->mesh, true, context);
  if (!found) return tl::make_unexpected(found.error());
  Mesh mesh = impl_->mesh;
  mesh.points = std::move(found->mesh.points);
  mesh.channels = std::move(found->mesh.channels);
  add_limit_normals(mesh, found->normals);
  if (mesh.hole_faces.empty()) return mesh;
  return select(mesh, visible_part(mesh, impl_->state.given()));
}

}  // namespace surpass
