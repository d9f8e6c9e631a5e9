#include "hard/cell_checks.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

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
  expectCells(withCellData(mesh), bounds, scene);
}

std::size_t defectCount(const PreparedScene& prepared, const std::string& name) {
  for (const Defect& defect : prepared.defects)
    if (defect.name == name) return defect.count;
  return 0;
}

}  // namespace havs::test
