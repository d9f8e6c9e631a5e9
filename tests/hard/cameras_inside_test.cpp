// Eyes in the mesh: in cells, on points, edges and faces, inner ones and of the boundary.
#include "hard/camera_case.h"

namespace havs::test {
namespace {

class CamerasInside : public CameraCase {
 protected:
  /// Looked at from `eye` into two directions, `fieldOfView` wide; a grid of cells with edge 0.5.
  void expectFrom(const Vec3& eye, double fieldOfView = 60,
                  const std::vector<Vec3>& directions = {{-1, -0.2, 0.1}, {0.3, 0.4, -1}}, std::size_t late = 0) {
    const TetMesh mesh = withSmoothField(box(4));
    for (const Vec3& direction : directions) {
      SCOPED_TRACE(testing::Message() << "towards " << direction.x << ' ' << direction.y << ' ' << direction.z);
      const Scene scene = cameraScene(eye, eye + direction, fieldOfView);
      HardBounds bounds = boundsWithin(scene, mesh);
      bounds.late = late;
      expectEveryWay(scene, mesh, bounds);
      expectClosedForm(scene, mesh);
    }
  }
  static CaseStory story(const std::string& trouble) {
    return {"Cameras", trouble,
            "the mesh is cut a little before the eye, and rays enter at the section; the reference, whose fill rule "
            "knows eyes on faces, edges and points, needs no cut"};
  }
};

TEST_F(CamerasInside, InACell) {
  tell(
      story("rays start in a cell, and the mesh is all around: the count of entries and exits begins wrong, and faces "
            "go through the eye's plane"));
  expectFrom({0.13, 0.21, -0.17});
}

TEST_F(CamerasInside, OnAnInnerPoint) {
  tell(story("the faces around the eye have no sides: every product of the fill rule there is 0"));
  expectFrom({0.5, 0, -0.5});
}

TEST_F(CamerasInside, OnABoundaryPoint) {
  tell(story("rays start on a corner of the mesh: in it or beside it, which no face tells"));
  expectFrom({-1, 0.5, 0.5}, 100, {{1, 0.1, -0.2}, {0.1, -1, 0.3}, {-1, 0.1, 0.2}});
}

TEST_F(CamerasInside, OnACornerOfTheMesh) {
  tell(story("three boundary faces and more go through the eye"));
  // In the planes of the sides, faces are edge on: what float makes of their distances may be late for OpenGL in one
  // pixel of a thousand.
  expectFrom({1, 1, 1}, 100, {{-1, -1.1, -0.9}, {-1, 0.1, 0.2}, {1, 1, 1}}, 4);
}

TEST_F(CamerasInside, OnAnInnerEdge) {
  tell(story("faces around an edge through the eye are lines of the picture, in rays that run along them"));
  expectFrom({0.25, 0, 0.5});
}

TEST_F(CamerasInside, OnABoundaryEdge) {
  tell(story("rays along two boundary faces at once, at whose edge they start"));
  expectFrom({1, 0.3, 1}, 100, {{-1, 0.1, -1}, {0.1, 1, 0.05}});
}

TEST_F(CamerasInside, InAnInnerFace) {
  tell(story("a face through the eye covers a whole line of the picture, at no distance"));
  expectFrom({0.2, 0.3, 0});
}

TEST_F(CamerasInside, InABoundaryFace) {
  tell(story("the boundary is a half of the picture at no distance, or none of it"));
  expectFrom({1, 0.1, 0.2}, 100, {{-1, 0.2, 0.1}, {0.02, 1, 0.1}, {1, 0, 0}});
}

TEST_F(CamerasInside, AtTheMeshsCentre) {
  tell(
      story("the centre of the mesh, where eyes end up by default, is a point of many meshes, looked at along its "
            "edges here"));
  expectFrom({0, 0, 0}, 60, {{-1, 0, 0}, {0, 0, 1}, {1, 1, 1}});
}

TEST_F(CamerasInside, AHairOffFaces) {
  tell(story("an eye 1e-9 to 1e-6 off a face sees it as wide as the picture and wider, from one side or the other"));
  for (const double off : {-1e-6, -1e-9, 1e-9, 1e-6}) expectFrom({1 + off, 0.1, 0.2}, 60, {{-1, 0.2, 0.1}});
  for (const double off : {-1e-9, 1e-6}) expectFrom({0.2, 0.3, off}, 60, {{0.3, 0.4, -1}});
}

TEST_F(CamerasInside, NearPlaneThroughTheMesh) {
  tell({"Cameras", "a near plane cuts a hole into cells close before the eye, and their parts behind it are lost",
        "there is no near plane but the cut, which leaves a section that rays enter at"});
  expectFrom({1.02, 0.1, 0.2}, 120, {{-1, 0.2, 0.1}, {0.05, 1, 0.1}});
  expectFrom({1.0001, 0.1, 0.2}, 120, {{-1, 0.2, 0.1}});
}

TEST_F(CamerasInside, SlicesThatMeet) {
  tell(story(
      "from an eye in a cell a line is seen in two halves, there and back, and both begin in the middle of a segment"));
  const TetMesh mesh = withSmoothField(box(4));
  const Vec3 eye{0.13, 0.21, -0.17}, direction{-1, -0.2, 0.1};
  const Scene there = cameraScene(eye, eye + direction, 1, 9), back = cameraScene(eye, eye - direction, 1, 9);
  const HardPicture a = expectEveryWay(there, mesh, boundsWithin(there, mesh));
  const HardPicture b = expectEveryWay(back, mesh, boundsWithin(back, mesh));
  const Vec3 outside = eye - 10.0 * direction;
  const HardPicture whole = expectEveryWay(cameraScene(outside, eye, 1, 9), mesh);
  const auto through = [](const HardPicture& picture) { return 1 - double{picture.truth.pixel(4, 4)[3]}; };
  expectAtMost("transparency there times back, off that of the whole",
               std::abs(through(a) * through(b) - through(whole)), 2e-7);  // three floats
}

}  // namespace
}  // namespace havs::test
