#include "surface_output.hpp"

#include "levels.hpp"

namespace surpass::cli {

void SurfaceOutput::define(Options& options, const std::string& and_of) {
  options
      .add("--surface", path_,
           "Also write the limit surface: the control mesh refined and moved to the limit")
      .type_name("FILE")
      .group("Surface");
  levels_option_ = add_levels(options, levels_,
                              "Refinement steps of --surface, from the control mesh on" + and_of)
                       .group("Surface");
}

Result<void> SurfaceOutput::check_given() const {
  if (wanted() || !levels_option_.given()) return {};
  return fail(ErrorCode::invalid_argument,
              "--levels is for --surface, which is not given; add --surface FILE, or leave it out");
}

Result<void> SurfaceOutput::check(const Mesh& control, Scheme scheme,
                                  const MeshOutput& output) const {
  if (!wanted()) return {};
  if (const auto fits = check_levels(control, levels_); !fits) return fits;
  return output.check_refined(control, scheme, levels_, path_);
}

Result<std::optional<Mesh>> SurfaceOutput::make(const Mesh& control, const Rules& rules,
                                                Session& session) const {
  if (!wanted()) return std::optional<Mesh>();
  Result<Mesh> refined =
      session.timed("refine", [&] { return limit_mesh(control, rules, levels_, session.context); });
  if (!refined) return tl::make_unexpected(refined.error());
  return std::optional<Mesh>(std::move(*refined));
}

Result<void> SurfaceOutput::write(const std::optional<Mesh>& surface, const MeshOutput& output,
                                  Session& session) const {
  return surface ? output.write(*surface, path_, session) : Result<void>();
}

}  // namespace surpass::cli
