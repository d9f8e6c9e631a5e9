// Meshes far from the origin, fields far from 0: as far as the double precision of the input carries.
#include <fmt/format.h>

#include "hard/like_plain.h"

namespace havs::test {
namespace {

constexpr const char* kGroup = "Scale and place";

/// The size of plainMesh() along each axis.
constexpr double kSize = 2;

Units placedAt(double sizes) { return {.place = kSize * sizes * Vec3(1, -0.7, 0.4)}; }

class Place : public LikePlainTest {
 protected:
  /// Draws in `units`. Where places or scalars do not fit into a double there, the input itself is another: pictures
  /// must be those of the plain mesh with its numbers rounded in the same way, within the bound, whatever the
  /// rounding; and those of the plain mesh within `input`, what the rounding of the input can change.
  void expectAsTheInputCarries(const Scene& scene, const TetMesh& mesh, const Units& units, double input) {
    SCOPED_TRACE(testing::Message() << "at " << units.place.x << ", offset " << units.offset);
    const HardPicture placed = expectEveryWay(sceneIn(units, scene), meshIn(units, mesh));
    expectLike(expectEveryWay(scene, roundedBy(units, mesh)), placed, kSameInAnyUnit);
    expectSame(
        input > kSameInAnyUnit ? fmt::format("reference against unrounded input", input) : "reference against plain",
        expectEveryWay(scene, mesh).truth, placed.truth, std::max(input, kSameInAnyUnit));
  }
};

TEST_F(Place, From1e3To1e9SizesAway) {
  tell({kGroup, "single precision has no digit of a mesh left that lies 1e7 sizes from the origin",
        "the centre is taken off in double, before anything is rounded to float"});
  for (const double sizes : {1e3, 1e6, 1e9}) expectAsTheInputCarries(plainScene(), plainMesh(), placedAt(sizes), 0);
}

TEST_F(Place, ExactWhereTheInputIs) {
  tell({kGroup, "a translation must not cost what the input's doubles still hold",
        "corners on a grid that doubles hold 2^40 sizes away give the same picture, bit for bit"});
  TetMesh mesh = plainMesh();
  for (Vec3& p : mesh.points) p = round(p * 256.0) / 256.0;
  expectLikePlain(plainScene(), mesh, {{.place = Vec3(0x1p41, -0x1p41, 0x1p40)}, {.place = Vec3(3, -5, 7)}}, {}, 0);
}

TEST_F(Place, FieldOffsetBy1e9Ranges) {
  tell({kGroup, "a field of 1e9 + [0, 1], as pressures or times are, is one single number in float",
        "the domain's low end is taken off in double; what is left is the input's own rounding"});
  for (const double ranges : {1e3, 1e6, 1e9}) expectAsTheInputCarries(plainScene(), plainMesh(), {.offset = ranges}, 0);
  expectAsTheInputCarries(plainScene(), plainMesh(), {.offset = -1e9}, 0);
}

TEST_F(Place, BeyondWhatTheInputCarries) {
  tell({kGroup, "1e13 sizes away corners lie on a grid of 1/256 of the size: cells are bent, some flat or turned over",
        "the bent mesh is drawn for what it is; flat cells are left out and turned ones turned, as a note says"});
  const Units units = placedAt(1e13);
  const HardPicture placed = expectEveryWay(sceneIn(units, plainScene()), meshIn(units, plainMesh()));
  expectLike(expectEveryWay(plainScene(), roundedBy(units, plainMesh())), placed, kSameInAnyUnit);
}

TEST_F(Place, CameraInMeshUnits) {
  tell({kGroup, "eye and target far from the origin: their difference cancels in float",
        "both go to the mesh's frame in double before anything is made of them"});
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plainScene();
    scene.camera.projection = projection;
    scene.camera.eye = Vec3(2.9, 2.2, 4.1);
    scene.camera.target = Vec3(0.2, -0.1, 0.1);
    if (projection == Projection::orthographic) scene.camera.viewHeight = 3;
    expectLikePlain(scene, plainMesh(),
                    {{.length = 1e-12}, {.length = 1e12}, {.length = 1e-150}, {.length = 1e150}, placedAt(1e6)});
  }
}

TEST_F(Place, ClipPlanesAndBoxes) {
  tell({kGroup, "a plane's offset far from the origin has no digits left; its normal may be 1e-150 long",
        "planes and boxes go to the mesh's frame in double, normals are made length 1 without squares of them"});
  Scene scene = plainScene();
  scene.clipPlanes = {{Vec3(0.3, 0.1, 0.2), Vec3(-1, 0.4, 0.2)}};
  scene.clipBoxes = {{Vec3(-0.9, -0.8, -0.7), Vec3(0.9, 0.95, 0.6), true}, {Vec3(0, 0, 0), Vec3(2, 2, 2), false}};
  expectLikePlain(scene, plainMesh(),
                  {{.length = 1e-12}, {.length = 1e12}, {.length = 1e-150}, {.length = 1e150}, placedAt(1e6)});
}

TEST_F(Place, NormalsOfAnyLength) {
  tell({kGroup, "the length of a normal of 1e-200 is 0 by its square, of 1e200 infinite",
        "normals are divided by their largest component first"});
  Scene scene = plainScene();
  const Vec3 normal(-1, 0.4, 0.2);
  scene.clipPlanes = {{Vec3(0.3, 0.1, 0.2), normal}};
  const HardPicture plain = expectEveryWay(scene, plainMesh());
  for (const double length : {1e-300, 1e-12, 1e12, 1e300}) {
    scene.clipPlanes[0].normal = length * normal;
    scene.camera.up = Vec3(0, length, 0);  // as the default for an eye, so below
    expectLike(plain, expectEveryWay(scene, plainMesh()), kSameInAnyUnit);
  }
}

TEST_F(Place, IsosurfaceValues) {
  tell({kGroup, "a surface at a value of 1e30 or 1e-290, or where the field is 1e6 + [0, 1], is missed or met twice",
        "values go to fractions of the domain as the scalars do, so that ties stay ties"});
  Scene scene = plainScene();
  scene.isosurfaces = {{0.35, Color{0.9, 0.2, 0.1}, 0.5}, {0.625, Color{0.1, 0.3, 0.9}, 1}};
  expectLikePlain(scene, plainMesh(),
                  {{.scalar = 1e30}, {.scalar = 1e-30}, {.scalar = 1e-290}, {.scalar = 1e300}, {.offset = 1e6}});
}

TEST_F(Place, Thresholds) {
  tell({kGroup, "a threshold in another unit must keep the same cells, also those with a value on its end",
        "it is compared with the data as they are, in double"});
  Scene scene = plainScene();
  const TetMesh mesh = mapped(
      plainMesh(), [](const Vec3& p) { return p; },
      [](double v) { return std::round(v * 64) / 64; });  // some are on the ends
  scene.threshold = {0.25, 0.75};
  expectLikePlain(scene, mesh, {{.scalar = 0x1p100}, {.scalar = 0x1p-1000}, {.offset = 0x1p40}, {.length = 1e150}});
}

TEST_F(Place, Overlays) {
  tell({kGroup, "outline, surface and edges lie in the mesh's unit, their widths in pixels",
        "all are drawn in the mesh's frame"});
  Scene scene = plainScene();
  scene.overlays.outline = Outline{};
  scene.overlays.surface = BoundarySurface{};
  scene.overlays.wireFrame = WireFrame{.featureAngle = 30};
  HardBounds bounds;
  bounds.trace = false;
  expectLikePlain(scene, plainMesh(), {{.length = 1e-12}, {.length = 1e12}, placedAt(1e6)}, bounds);
}

}  // namespace
}  // namespace havs::test
