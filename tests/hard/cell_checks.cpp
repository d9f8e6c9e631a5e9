#include "hard/cell_checks.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>
#include <set>

#include "reference/edge_mask.h"
#include "unit/reference/rays.h"

namespace havs::test {
namespace {

TetMesh localMesh(const PreparedScene& prepared) {
  TetMesh mesh;
  mesh.points = prepared.points;
  mesh.tetrahedra = prepared.mesh.tetrahedra;
  return mesh;
}

double opticalDepth(const TetMesh& mesh, const PreparedScene& prepared, const Ray& ray) {
  const bool cellData = prepared.field.centering == Centering::cell;
  double depth = 0, reached = -1e300;
  for (const Stretch& stretch : clipCells(mesh, ray)) {
    const double first = std::max(stretch.first, reached);
    if (stretch.last <= first) continue;
    reached = stretch.last;
    const auto kappaAt = [&](double t) {
      const double scalar = cellData ? prepared.scalars[stretch.cell]
                                     : scalarIn(mesh, stretch.cell, prepared.scalars, ray.origin + t * ray.direction);
      return prepared.curve.at(std::clamp(scalar, 0.0, 1.0)).kappa;
    };
    depth += (stretch.last - first) * (kappaAt(first) + kappaAt(stretch.last)) / 2;
  }
  return depth;
}

}  // namespace

TetMesh withPointData(TetMesh mesh) {
  Vec3 low = mesh.points.front(), high = low;
  for (const Tetrahedron& cell : mesh.tetrahedra)
    for (const Index v : cell)
      if (isFinite(mesh.points[v])) {
        low = min(low, mesh.points[v]);
        high = max(high, mesh.points[v]);
      }
  const Vec3 half = (high - low) / 2.0;
  const double size = std::max({half.x, half.y, half.z});
  std::vector<Vec3> places;
  for (const Vec3& p : mesh.points) places.push_back((p - (low + half)) / size);
  mesh.pointFields = {Field{"s", 1, smoothField(places)}};
  return mesh;
}

TetMesh withCellData(TetMesh mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  Field field{"s", 1, {}};
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) field.values.push_back(random() / 4294967295.0);
  mesh.cellFields = {std::move(field)};
  return mesh;
}

Scene rampScene(int size) {
  Scene scene = hardScene(size);
  scene.transferFunction = transferFile(transferOf({{0, 0.2, 0.4, 0.8, 0.3}, {1, 0.9, 0.5, 0.1, 1.3}}));
  return scene;
}

double truthError(const HardPicture& picture, int stride) {
  const PreparedScene& prepared = picture.prepared;
  const TetMesh mesh = localMesh(prepared);
  double most = 0;
  for (int y = stride / 2; y < picture.view.height; y += stride)
    for (int x = stride / 2; x < picture.view.width; x += stride) {
      const double opacity = -std::expm1(-opticalDepth(mesh, prepared, rayOf(picture.view, x, y)));
      const double error = std::abs(opacity - double{picture.truth.pixel(x, y)[3]});
      if (!(error <= most)) most = error;
    }
  return most;
}

std::vector<unsigned char> overlapMask(const HardPicture& picture, double tolerance) {
  const TetMesh mesh = localMesh(picture.prepared);
  const int width = picture.view.width, height = picture.view.height;
  std::vector<unsigned char> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  const auto isOverlapped = [&](int x, int y) {
    double reached = -1e300;
    for (const Stretch& stretch : clipCells(mesh, rayOf(picture.view, x, y))) {
      if (std::min(stretch.last, reached) - stretch.first > tolerance) return true;
      reached = std::max(reached, stretch.last);
    }
    return false;
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!isOverlapped(x, y)) continue;
      for (int ny = std::max(0, y - 1); ny <= std::min(height - 1, y + 1); ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(width - 1, x + 1); ++nx)
          mask[static_cast<std::size_t>(ny * width + nx)] = 1;
    }
  return mask;
}

HardPicture CellsTest::expectCells(const TetMesh& mesh, const HardBounds& bounds, const Scene& scene) {
  HardPicture picture = expectEveryWay(scene, mesh, bounds);
  // The truth is rounded to float once.
  expectAtMost("truth against clipped cells", truthError(picture), 1e-7);
  return picture;
}

