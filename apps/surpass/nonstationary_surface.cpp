#include "nonstationary_surface.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "evaluator.hpp"
#include "levels.hpp"
#include "solve_report.hpp"

namespace surpass::cli {

namespace {

struct Subdivided {
  NonstationaryLoop loop;
  Mesh surface;               ///< on the limit
  std::optional<Mesh> shown;  ///< by a page, where that is less
};

Result<Subdivided> subdivide(const Mesh& given, const NonstationarySurface& wanted,
                             Session& session) {
  // A page gets what it can hold, on the way to what is written.
  const bool paged = wanted.page.wanted();
  const int shown_levels = paged ? std::min(wanted.levels, HtmlReport::shown_levels(given)) : 0;
  auto made = wanted.scheme.refined(given, wanted.rules, 0, shown_levels, session);
  if (!made) return tl::make_unexpected(made.error());
  std::optional<Mesh> shown;
  if (paged && shown_levels < wanted.levels) {
    Result<Mesh> limit = made->limit_mesh(session.context);
    if (!limit) return tl::make_unexpected(limit.error());
    shown = std::move(*limit);
  }
  if (const auto done = Nonstationary::refine(*made, wanted.levels, session); !done) {
    return tl::make_unexpected(done.error());
  }
  Result<Mesh> surface = session.timed("refine", [&] { return made->limit_mesh(session.context); });
  if (!surface) return tl::make_unexpected(surface.error());
  forget_rules(*surface);
  return Subdivided{std::move(*made), std::move(*surface), std::move(shown)};
}

Result<Verdict> verify(const Subdivided& made, const MeshOutput& output, Session& session) {
  const auto certify = [&](std::span<const Point> points) {
    const std::span<const Point> own = points.first(made.loop.aims().size());
    return session.timed("verify",
                         [&] { return compare_points(own, made.loop.aims(), "surpass"); });
  };
  const Result<Certificate> exact = certify(made.surface.points);
  if (!exact) return tl::make_unexpected(exact.error());
  session.report["error"] = {{"max", exact->max}, {"mean", exact->mean}};
  Verdict verdict{*exact, {}, {}};
  if (output.rounds()) {
    const Result<Certificate> stored = certify(output.stored(made.surface.points));
    if (!stored) return tl::make_unexpected(stored.error());
    session.report["error_stored"] = certificate_json(*stored);
    verdict.stored = *stored;
  }
  return verdict;
}

Result<void> write(const Mesh& given, Subdivided made, MeshOutput& output, HtmlReport& page,
                   Session& session) {
  if (const auto done = output.write(made.surface, session); !done) return done;
  if (!page.wanted()) return {};
  page.add("given", "Given mesh", LayerKind::mesh, given);
  page.mark(given.points);
  const auto added = page.add_surface(
      "surface", "Surface", made.shown ? std::move(*made.shown) : made.surface, session.context);
  return added ? page.write(session) : added;
}

void say(const Mesh& given, const Subdivided& made, const Verdict& verdict,
         const NonstationarySurface& wanted, Session& session) {
  session.console.say(fmt::format("{}: {} vertices, {}, {}", wanted.input, given.vertex_count(),
                                  kNonstationaryLoop, wanted.scheme.summary(made.loop)));
  session.console.say(
      fmt::format("error {:.3g} of the box side (mean {:.3g}){}; {} faces, {:.3g} s",
                  verdict.exact.max, verdict.exact.mean,
                  verdict.stored ? fmt::format("; {:.3g} as stored", verdict.stored->max) : "",
                  made.surface.face_count(), session.seconds()));
}

}  // namespace

Result<void> write_nonstationary_surface(const Mesh& given, const NonstationarySurface& wanted,
                                         Session& session) {
  session.report["method"] = "nonstationary";
  session.report["levels"] = wanted.levels;
  if (const auto checked = check_levels(given, wanted.levels); !checked) return checked;
  Result<Subdivided> made = subdivide(given, wanted, session);
  if (!made) return tl::make_unexpected(made.error());
  const Result<Verdict> verdict = verify(*made, wanted.output, session);
  if (!verdict) return tl::make_unexpected(verdict.error());
  const double error = verdict->exact.max;
  const double side = bounding_box(given.points).side();
  const double tolerance =
      floored_tolerance(wanted.tolerance, flat(given.points), side > 0 ? side : 1);
  const bool reached = error <= tolerance;
  session.report["tolerance"] = tolerance;
  session.report["converged"] = reached;
  const bool written = reached || wanted.keep_best;
  if (written) {
    session.console.note(
        "there is no other control mesh than the given one; what is written is the surface");
  }
  say(given, *made, *verdict, wanted, session);
  if (written) {
    const auto done = write(given, std::move(*made), wanted.output, wanted.page, session);
    if (!done) return done;
  }
  if (reached) return {};
  return fail(ErrorCode::not_converged,
              fmt::format("the surface misses the given vertices by {:.3g} of the box side, more "
                          "than the tolerance {:.3g}; rules that interpolate are those without "
                          "--uniform, --rule mean",
                          error, tolerance));
}

}  // namespace surpass::cli
