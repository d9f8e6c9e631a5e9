// The order certificate against a replay on the CPU of the very fragments that were drawn, pixel by pixel.
#include <gtest/gtest.h>

#include <iostream>
#include <numeric>

#include "gl/captured_fragments.h"
#include "gl/drawing.h"
#include "mesh/read.h"
#include "render/gl/renderers.h"
#include "support/fragments.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr int kSizes[] = {1, 2, 3, 6, 14};
constexpr const char* kSorts[] = {"centroid", "topological", "none"};

struct Case {
  std::string name;
  TetMesh mesh;
};

TetMesh withSmoothField(TetMesh mesh) {
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

/// Orders that go wrong in their own ways: stretched cells, cycles, touching parts, shells in shells.
std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"box", box(5, Cut::six, 0.25)});
  all.push_back({"stretched", stretchedLayers(8, 1.8)});
  all.push_back({"touching", twoBoxes(3, 0.0)});
  all.push_back({"shells", nestedShells(1)});
  all.push_back({"cycle", visibilityCycle()});
  for (Case& c : all) c.mesh = withSmoothField(std::move(c.mesh));
  return all;
}

Scene smallScene() {
  Scene scene;
  scene.width = 130;  // two whole tiles of llvmpipe and a rest
  scene.height = 100;
  scene.lookup = "post";
  scene.certificate = true;
  return scene;
}

struct Prepared {
  PreparedScene scene;
  View view;
};

Prepared prepare(const Scene& scene, TetMesh mesh) {
  StageTimes stages;
  Prepared prepared{prepareScene(scene, std::move(mesh), stages), {}};
  prepared.view = makeView(scene.camera, prepared.scene.frame, scene.width, scene.height);
  return prepared;
}

havs::Drawing drawPrepared(const Device& device, const Scene& scene, const Prepared& prepared) {
  StageTimes stages;
  const RenderPlan chosen = plan(scene, prepared.scene.facts(), capabilitiesOf(device));
  return makeRenderer(prepared.scene, chosen, stages)->draw(prepared.view, stages);
}

std::vector<std::uint32_t> replayed(const CapturedPicture& picture, const std::string& sort, int k) {
  std::vector<std::uint32_t> counts;
  for (const auto& fragments : picture) counts.push_back(countLate(fragments, sort, k));
  return counts;
}

std::size_t fragmentsOf(const CapturedPicture& picture) {
  std::size_t sum = 0;
  for (const auto& fragments : picture) sum += fragments.size();
  return sum;
}

/// The counts of `certificate` are those of the replay in every pixel, and its sums are theirs.
void expectReplayed(const Certificate& certificate, const CapturedPicture& picture, const std::string& sort, int k) {
  const auto expected = replayed(picture, sort, k);
  EXPECT_EQ(certificate.count, expected);
  EXPECT_EQ(certificate.misordered, std::accumulate(expected.begin(), expected.end(), std::size_t{0}));
  EXPECT_EQ(certificate.pixels,
            static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), [](auto n) { return n > 0; })));
  EXPECT_EQ(certificate.fragments, fragmentsOf(picture));
}

class OrderCertificate : public FramebufferFetch {};

TEST_P(OrderCertificate, CountsWhatAReplayOfItsFragmentsCounts) {
  for (const Case& c : cases()) {
    Scene scene = smallScene();
    const Prepared prepared = prepare(scene, c.mesh);
    for (const char* sort : kSorts) {
      const CapturedPicture picture = captureFragments(prepared.scene, prepared.view, sort);
      scene.sort = sort;
      for (int k : kSizes) {
        SCOPED_TRACE(c.name + ", " + sort + ", k " + std::to_string(k));
        scene.k = k;
        expectReplayed(*drawPrepared(*device_, scene, prepared).certificate, picture, sort, k);
      }
    }
  }
}

// What the tests above would not notice: a certificate that is zero everywhere.
TEST_P(OrderCertificate, NumberedFacesAreOutOfOrderAndTopologicalOnesAreNot) {
  Scene scene = smallScene();
  const Prepared prepared = prepare(scene, withSmoothField(box(5, Cut::six, 0.25)));
  scene.k = 1;
  const Certificate ordered = *drawPrepared(*device_, scene, prepared).certificate;
  // On faces seen nearly edge on, float distances are off by more than the tolerance of 1e-6.
  EXPECT_LT(ordered.misordered, ordered.fragments / 1000);
  scene.k = 6;
  EXPECT_EQ(drawPrepared(*device_, scene, prepared).certificate->misordered, 0u);
  scene.sort = "none";
  const Certificate certificate = *drawPrepared(*device_, scene, prepared).certificate;
  EXPECT_GT(certificate.misordered, certificate.fragments / 20);
  EXPECT_GT(certificate.pixels, 1000u);
}

