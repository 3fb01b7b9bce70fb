#include <memory>

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>

#include "osd.hpp"
#include "osd_refiner.hpp"

namespace surpass::test {

namespace Bfr = OpenSubdiv::Bfr;

std::vector<OsdJet> osd_jets(const Mesh& mesh, const Rules& rules) {
  const auto refiner = osd_refiner(mesh, rules, 0);
  const Bfr::RefinerSurfaceFactory<> factory(*refiner);
  Bfr::Surface<double> surface;
  std::vector<OsdJet> jets;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!factory.InitVertexSurface(static_cast<int>(f), &surface)) continue;
    std::vector<double> patch(3 * static_cast<std::size_t>(surface.GetNumPatchPoints()));
    surface.PreparePatchPoints(mesh.points.front().data(), {3, 3}, patch.data(), {3, 3});
    OsdJet jet;
    jet.face = f;
    jet.is_regular = surface.IsRegular();
    const double corner[2] = {0, 0};
    surface.Evaluate(corner, patch.data(), {3, 3}, jet.position.data(), jet.du.data(),
                     jet.dv.data(), jet.duu.data(), jet.duv.data(), jet.dvv.data());
    jets.push_back(jet);
  }
  return jets;
}

}  // namespace surpass::test
