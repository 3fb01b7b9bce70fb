#include <surpass/refiner.hpp>

#include <fmt/format.h>

#include "scheme/subdivision_scheme.hpp"

namespace surpass {

struct Refiner::Impl {
  Index control_points = 0;
  Mesh mesh;
  std::vector<TiledRows> steps;
};

Refiner::Refiner(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Refiner::Refiner(Refiner&&) noexcept = default;
Refiner& Refiner::operator=(Refiner&&) noexcept = default;
Refiner::~Refiner() = default;

Result<Refiner> Refiner::create(const Mesh& control, const RefinerOptions& options,
                                const Context& context) {
  Steps steps(true);
  auto mesh = options.limit
                  ? limit_mesh(control, options.rules, options.levels, context, steps)
                  : surpass::refine(control, options.rules, options.levels, context, steps);
  if (!mesh) return tl::make_unexpected(mesh.error());
  auto impl = std::make_unique<Impl>();
  impl->control_points = control.vertex_count();
  impl->mesh = std::move(*mesh);
  impl->steps = std::move(steps).kept();
  return Refiner(std::move(impl));
}

const Mesh& Refiner::mesh() const { return impl_->mesh; }

Result<std::vector<Point>> Refiner::refine(std::span<const Point> points,
                                           const Context& context) const {
  std::vector<Point> refined(impl_->mesh.points.size());
  const auto done = refine(3, flat(points), flat(std::span(refined)), context);
  if (!done) return tl::make_unexpected(done.error());
  return refined;
}

Result<void> Refiner::refine(std::size_t width, std::span<const double> values,
                             std::span<double> refined, const Context& context) const {
  const auto& steps = impl_->steps;
  if (values.size() != width * impl_->control_points) {
    return fail(
        ErrorCode::mismatch,
        fmt::format("there are {} values; {} control points of {} each need {}", values.size(),
                    impl_->control_points, width, width * impl_->control_points));
  }
  if (refined.size() != width * impl_->mesh.points.size()) {
    return fail(ErrorCode::mismatch,
                fmt::format("there is room for {} values; {} refined vertices of {} each need {}",
                            refined.size(), impl_->mesh.points.size(), width,
                            width * impl_->mesh.points.size()));
  }
  if (steps.empty()) std::copy(values.begin(), values.end(), refined.begin());
  std::unique_ptr<double[]> between;  // the values of the level before, if not the given ones
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i + 1 == steps.size()) {
      steps[i].apply(context, width, values, refined);
      break;
    }
    const std::size_t count = width * steps[i].row_count();
    auto next = std::make_unique_for_overwrite<double[]>(count);
    steps[i].apply(context, width, values, {next.get(), count});
    values = {next.get(), count};
    between = std::move(next);
  }
  return {};
}

}  // namespace surpass