// llvmpipe drops what lies under opaque triangles that cover a whole 64 x 64 tile, counts included; faces of the
// k-buffer read the framebuffer and are not opaque (docs/llvmpipe.md).
TEST_P(OrderCertificate, FacesThatCoverWholeTiles) {
  Scene scene = smallScene();
  scene.width = scene.height = 256;
  scene.camera.zoom = 6;
  scene.sort = "none";
  const Prepared prepared = prepare(scene, withSmoothField(box(2)));
  const CapturedPicture picture = captureFragments(prepared.scene, prepared.view, scene.sort);
  for (int k : kSizes) {
    SCOPED_TRACE(k);
    scene.k = k;
    expectReplayed(*drawPrepared(*device_, scene, prepared).certificate, picture, scene.sort, k);
  }
  scene.k = 1;
  EXPECT_GT(drawPrepared(*device_, scene, prepared).certificate->pixels, 256u * 256 / 2);
}

TEST_P(OrderCertificate, CellData) {
  TetMesh mesh = stretchedLayers(6, 1.6);
  Field field{"c", 1, {}};
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) field.values.push_back(static_cast<double>(c % 7));
  mesh.cellFields = {field};
  Scene scene = smallScene();
  scene.sort = "centroid";
  scene.k = 2;
  const Prepared prepared = prepare(scene, std::move(mesh));
  expectReplayed(*drawPrepared(*device_, scene, prepared).certificate,
                 captureFragments(prepared.scene, prepared.view, scene.sort), scene.sort, scene.k);
}

TEST_P(OrderCertificate, CompositedLateFragmentsAreCountedAsDroppedOnes) {
  Scene scene = smallScene();
  scene.sort = "none";
  scene.k = 2;
  const Prepared prepared = prepare(scene, withSmoothField(stretchedLayers(6, 1.6)));
  const Certificate dropped = *drawPrepared(*device_, scene, prepared).certificate;
  scene.compositeLate = true;
  const Certificate composited = *drawPrepared(*device_, scene, prepared).certificate;
  EXPECT_GT(dropped.misordered, 0u);
  EXPECT_EQ(composited.count, dropped.count);  // a late one passes through the buffer and leaves it as it was
}

// A pixel that is done looks at no fragment, so none of them is late.
TEST_P(OrderCertificate, EarlyTerminationCountsOnlyWhatIsLookedAt) {
  Scene scene = smallScene();
  scene.sort = "centroid";
  scene.k = 1;
  const TransferFile transfer(constantTransfer(20));  // most segments are opaque
  scene.transferFunction = transfer.path();
  const Prepared prepared = prepare(scene, withSmoothField(stretchedLayers(8, 1.8)));
  const Certificate whole = *drawPrepared(*device_, scene, prepared).certificate;
  scene.earlyTermination = 0.5;
  const Certificate cut = *drawPrepared(*device_, scene, prepared).certificate;
  EXPECT_LT(cut.fragments, whole.fragments);
  EXPECT_LT(cut.misordered, whole.misordered);
  for (std::size_t i = 0; i < whole.count.size(); ++i) ASSERT_LE(cut.count[i], whole.count[i]);
}

TEST_P(OrderCertificate, TilesAddUp) {
  Scene scene = smallScene();
  scene.sort = "none";
  scene.k = 2;
  const Prepared prepared = prepare(scene, withSmoothField(box(5, Cut::six, 0.25)));
  StageTimes stages;
  RenderPlan chosen = plan(scene, prepared.scene.facts(), capabilitiesOf(*device_));
  const Certificate whole = *makeRenderer(prepared.scene, chosen, stages)->draw(prepared.view, stages).certificate;
  chosen.tileWidth = 64;  // neither divides the picture
  chosen.tileHeight = 37;
  const Certificate tiled = *makeRenderer(prepared.scene, chosen, stages)->draw(prepared.view, stages).certificate;
  // Corners are rounded in each tile's own coordinates, so a fragment at an edge may be another's.
  std::size_t different = 0;
  for (std::size_t i = 0; i < whole.count.size(); ++i) different += whole.count[i] != tiled.count[i];
  EXPECT_LE(different, whole.count.size() / 100);
  EXPECT_EQ(tiled.misordered, std::accumulate(tiled.count.begin(), tiled.count.end(), std::size_t{0}));
  EXPECT_GT(tiled.pixels, 1000u);
}

