// The certificate of few entries against the definition of a late fragment, on exact fragments, and of one device
// against the other's.
#include "hard/narrow_ways.h"
#include "support/fragments.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

/// What exact fragments give, pixel by pixel.
struct ByDefinition {
  std::vector<std::uint32_t> late;
  std::vector<unsigned char> undecided;  ///< two distances differ by the tolerance, to within float's rounding
};

bool isUndecided(std::span<const ExactFragment> fragments) {
  constexpr double kTolerance = 1e-6, kRounding = 5e-7;  // distances up to 1 in float, both off by up to 2^-23
  for (std::size_t j = 0; j < fragments.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (std::abs(std::abs(fragments[j].distance - fragments[i].distance) - kTolerance) <= kRounding) return true;
  return false;
}

/// Of the faces as they are numbered.
ByDefinition byDefinition(const HardPicture& picture, int k) {
  const View& view = picture.view;
  std::vector<Index> order(picture.prepared.faces.size());
  std::iota(order.begin(), order.end(), Index{0});
  const FragmentSource source(picture.prepared.points, picture.prepared.faces, order, picture.prepared.scalars, view);
  ByDefinition result;
  result.late.resize(static_cast<std::size_t>(view.width * view.height));
  result.undecided.resize(result.late.size());
  std::vector<std::vector<ExactFragment>> pixels;
  for (std::size_t tile = 0; tile < source.tileCount(); ++tile) {
    source.collect(tile, pixels);
    for (int p = 0; p < kTileSize * kTileSize; ++p) {
      const int x = source.firstColumn(tile) + p % kTileSize, y = source.firstRow(tile) + p / kTileSize;
      if (x >= view.width || y >= view.height) continue;
      const auto& fragments = pixels[static_cast<std::size_t>(p)];
      const auto at = static_cast<std::size_t>(y * view.width + x);
      result.late[at] = countLateByDefinition(fragments, k);
      result.undecided[at] = isUndecided(fragments) ? 1 : 0;
    }
  }
  return result;
}

class SmallKCertificate : public HardPictureTest {
 protected:
  /// Pixels where a certificate is another than by definition, though no rounding decides.
  void expectDefinition(const HardWay& way, const HardPicture& picture) {
    SCOPED_TRACE(way.name);
    const auto count = drawIn(way, picture.scene, picture.prepared, picture.view).certificate->count;
    const ByDefinition expected = byDefinition(picture, way.k);
    std::size_t others = 0, undecided = 0, late = 0;
    for (std::size_t i = 0; i < count.size(); ++i) {
      undecided += expected.undecided[i];
      late += expected.late[i] > 0 ? 1 : 0;
      others += expected.undecided[i] == 0 && count[i] != expected.late[i] ? 1 : 0;
    }
    expectAtMost(way.group + " pixels counted otherwise", static_cast<double>(others), 0);
    // In a hundred fragments a few pairs of a thousand pixels come so close by chance.
    expectAtMost(way.group + " pixels where rounding decides", static_cast<double>(undecided),
                 0.02 * static_cast<double>(count.size()));
    EXPECT_GT(late, count.size() / 20) << "nothing is late: this tries nothing";
  }
};

Scene certificateScene() {
  Scene scene = hardScene();
  scene.transferFunction = "viridis";
  return scene;
}

TEST_F(SmallKCertificate, OfTheNativeDeviceByDefinition) {
  tell({"k too small", "a count made by the k-buffer itself could share its mistakes",
        "it is that of the definition, replayed on exact fragments without a k-buffer, pixel by pixel"});
  for (TetMesh mesh : {box(4, Cut::six, 0.25), stretchedLayers(5, 1.7), nestedShells(1)}) {
    HardPicture picture(certificateScene(), withSmoothPoints(std::move(mesh)));
    renumberFaces(picture.prepared.faces, randomOrder(picture.prepared.faces.size(), 17));
    for (const HardWay& way : narrowWays("none"))
      if (way.device == kNativeDevice) expectDefinition(way, picture);
  }
}

TEST_F(SmallKCertificate, OfBothDevices) {
  tell({"k too small",
        "OpenGL snaps corners to 1/256 pixel: near edges its fragments are others, and so is their count",
        "where corners lie on that grid and no pixel's centre near an edge, both devices count the same in every "
        "pixel"});
  Scene scene = certificateScene();
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = scene.camera.elevation = 0;
  scene.camera.viewHeight = 4;  // 16 pixels a unit: corners of the box at whole pixels, then moved along the grid
  scene.camera.target = Vec3(5 / 4096.0, 9 / 4096.0, 0);
  for (const Cut cut : {Cut::five, Cut::six}) {
    HardPicture picture(scene, withSmoothPoints(box(4, cut)));
    renumberFaces(picture.prepared.faces, randomOrder(picture.prepared.faces.size(), 19));
    for (const HardWay& way : narrowWays("none", {1, 2, 3, 6})) expectDefinition(way, picture);
  }
}

}  // namespace
}  // namespace havs::test
