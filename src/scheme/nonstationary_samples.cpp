// In a ring of six every mode goes on by itself. First derivatives are those that Loop's rules see:
// their factor is 1/2 at every level. Second ones are Loop's times the product of what each level
// still adds: one for the Laplacian, one for the rest.
#include "scheme/nonstationary_samples.hpp"

#include <algorithm>

#include "scheme/nonstationary_impl.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {
namespace {

using nonstationary::BendFactors;
using nonstationary::State;

class Jets {
 public:
  Jets(const State& state, const LimitSamples& samples, const Topology& topology,
       const Sharpness& sharpness, const std::vector<Point>& limits)
      : state_(state),
        samples_(samples),
        topology_(topology),
        sharpness_(sharpness),
        limits_(limits),
        loop_(scheme_of(Scheme::loop)),
        born_(nonstationary::bend_factors(state.beta(), state.beta(), state.options)) {}

  /// A ring that lies at a bent edge, or whose edges have parameters of their own, has no modes of
  /// its own.
  [[nodiscard]] Spot spot(Index v) const {
    const Spot spot = loop_.spot(topology_, sharpness_, v);
    if (spot != Spot::regular) return spot;
    if (!state_.own.empty()) return Spot::extraordinary;
    bool bent = false;
    topology_.for_each_outgoing(v, [&](Index h) {
      const Index w = topology_.head(h);
      if (w >= state_.given() || sharpness_.is_plain(w)) return;
      bent = bent || bent_edge(state_, topology_, sharpness_, v, w).has_value();
    });
    return bent ? Spot::extraordinary : Spot::regular;
  }

  [[nodiscard]] LimitJet jet(Index v) const {
    LimitJet jet = loop_.jet(samples_.mesh, topology_, v);
    jet.position = Eigen::Map<const Eigen::Vector3d>(limits_[v].data());
    const BendFactors factors =
        v < state_.given()
            ? nonstationary::bend_factors(state_.alpha(v), state_.beta(), state_.options)
            : born_;
    const Eigen::Vector3d mean = factors.laplacian / 2 * (jet.uu + jet.vv);
    const Eigen::Vector3d rest = factors.deviator / 2 * (jet.uu - jet.vv);
    jet.uu = mean + rest;
    jet.vv = mean - rest;
    jet.uv *= factors.deviator;
    return jet;
  }

 private:
  const State& state_;
  const LimitSamples& samples_;
  const Topology& topology_;
  const Sharpness& sharpness_;
  const std::vector<Point>& limits_;
  const SubdivisionScheme& loop_;
  BendFactors born_;
};

void add_visible_patches(LimitSamples& samples, const std::vector<Point>& limits) {
  const std::vector<Index>& holes = samples.mesh.hole_faces;
  for (Index f = 0; f < samples.mesh.face_count(); ++f) {
    if (std::binary_search(holes.begin(), holes.end(), f)) continue;
    const auto face = samples.mesh.face(f);
    samples.add_patch(face, polygon_area(limits, face));
  }
}

}  // namespace

Result<LimitSamples> nonstationary_samples(const Mesh& control, const NonstationaryOptions& options,
                                           int levels, const Context& context) {
  auto surface = NonstationaryLoop::create(control, options, context);
  if (!surface) return tl::make_unexpected(surface.error());
  for (int level = 0; level < levels; ++level) {
    if (auto ok = surface->refine(context); !ok) return tl::make_unexpected(ok.error());
  }
  const auto limits = surface->limit_positions(context);
  if (!limits) return tl::make_unexpected(limits.error());
  const auto around = surface->impl().neighbourhood();
  if (!around) return tl::make_unexpected(around.error());
  const auto& [topology, sharpness] = *around;

  LimitSamples samples;
  samples.mesh = surface->mesh();
  samples.patch_measure = scheme_of(Scheme::loop).patch_measure();
  samples.spots.resize(topology.vertex_count());
  samples.jets.resize(topology.vertex_count());
  const Jets jets(surface->impl().state, samples, topology, sharpness, *limits);
  parallel::for_ranges(context, samples.spots.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      samples.spots[i] = jets.spot(v);
      if (samples.spots[i] == Spot::regular) samples.jets[i] = jets.jet(v);
    }
  });
  add_visible_patches(samples, *limits);
  return samples;
}

}  // namespace surpass