TEST_P(OrderCertificate, TheSecondPictureIsCountedAfresh) {
  Scene scene = smallScene();
  scene.sort = "none";
  scene.k = 1;
  const Prepared prepared = prepare(scene, withSmoothField(box(3)));
  StageTimes stages;
  const RenderPlan chosen = plan(scene, prepared.scene.facts(), capabilitiesOf(*device_));
  const auto renderer = makeRenderer(prepared.scene, chosen, stages);
  const Certificate first = *renderer->draw(prepared.view, stages).certificate;
  EXPECT_EQ(renderer->draw(prepared.view, stages).certificate->count, first.count);
}

// Not asked for, it costs nothing: the same program but for the define, nothing bound, the same picture.
TEST_P(OrderCertificate, IsAbsentWhereNotAskedFor) {
  Scene scene = smallScene();
  scene.sort = "none";
  scene.k = 3;
  const Prepared prepared = prepare(scene, withSmoothField(box(5, Cut::six, 0.25)));
  const Image with = drawPrepared(*device_, scene, prepared).image;
  const auto definesWith = plan(scene, prepared.scene.facts(), capabilitiesOf(*device_)).defines;
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, 0);
  scene.certificate = false;
  const havs::Drawing without = drawPrepared(*device_, scene, prepared);
  EXPECT_FALSE(without.certificate);
  EXPECT_EQ(without.image.rgba, with.rgba);
  GLint bound = -1;
  glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 2, &bound);
  EXPECT_EQ(bound, 0);

  const RenderPlan chosen = plan(scene, prepared.scene.facts(), capabilitiesOf(*device_));
  EXPECT_EQ(chosen.defines.size() + 1, definesWith.size());
  for (const ShaderDefine& define : chosen.defines) EXPECT_NE(define.name, "HAVS_CERTIFICATE");
  const Program program("without",
                        {{GL_VERTEX_SHADER, shaderSource("faces.vert")},
                         {GL_FRAGMENT_SHADER, shaderSource("kbuffer.frag", programOf(chosen, "insert").options)}});
  GLint blocks = -1;
  glGetProgramInterfaceiv(program.id(), GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
  EXPECT_EQ(blocks, 0);
}

// A buffer of k entries holds the k farthest fragments that have come, late ones among them or not. So the distance
// below which the next is late falls as k grows, and no fragment is late at k + 1 that is not at k: `--k auto` relies
// on it (render/k_search.cpp).
TEST_P(OrderCertificate, NeverGrowsWithK) {
  for (const Case& c : cases()) {
    const Prepared prepared = prepare(smallScene(), c.mesh);
    for (const char* sort : kSorts) {
      const CapturedPicture picture = captureFragments(prepared.scene, prepared.view, sort);
      for (const auto& fragments : picture)
        for (int k = 1; k < 14; ++k)
          ASSERT_GE(countLate(fragments, sort, k), countLate(fragments, sort, k + 1))
              << c.name << ", " << sort << ", k " << k;
    }
  }
}

HAVS_FOR_EVERY_DEVICE(OrderCertificate);

