#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "mesh_samples.hpp"

namespace surpass {
namespace {

using samples::Face;

bool same_place(const Place& a, const Place& b) {
  return a.vertex == b.vertex && a.face == b.face && a.edge == b.edge;
}

std::vector<Error> of_code(const Diagnosis& diagnosis, ErrorCode code) {
  std::vector<Error> errors;
  std::copy_if(diagnosis.refusals.begin(), diagnosis.refusals.end(), std::back_inserter(errors),
               [code](const Error& e) { return e.code == code; });
  return errors;
}

// The remark that holds all the given words.
std::string remark(const Mesh& mesh, std::string_view words) {
  for (const std::string& text : diagnose(mesh).remarks) {
    if (text.find(words) != std::string::npos) return text;
  }
  return "";
}

TEST(Diagnose, SoundMeshesAreNotRefused) {
  for (const Mesh& mesh : {samples::cube(), samples::grid(3), samples::torus(5, 4, false), Mesh{},
                           samples::faces(3, {{0, 1, 2}, {0, 2, 1}})}) {
    const Diagnosis diagnosis = diagnose(mesh);
    EXPECT_TRUE(diagnosis.refusals.empty());
    EXPECT_EQ(diagnosis.refusal_count, 0U);
  }
  EXPECT_TRUE(diagnose(samples::cube()).remarks.empty());
}

TEST(Diagnose, FindsEveryKindAtOnce) {
  Mesh mesh = samples::faces(12, {{0, 1, 2},
                                  {1, 0, 3},
                                  {0, 1, 4},  // three at edge 0-1
                                  {5, 6, 7},
                                  {6, 7, 8},  // disagree at 6-7
                                  {9, 10},
                                  {9, 9, 10},
                                  {9, 10, 99}});
  mesh.points[11][1] = std::numeric_limits<double>::quiet_NaN();
  mesh.points[10][2] = std::numeric_limits<double>::infinity();
  const Diagnosis d = diagnose(mesh);
  EXPECT_EQ(d.refusal_count, 7U);
  ASSERT_EQ(d.refusals.size(), 7U);
  const std::vector<ErrorCode> codes{ErrorCode::degenerate_face,
                                     ErrorCode::repeated_vertex,
                                     ErrorCode::index_out_of_range,
                                     ErrorCode::non_manifold_edge,
                                     ErrorCode::inconsistent_orientation,
                                     ErrorCode::not_finite,
                                     ErrorCode::not_finite};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(d.refusals[i].code, codes[i]);
  EXPECT_EQ(d.refusals[0].place.face, 5U);
  EXPECT_EQ(d.refusals[1].place.face, 6U);
  EXPECT_EQ(d.refusals[1].place.vertex, 9U);
  EXPECT_EQ(d.refusals[2].place.face, 7U);
  EXPECT_EQ(d.refusals[3].place.edge, (std::array<Index, 2>{0, 1}));
  EXPECT_EQ(d.refusals[4].place.edge, (std::array<Index, 2>{6, 7}));
  EXPECT_EQ(d.refusals[5].place.vertex, 10U);
  EXPECT_EQ(d.refusals[6].place.vertex, 11U);
}

TEST(Diagnose, LimitsEachCodeButCountsAll) {
  std::vector<Face> list;
  for (Index i = 0; i < 25; ++i) list.push_back({i, i + 1});
  for (Index i = 0; i < 3; ++i) list.push_back({i, i, i + 1});
  const Diagnosis d = diagnose(samples::faces(30, list), 4);
  EXPECT_EQ(d.refusal_count, 28U);
  EXPECT_EQ(of_code(d, ErrorCode::degenerate_face).size(), 4U);
  EXPECT_EQ(of_code(d, ErrorCode::repeated_vertex).size(), 3U);
}

TEST(Diagnose, RepeatedFacesAreNamed) {
  Mesh mesh = samples::cube();
  mesh.add_face(Face{7, 5, 4, 6});  // backwards of face 1
  mesh.add_face(Face{1, 5, 4, 0});  // forwards of face 2
  const auto repeats = of_code(diagnose(mesh), ErrorCode::duplicate_face);
  ASSERT_EQ(repeats.size(), 2U);
  EXPECT_EQ(repeats[0].place.face, 6U);
  EXPECT_NE(repeats[0].message.find("face 1"), std::string::npos);
  EXPECT_EQ(repeats[1].place.face, 7U);
  EXPECT_NE(repeats[1].message.find("face 2"), std::string::npos);
}

TEST(Diagnose, AgreesWithTopologyOnRandomSoups) {
  int refused = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const Mesh mesh = samples::soup(seed);
    const auto topology = Topology::build(mesh);
    const Diagnosis d = diagnose(mesh, 1000);
    EXPECT_EQ(topology.has_value(), d.refusals.empty()) << seed;
    EXPECT_EQ(d.refusal_count, d.refusals.size());
    if (topology) continue;
    ++refused;
    EXPECT_TRUE(std::any_of(d.refusals.begin(), d.refusals.end(),
                            [&](const Error& e) {
                              return e.code == topology.error().code &&
                                     e.message == topology.error().message &&
                                     same_place(e.place, topology.error().place);
                            }))
        << seed << ": " << describe(topology.error());
  }
  EXPECT_GT(refused, 2000);
}

TEST(Remarks, NameTheElements) {
  EXPECT_EQ(remark(samples::faces(5, {{0, 1, 2}, {0, 3, 4}}), "bow-tie"),
            "1 vertex where several fans of faces meet (bow-ties), treated as infinitely sharp: 0");
  EXPECT_EQ(remark(samples::faces(6, {{0, 1, 4}}), "without faces"),
            "3 vertices without faces, kept and fixed: 2, 3, 5");
  EXPECT_EQ(remark(samples::faces(3, {{0, 1, 2}, {1, 0, 2}}), "back to back"),
            "1 face back to back with another, a closed surface without volume: 1 on 0");
  Mesh mesh = samples::faces(5, {{0, 1, 2}, {2, 1, 3}});
  mesh.points[3] = mesh.points[1];
  mesh.points[4] = mesh.points[0];
  EXPECT_NE(remark(mesh, "exactly the coordinates").find("3 on 1, 4 on 0"), std::string::npos);
  EXPECT_NE(remark(mesh, "zero length").find("1 edge of a face"), std::string::npos);
  EXPECT_NE(remark(mesh, "zero area").find("1 face of zero area up to rounding: 1"),
            std::string::npos);
  mesh.creases = {{{1, 0}, 2}, {{0, 3}, 2}};
  EXPECT_NE(remark(mesh, "no edge joins").find("1 crease "), std::string::npos);
  EXPECT_NE(remark(mesh, "no edge joins").find(": 0-3"), std::string::npos);
  EXPECT_EQ(remark(Mesh{}, "faces"), "the mesh has no faces");
}

TEST(Remarks, NeedlesAreNotFlatButCollinearFacesAre) {
  Mesh mesh = samples::faces(3, {{0, 1, 2}});
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}};
  EXPECT_EQ(remark(mesh, "zero area"), "");
  mesh.points = {{0, 0, 0}, {1, 3, 7}, {0.1, 0.3, 0.7}};
  EXPECT_NE(remark(mesh, "zero area"), "");
}

TEST(Remarks, ScaleThatDoublesCannotSquare) {
  Mesh mesh = samples::tetrahedron();
  const auto scaled = [&](double s) {
    Mesh m = mesh;
    for (Point& p : m.points) p = {p[0] * s, p[1] * s, p[2] * s};
    return m;
  };
  EXPECT_NE(remark(scaled(1e200), "overflow"), "");
  EXPECT_NE(remark(scaled(1e-310), "vanish"), "");
  EXPECT_NE(remark(scaled(0), "side 0"), "");
  EXPECT_EQ(remark(scaled(1e30), "squares"), "");
  EXPECT_EQ(remark(scaled(1e-30), "squares"), "");
}

}  // namespace
}  // namespace surpass