void CellsTest::expectBothData(const TetMesh& mesh, const HardBounds& bounds, const Scene& scene) {
  {
    SCOPED_TRACE("point data");
    expectCells(withPointData(mesh), bounds, scene);
  }
  SCOPED_TRACE("cell data");
  expectCells(withCellData(mesh), cellDataBounds(bounds), scene);
}

void CellsTest::expectSamePictures(const HardPicture& a, const HardPicture& b, double bound) {
  expectSame("the truths", a.truth, b.truth, bound);
  for (std::size_t i = 0; i < a.drawings.size(); ++i) {
    SCOPED_TRACE(a.drawings[i].way.name);
    expectSame(a.drawings[i].way.group + ", both pictures", a.drawings[i].drawing.image, b.drawings[i].drawing.image,
               bound);
  }
}

HardPicture CellsTest::expectRightBesideOverlaps(const TetMesh& mesh, const Scene& scene) {
  constexpr std::size_t kAny = ~std::size_t{0};
  HardBounds anything{.native = 1, .p999 = 1, .traced = 1, .trace = false, .late = kAny};
  HardPicture picture = expectEveryWay(scene, withPointData(mesh), anything);
  std::vector<unsigned char> mask = overlapMask(picture);
  expectAtMost("part of the picture that is overlapped",
               static_cast<double>(std::count(mask.begin(), mask.end(), 1)) / static_cast<double>(mask.size()), 0.5);
  const auto edges = boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view);
  for (const HardDrawing& d : picture.drawings) {
    SCOPED_TRACE(d.way.name);
    std::vector<unsigned char> left = mask;
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i] |=
          (d.way.group != "native" && edges[i] != 0) || (d.drawing.certificate && d.drawing.certificate->count[i] > 0);
    // The bounds of HardBounds; point data are continuous inside each part, so the grid moves nothing by more.
    expectSame(d.way.group + " beside the overlaps", d.drawing.image, picture.truth,
               d.way.group == "native" ? HardBounds{}.native : HardBounds{}.traced, left);
  }
  return picture;
}

void CellsTest::expectDefects(const PreparedScene& prepared, const std::string& name, std::size_t count) {
  const std::size_t found = defectCount(prepared, name);
  EXPECT_EQ(found, count) << name;
  expectAtMost(name + " not counted", static_cast<double>(count) - static_cast<double>(found), 0);
  const bool told = std::any_of(prepared.notes.begin(), prepared.notes.end(),
                                [&](const std::string& note) { return note.starts_with(name); });
  EXPECT_EQ(told, count > 0) << name;
}

HardBounds cellDataBounds(HardBounds bounds) {
  bounds.p999 = 1;
  return bounds;
}

std::size_t shortestCycle(const PreparedScene& prepared, const View& view) {
  std::vector<std::set<Index>> behind(prepared.mesh.tetrahedra.size());
  for (const auto& ray : segmentsOf(prepared, view))
    for (std::size_t i = 0; i + 1 < ray.size(); ++i)
      if (ray[i].exit - ray[i].entry > 1e-9 && ray[i + 1].exit - ray[i + 1].entry > 1e-9)
        behind[ray[i].cell].insert(ray[i + 1].cell);
  std::size_t shortest = 0;
  for (Index start = 0; start < behind.size(); ++start) {
    std::vector<std::size_t> steps(behind.size(), 0);
    std::deque<Index> next{start};
    while (!next.empty()) {
      const Index cell = next.front();
      next.pop_front();
      for (const Index other : behind[cell]) {
        if (steps[other] > 0) continue;
        steps[other] = steps[cell] + 1;
        next.push_back(other);
      }
    }
    if (steps[start] > 0 && (shortest == 0 || steps[start] < shortest)) shortest = steps[start];
  }
  return shortest;
}

std::size_t defectCount(const PreparedScene& prepared, const std::string& name) {
  for (const Defect& defect : prepared.defects)
    if (defect.name == name) return defect.count;
  return 0;
}

}  // namespace havs::test
