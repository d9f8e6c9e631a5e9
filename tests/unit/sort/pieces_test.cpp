// Orders handed over in pieces, and orders that are taken from the last view.
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "core/parallel.h"
#include "support/meshes.h"
#include "support/ordered_scene.h"
#include "support/views.h"

namespace havs {
namespace {

constexpr int kCubes = 20;  // 48,000 cells: three pieces

std::unique_ptr<FaceSorter> sorterOf(const test::OrderedScene& scene, const std::string& name) {
  return sortMethod(name).make({scene.points, scene.mesh.tetrahedra, &scene.faces});
}

ViewPoint viewAt(const test::OrderedScene& scene, double azimuth, Projection projection = Projection::perspective) {
  return test::viewPoint(test::viewFrom(scene.frame, azimuth, 20, 8, projection));
}

/// What came in pieces, put together from what was ready at each call.
struct Received {
  std::vector<Index> faces;
  std::size_t calls = 0;
  bool grows = true, stays = true;
};

Received receive(FaceSorter& sorter, const ViewPoint& view) {
  Received received;
  FaceOrder order;
  const Index* begin = nullptr;
  std::mutex mutex;
  sorter.sortInPieces(view, order, [&](std::size_t count) {
    const std::lock_guard lock(mutex);
    if (received.calls++ == 0) begin = order.faces.data();
    received.stays = received.stays && begin == order.faces.data();
    received.grows = received.grows && count > received.faces.size();
    for (std::size_t i = received.faces.size(); i < count; ++i) received.faces.push_back(order.faces[i]);
  });
  return received;
}

TEST(OrderInPieces, IsTheWholeOrderForAnyNumberOfThreads) {
  const test::OrderedScene scene(test::box(kCubes, test::Cut::six, 0.25));
  for (const SortMethod& method : sortMethods()) {
    SCOPED_TRACE(method.name);
    const ViewPoint view = viewAt(scene, 30);
    FaceOrder whole;
    sorterOf(scene, method.name)->sort(view, whole);
    for (const std::size_t threads : {1u, 2u, 4u}) {
      const ThreadLimit limit(threads);
      const auto sorter = sorterOf(scene, method.name);
      for (int again = 0; again < 2; ++again) {  // the second comes from the first
        const Received received = receive(*sorter, view);
        EXPECT_EQ(received.faces, whole.faces);
        EXPECT_TRUE(received.grows);
        EXPECT_TRUE(received.stays);
        if (threads == 1 && method.name == "topological") {
          EXPECT_EQ(received.calls, 3u);
        }
      }
    }
  }
}

TEST(OrderInPieces, WhatReadyThrowsArrivesAndTheNextOrderIsWhole) {
  const test::OrderedScene scene(test::box(kCubes, test::Cut::six, 0.25));
  for (const std::size_t threads : {1u, 4u}) {
    const ThreadLimit limit(threads);
    const auto sorter = sorterOf(scene, "topological");
    FaceOrder order, fresh;
    EXPECT_THROW(
        sorter->sortInPieces(viewAt(scene, 30), order, [](std::size_t) { throw std::runtime_error("enough"); }),
        std::runtime_error);
    sorter->sort(viewAt(scene, 30), order);
    sorterOf(scene, "topological")->sort(viewAt(scene, 30), fresh);
    EXPECT_EQ(order.faces, fresh.faces);
  }
}

// From the last view or not: the same order.
TEST(ReusedOrder, IsTheFreshOne) {
  for (TetMesh mesh : {test::box(6, test::Cut::five, 0.25), test::boxWithHole(6), test::visibilityCycle()}) {
    const test::OrderedScene scene(std::move(mesh));
    const auto sorter = sorterOf(scene, "topological");
    FaceOrder order;
    for (const double azimuth : {0.0, 0.0, 1e-13, 1e-6, 0.01, 0.02, 30.0, 30.0 + 1e-9, 0.0}) {
      SCOPED_TRACE(azimuth);
      for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const ViewPoint view = viewAt(scene, azimuth, projection);
        FaceOrder fresh;
        sorterOf(scene, "topological")->sort(view, fresh);
        for (int again = 0; again < 2; ++again) {
          sorter->sort(view, order);
          EXPECT_EQ(order.faces, fresh.faces);
          EXPECT_EQ(order.cycles, fresh.cycles);
        }
      }
    }
  }
}

/// Six times the volume of a face and the eye, positive where the eye is outside of the face's first cell.
long double heightOf(const test::OrderedScene& scene, Index face, const ViewPoint& view) {
  using Real = long double;
  const auto& v = scene.faces.vertices[face];
  const auto minus = [](const Vec3& p, const Vec3& q) {
    return std::array<Real, 3>{Real(p.x) - q.x, Real(p.y) - q.y, Real(p.z) - q.z};
  };
  const auto a = minus(scene.points[v[1]], scene.points[v[0]]), b = minus(scene.points[v[2]], scene.points[v[0]]);
  const auto e = view.orthographic ? minus(Vec3(0), view.direction) : minus(view.eye, scene.points[v[0]]);
  return (a[1] * b[2] - a[2] * b[1]) * e[0] + (a[2] * b[0] - a[0] * b[2]) * e[1] + (a[0] * b[1] - a[1] * b[0]) * e[2];
}

/// The faces that rays enter a cell through come before those they leave it through.
void expectEnteredBeforeLeft(const test::OrderedScene& scene, const ViewPoint& view, long double tolerance) {
  FaceOrder order;
  sorterOf(scene, "topological")->sort(view, order);
  ASSERT_EQ(order.cycles, 0u);
  std::vector<std::size_t> place(scene.faces.size());
  for (std::size_t i = 0; i < order.faces.size(); ++i) place[order.faces[i]] = i;
  std::size_t wrong = 0, compared = 0;
  for (std::size_t c = 0; c < scene.faces.ofCell.size(); ++c) {
    std::size_t lastEntered = 0, firstLeft = order.faces.size();
    for (const Index face : scene.faces.ofCell[c]) {
      const long double outward = (scene.faces.cells[face][0] == c ? 1 : -1) * heightOf(scene, face, view);
      if (outward > tolerance) lastEntered = std::max(lastEntered, place[face]);
      if (outward < -tolerance) firstLeft = std::min(firstLeft, place[face]);
    }
    wrong += lastEntered >= firstLeft ? 1 : 0;
    ++compared;
  }
  EXPECT_GT(compared, 0u);
  EXPECT_EQ(wrong, 0u);
}

// Seen from anywhere: from inside planes of many faces, from so near that a vertex is at the eye's distance of 1e-9,
// and from so far that the planes' heights lose all digits that the eye's distance takes.
TEST(TopologicalOrder, EntersEachCellBeforeItLeavesIt) {
  for (const double jitter : {0.0, 0.25}) {
    const test::OrderedScene scene(test::box(7, test::Cut::six, jitter));
    std::vector<ViewPoint> views;
    for (const Vec3& eye : {Vec3(2, 0, 0), Vec3(1, 1, 1), Vec3(0, 2, 1e-9), Vec3(0.3, -0.2, 1.7), Vec3(3e6, 2e6, 1e6),
                            Vec3(1e12, -3e11, 7e11)})
      views.push_back({.eye = eye, .direction = -normalize(eye)});
    views.push_back({.eye = scene.points[0] * (1 + 1e-9), .direction = -normalize(scene.points[0])});
    for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(-1, 2, 0.3)})
      views.push_back({.orthographic = true, .direction = normalize(direction)});
    for (const ViewPoint& view : views) {
      SCOPED_TRACE(std::to_string(view.eye.x) + " " + std::to_string(view.eye.y) + " " + std::to_string(view.eye.z));
      // An edge is 0.2 long at most, so a rounding error at most 16 times 2e-16 times 0.04 of the eye's distance.
      expectEnteredBeforeLeft(scene, view, 2e-16L * (view.orthographic ? 1 : 1 + length(view.eye)));
    }
  }
}

}  // namespace
}  // namespace havs