/// Whether a rounding of the distances may have made the difference: same fragments, and some two of them come so near
/// to the limit of "late" that the largest rounding seen in this pixel decides.
bool roundingDecides(const std::vector<CapturedFragment>& drawn, const std::vector<ExactFragment>& exact) {
  double rounding = 1e-12;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    rounding = std::max(rounding, std::abs(drawn[i].distance - exact[i].distance));
  for (std::size_t j = 0; j < exact.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      for (const double limit : {-1e-6, 0.0, 1e-6})  // of late, of order, of a touch
        if ((limit < 0 || exact[i].kind * exact[j].kind < 0) &&
            std::abs(exact[j].distance - exact[i].distance - limit) <= 2 * rounding)
          return true;
  return false;
}

bool sameFragments(const std::vector<CapturedFragment>& drawn, const std::vector<ExactFragment>& exact) {
  return std::equal(drawn.begin(), drawn.end(), exact.begin(), exact.end(),
                    [](const CapturedFragment& a, const ExactFragment& b) { return a.kind == b.kind; });
}

/// Pixels of a picture drawn and of the same in exact arithmetic.
struct Comparison {
  std::size_t seen = 0;            ///< with a fragment
  std::size_t otherFragments = 0;  ///< the rasteriser's grid put the centre on another side of an edge
  std::size_t otherCounts = 0;     ///< of late fragments, where the fragments are the same
  std::size_t unexplained = 0;     ///< of these, no two distances are a rounding apart
};

Comparison compareWithExactArithmetic(const Scene& scene, const Prepared& prepared, const Certificate& certificate) {
  const CapturedPicture picture = captureFragments(prepared.scene, prepared.view, scene.sort);
  FaceOrder order;
  sortMethod(scene.sort)
      .make({prepared.scene.points, prepared.scene.mesh.tetrahedra, &prepared.scene.faces})
      ->sort(viewPointOf(prepared.view), order);
  const FragmentSource source(prepared.scene.points, prepared.scene.faces, order.faces, prepared.scene.scalars,
                              prepared.view);
  Comparison result;
  std::vector<std::vector<ExactFragment>> pixels;
  for (std::size_t tile = 0; tile < source.tileCount(); ++tile) {
    source.collect(tile, pixels);
    for (int p = 0; p < kTileSize * kTileSize; ++p) {
      const int x = source.firstColumn(tile) + p % kTileSize, y = source.firstRow(tile) + p / kTileSize;
      if (x >= scene.width || y >= scene.height) continue;
      const auto at = static_cast<std::size_t>(y * scene.width + x);
      const auto& exact = pixels[static_cast<std::size_t>(p)];
      result.seen += !exact.empty();
      const bool same = sameFragments(picture[at], exact);
      result.otherFragments += !same;
      if (!same || certificate.count[at] == countLateByDefinition(exact, scene.k)) continue;
      ++result.otherCounts;
      result.unexplained += !roundingDecides(picture[at], exact);
    }
  }
  return result;
}

// The rasteriser rounds corners to 1/256 pixel and distances to float. Against coverage and distances in exact
// arithmetic the counts differ only where one of these decides: other fragments, or two distances a rounding apart.
TEST(OrderCertificateOnOneDevice, DiffersFromExactArithmeticOnlyByRounding) {
  const auto device = makeTestDevice("osmesa");
  for (const Case& c : cases())
    for (const char* sort : kSorts)
      for (int k : {1, 2, 6}) {
        Scene scene = smallScene();
        scene.sort = sort;
        scene.k = k;
        const Prepared prepared = prepare(scene, c.mesh);
        const Comparison result =
            compareWithExactArithmetic(scene, prepared, *drawPrepared(*device, scene, prepared).certificate);
        EXPECT_EQ(result.unexplained, 0u) << c.name << ", " << sort << ", k " << k;
        // A centre lies within 1/256 pixel of an edge for one in a hundred edges that cross the pixel.
        EXPECT_LE(result.otherFragments, result.seen / 5) << c.name << ", " << sort << ", k " << k;
      }
}

// In exact arithmetic no fragment of it is late, whatever k (unit/sort/bluntfin_test.cpp).
TEST(OrderCertificateOnOneDevice, LateFragmentsOfBluntFinInTopologicalOrderAreRoundings) {
  const std::string file = HAVS_SHARED_DATA "/bluntfinxyz.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const auto device = makeTestDevice("osmesa");
  Scene scene = smallScene();
  scene.width = scene.height = 160;
  scene.k = 1;
  const Prepared prepared = prepare(scene, readMesh(file));
  const Certificate certificate = *drawPrepared(*device, scene, prepared).certificate;
  const Comparison result = compareWithExactArithmetic(scene, prepared, certificate);
  EXPECT_EQ(result.unexplained, 0u);
  EXPECT_LT(certificate.misordered, certificate.fragments / 1000);
  std::cout << certificate.misordered << " of " << certificate.fragments << " late in " << certificate.pixels
            << " pixels; same fragments but another count in " << result.otherCounts << ", other fragments in "
            << result.otherFragments << " of " << result.seen << "\n";
}

TEST(OrderCertificateOnOneDevice, BluntFin) {
  const std::string file = HAVS_SHARED_DATA "/bluntfinxyz.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const auto device = makeTestDevice("osmesa");
  Scene scene = smallScene();
  scene.width = scene.height = 96;
  const Prepared prepared = prepare(scene, readMesh(file));
  for (const char* sort : kSorts) {
    const CapturedPicture picture = captureFragments(prepared.scene, prepared.view, sort);
    scene.sort = sort;
    for (int k : kSizes) {
      SCOPED_TRACE(std::string(sort) + ", k " + std::to_string(k));
      scene.k = k;
      const Certificate certificate = *drawPrepared(*device, scene, prepared).certificate;
      expectReplayed(certificate, picture, sort, k);
      if (std::string(sort) == "centroid") {
        EXPECT_GT(certificate.misordered, 1000u);
      }
    }
  }
}

}  // namespace
}  // namespace havs::test
