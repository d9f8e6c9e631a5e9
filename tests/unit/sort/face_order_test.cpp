// What every order must keep: each face once, and the same for any number of threads; and the two orders by centroid
// against each other.
#include "sort/face_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"
#include "support/meshes.h"
#include "support/ordered_scene.h"
#include "support/views.h"

namespace havs {
namespace {

class EveryOrder : public testing::TestWithParam<std::string> {};

std::vector<std::string> orderNames() {
  std::vector<std::string> names;
  for (const SortMethod& method : sortMethods()) names.push_back(method.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Sort, EveryOrder, testing::ValuesIn(orderNames()),
                         [](const auto& order) { return order.param; });

TEST_P(EveryOrder, WritesEachFaceOnce) {
  for (TetMesh mesh : {test::singleTetrahedron(), test::box(5, test::Cut::five, 0.25), test::nestedShells(1),
                       test::boxWithHole(6), test::visibilityCycle(), test::twoBoxes(2, 0), test::oGrid(2, 9, 2)}) {
    const test::OrderedScene scene(std::move(mesh));
    const auto sorter = sortMethod(GetParam()).make({scene.points, scene.mesh.tetrahedra, &scene.faces});
    FaceOrder order;  // used again from view to view
    for (const Projection projection : {Projection::perspective, Projection::orthographic})
      for (const double azimuth : {0.0, 37.0, 180.0}) {
        sorter->sort(test::viewPoint(test::viewFrom(scene.frame, azimuth, azimuth / 4, 8, projection)), order);
        std::vector<Index> ascending = order.faces, all(scene.faces.size());
        std::sort(ascending.begin(), ascending.end());
        std::iota(all.begin(), all.end(), Index{0});
        EXPECT_EQ(ascending, all);
      }
  }
}

TEST_P(EveryOrder, IsTheSameForAnyNumberOfThreads) {
  const test::OrderedScene scene(test::box(14, test::Cut::six, 0.25));
  const View view = test::viewFrom(scene.frame, 30, 20, 8);
  auto sorted = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return scene.order(GetParam(), view).faces;
  };
  const auto one = sorted(1);
  for (int run = 0; run < 3; ++run) EXPECT_EQ(one, sorted(4));
}

TEST(FaceOrder, UnknownNameNamesTheNearest) {
  try {
    sortMethod("centriod");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("centroid"), std::string::npos);
  }
}

double centroidDistance(const test::OrderedScene& scene, Index face, const ViewPoint& view) {
  const auto& [a, b, c] = scene.faces.vertices[face];
  const Vec3 centroid = (scene.points[a] + scene.points[b] + scene.points[c]) / 3.0;
  return view.orthographic ? dot(centroid, view.direction) : length(centroid - view.eye);
}

// Along the order by float keys the true distance never falls by more than a float's rounding of a number of order 1.
void expectCentroidOrder(const test::OrderedScene& scene, const ViewPoint& view, double rounding) {
  FaceOrder order;
  sortMethod("centroid").make({scene.points, scene.mesh.tetrahedra, &scene.faces})->sort(view, order);
  double farthest = -1e300;
  for (const Index face : order.faces) {
    const double distance = centroidDistance(scene, face, view);
    EXPECT_GT(distance, farthest - rounding);
    farthest = std::max(farthest, distance);
  }
}

TEST(CentroidOrder, IsTheExactOrderUpToTheFloatsOfItsKeys) {
  const test::OrderedScene scene(test::box(8, test::Cut::six, 0.25));
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double azimuth : {0.0, 50.0, 200.0})
      expectCentroidOrder(scene, test::viewPoint(test::viewFrom(scene.frame, azimuth, 20, 8, projection)), 2.5e-7);
}

TEST(CentroidOrder, KeepsItsResolutionForAFarEye) {
  const test::OrderedScene scene(test::box(8, test::Cut::six, 0.25));
  ViewPoint view;
  view.eye = 1e6 * normalize(Vec3(1, 2, 3));
  expectCentroidOrder(scene, view, 2.5e-7);  // a float of the distance itself would be good to 0.06 only
}

TEST(CentroidOrder, OfAFarEyeIsTheOrthographicOne) {
  const test::OrderedScene scene(test::box(6, test::Cut::six, 0.25));
  ViewPoint far;
  far.eye = 1e12 * normalize(Vec3(1, 2, 3));
  ViewPoint parallel;
  parallel.orthographic = true;
  parallel.direction = -normalize(Vec3(1, 2, 3));
  FaceOrder a, b;
  const auto sorter = sortMethod("centroid").make({scene.points, scene.mesh.tetrahedra, &scene.faces});
  sorter->sort(far, a);
  sorter->sort(parallel, b);
  EXPECT_EQ(a.faces, b.faces);  // the keys differ by 1e-12, below a float's step except at a few ties
}

}  // namespace
}  // namespace havs
