// The native device's certificate against a replay on the CPU, in double, with exact coverage (tests/support/replay.h).
#include <cmath>

#include "image/native_scene.h"
#include "render/make_renderer.h"
#include "render/scene_sorter.h"
#include "support/meshes.h"
#include "support/replay.h"

namespace havs::test {
namespace {

struct Case {
  std::string name;
  TetMesh (*make)();
  bool touches = false;  ///< two parts, everywhere along a plane
};
inline void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

/// Orders that go wrong in their own ways: stretched cells, cycles, touching parts, shells in shells.
std::vector<Case> cases() {
  return {{"JitteredBox", [] { return withSmoothPoints(box(5, Cut::six, 0.25)); }},
          {"StretchedLayers", [] { return withSmoothPoints(stretchedLayers(8, 1.8)); }},
          {"TouchingBoxes", [] { return withSmoothPoints(twoBoxes(3, 0.0)); }, true},
          {"NestedShells", [] { return withSmoothPoints(nestedShells(2)); }},
          {"VisibilityCycle", [] { return withSmoothPoints(visibilityCycle()); }}};
}

Scene smallScene() {
  Scene scene;
  scene.width = 131;  // no whole stamps, no whole tiles
  scene.height = 102;
  scene.transferFunction = "viridis";  // every cell shows something
  scene.lookup = "post";
  scene.certificate = true;
  return scene;
}

/// The order that the native device comes to: refined where fragments come late.
ReplayResult replayed(const NativeScene& scene, const std::string& sort, int k) {
  const ViewPoint view = viewPointOf(scene.view);
  const auto sorter = makeSceneSorter(scene.prepared, sort, PartOrder::itsOwn);
  FaceOrder order;
  sorter->sort(view, order);
  auto run = [&] {
    return replay({.points = scene.prepared.points,
                   .faces = &scene.prepared.faces,
                   .order = order.faces,
                   .scalars = scene.prepared.scalars,
                   .view = scene.view},
                  k);
  };
  ReplayResult result = run();
  if (result.misordered > 0 && sorter->refine(view, order)) result = run();
  return result;
}

class NativeCertificate : public testing::TestWithParam<Case> {};

/// Coverage is exact in both, so that the same fragments come. Distances, of order 1, are off by some 2^-24 in float:
/// a fragment counts as late or not by chance where it is within a few 1e-7 of the tolerance, 1e-6. On these meshes,
/// whose cells are a tenth across, that is at most one late fragment of a thousand, or some where the order is right
/// but for ties. As many again are exits at the place of an entry: which of the two is nearer, and so whether the exit
/// is late, is chance where the mesh is thin, and at every pixel where parts touch, of which a few of a thousand
/// differ.
TEST_P(NativeCertificate, CountsWhatAReplayCounts) {
  Scene scene = smallScene();
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    scene.camera.projection = projection;
    const NativeScene drawn(scene, GetParam().make());
    for (const char* sort : {"topological", "centroid", "none"})
      for (int k = 1; k <= 14; ++k) {
        SCOPED_TRACE(std::string(sort) + ", k " + std::to_string(k));
        Scene asked = scene;
        asked.sort = sort;
        asked.k = k;
        const Certificate certificate = *drawn.drawAs(asked).certificate;
        const ReplayResult expected = replayed(drawn, sort, k);
        EXPECT_EQ(certificate.fragments, expected.fragments);
        const double touching = GetParam().touches ? 3e-3 * scene.width * scene.height : 0;
        const double allowed = 4 + 2e-3 * static_cast<double>(expected.misordered) + touching;
        EXPECT_NEAR(static_cast<double>(certificate.misordered), static_cast<double>(expected.misordered), allowed);
        EXPECT_NEAR(static_cast<double>(certificate.pixels), static_cast<double>(expected.misorderedPixels), allowed);
      }
  }
}

/// What the test above would not notice: a certificate that is always 0.
TEST(NativeCertificateOfNoOrder, IsNotZero) {
  Scene scene = smallScene();
  scene.sort = "none";
  const NativeScene drawn(scene, withSmoothPoints(box(5, Cut::six, 0.25)));
  const Certificate certificate = *drawn.draw().certificate;
  EXPECT_GT(certificate.misordered, certificate.fragments / 20);
}

/// A pixel whose fragments come in order has the same segments for every k. Where none is counted as
/// late, two may still have come in the wrong order within the tolerance, 1e-6, of each other: of k = 1 a segment of
/// length 0 takes the place of one of that length. So few pixels may differ, and by no more than 1e-5.
TEST_P(NativeCertificate, OneEntryIsEnoughWhereItIsZero) {
  Scene scene = smallScene();
  const NativeScene drawn(scene, GetParam().make());
  Scene one = scene;
  one.k = 1;
  const havs::Drawing narrow = drawn.drawAs(one), wide = drawn.draw();
  std::size_t exact = 0, same = 0;
  for (std::size_t i = 0; i < narrow.certificate->count.size(); ++i) {
    if (narrow.certificate->count[i] != 0) continue;
    ++exact;
    bool equal = true;
    for (std::size_t c = 4 * i; c < 4 * i + 4; ++c) {
      equal = equal && narrow.image.rgba[c] == wide.image.rgba[c];
      EXPECT_NEAR(narrow.image.rgba[c], wide.image.rgba[c], 1e-5);
    }
    same += equal ? 1 : 0;
  }
  EXPECT_GT(exact, narrow.certificate->count.size() / 2);
  EXPECT_GE(static_cast<double>(same), 0.99 * static_cast<double>(exact));
}

INSTANTIATE_TEST_SUITE_P(Meshes, NativeCertificate, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& row) { return row.param.name; });

}  // namespace
}  // namespace havs::test
