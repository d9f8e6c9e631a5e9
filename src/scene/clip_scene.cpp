#include "scene/clip_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/half_space.h"

namespace havs {
namespace {

HalfSpace halfSpace(const Vec3& localPoint, const Vec3& normal) {
  const Vec3 a = abs(normal);
  const Vec3 scaled = normal / std::max({a.x, a.y, a.z});  // its square neither overflows nor vanishes
  HalfSpace half;
  half.normal = scaled / length(scaled);
  half.offset = dot(half.normal, localPoint);
  if (!std::isfinite(half.offset)) failInput("a plane is too far away", "--clip-plane", "give it in mesh units");
  return half;
}

/// Each within one side of the box; their normals point into it.
std::array<HalfSpace, 6> sidesOf(const ClipBox& box, const LocalFrame& frame) {
  std::array<HalfSpace, 6> sides;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 normal{0};
    normal[axis] = 1;
    const auto at = static_cast<std::size_t>(2 * axis);
    sides[at] = {normal, frame.toLocal(box.low)[axis]};
    sides[at + 1] = {-normal, -frame.toLocal(box.high)[axis]};
  }
  return sides;
}

void keepInside(PreparedScene& scene, const HalfSpace& half) {
  scene = cutScene(scene, partInside(scene.mesh.tetrahedra, scene.points, half));
}

/// Only the cells with keep[c] != 0.
void keepCells(PreparedScene& scene, const std::vector<unsigned char>& keep) {
  std::vector<CellFate> fates(keep.size());
  for (std::size_t c = 0; c < keep.size(); ++c) fates[c] = keep[c] != 0 ? CellFate::stays : CellFate::goes;
  scene = cutScene(scene, cutMesh(scene.mesh.tetrahedra, std::vector<double>(scene.points.size()), fates));
}

/// Marks the cells with no point on the inner side.
void markBeyond(const PreparedScene& scene, const std::vector<double>& levels, std::vector<unsigned char>& beyond) {
  parallelFor(0, beyond.size(), kGrain, [&](std::size_t c) {
    const auto& [i, j, k, l] = scene.mesh.tetrahedra[c];
    const auto [least, most] = std::minmax({levels[i], levels[j], levels[k], levels[l]});
    if (least < 0 && !(most > 0)) beyond[c] = 1;
  });
}

/// What is beyond one side of the box is done with; the rest is split at the next side, until what is left is inside.
/// Cells that are done with are split only where they share an edge with one that is not.
void cutAway(PreparedScene& scene, const std::array<HalfSpace, 6>& sides) {
  std::vector<unsigned char> beyond(scene.mesh.tetrahedra.size(), 0);
  for (const HalfSpace& side : sides) markBeyond(scene, levelsOf(scene.points, side), beyond);
  for (const HalfSpace& side : sides) {
    std::vector<CellFate> fates(beyond.size());
    for (std::size_t c = 0; c < fates.size(); ++c) fates[c] = beyond[c] != 0 ? CellFate::stays : CellFate::split;
    const MeshCut cut = cutMesh(scene.mesh.tetrahedra, levelsOf(scene.points, side), fates);
    scene = cutScene(scene, cut);
    beyond = cut.cellValues(beyond);
    for (std::size_t c = 0; c < beyond.size(); ++c) beyond[c] = beyond[c] != 0 || cut.pieceSide[c] < 0 ? 1 : 0;
  }
  keepCells(scene, beyond);
}

void keepWithin(PreparedScene& scene, const std::array<double, 2>& range, std::span<const double> values) {
  const auto within = [&](std::size_t i) { return values[i] >= range[0] && values[i] <= range[1]; };
  const bool cellData = scene.facts().cellData;
  std::vector<unsigned char> keep(scene.mesh.tetrahedra.size());
  parallelFor(0, keep.size(), kGrain, [&](std::size_t c) {
    const Tetrahedron& t = scene.mesh.tetrahedra[c];
    keep[c] = (cellData ? within(c) : within(t[0]) && within(t[1]) && within(t[2]) && within(t[3])) ? 1 : 0;
  });
  keepCells(scene, keep);
}

void check(bool good, const std::string& what, const std::string& where, const char* tryThis) {
  if (!good) failInput(what, where, tryThis);
}

}  // namespace

PreparedScene cutScene(const PreparedScene& whole, const MeshCut& cut) {
  PreparedScene part = withoutMesh(whole);
  part.knotsInCells = whole.knotsInCells;
  part.clearCells = whole.clearCells;
  part.cellsWithoutSurface = whole.cellsWithoutSurface;
  part.mesh.points = cut.pointValues(whole.mesh.points);
  part.mesh.tetrahedra = cut.tetrahedra;
  part.points = cut.pointValues(whole.points);
  part.scalars = whole.facts().cellData ? cut.cellValues(whole.scalars) : cut.pointValues(whole.scalars);
  return part;
}

bool asksForPart(const Scene& scene) {
  return !scene.clipPlanes.empty() || !scene.clipBoxes.empty() || scene.threshold.has_value();
}

void checkClipping(const Scene& scene) {
  for (const ClipPlane& plane : scene.clipPlanes) {
    check(isFinite(plane.point) && isFinite(plane.normal), "a number is not finite", "--clip-plane",
          "give a point and a normal in mesh units");
    check(plane.normal != Vec3{0}, "the normal has no length", "--clip-plane", "1,0,0 keeps what has the larger x");
  }
  for (const ClipBox& box : scene.clipBoxes) {
    const std::string where = box.keepsInside ? "--clip-box" : "--cut-box";
    check(isFinite(box.low) && isFinite(box.high), "a number is not finite", where, "give its ends in mesh units");
    check(all(lessThan(box.low, box.high)), "the box has no inside", where,
          "write the lower end before the upper one, along x, y and z");
  }
  if (!scene.threshold) return;
  const auto [low, high] = *scene.threshold;
  check(std::isfinite(low) && std::isfinite(high), "a number is not finite", "--threshold", "give two data values");
  check(low <= high, fmt::format("{} is above {}", low, high), "--threshold", "write the lower value first");
}

void clip(PreparedScene& prepared, const Scene& scene, std::span<const double> values) {
  checkClipping(scene);
  const std::size_t before = prepared.mesh.tetrahedra.size();
  prepared.faces = {};
  if (scene.threshold) {
    keepWithin(prepared, *scene.threshold, values);
    prepared.notes.push_back(
        fmt::format("{} of {} cells are within the threshold", prepared.mesh.tetrahedra.size(), before));
  }
  for (const ClipPlane& plane : scene.clipPlanes)
    keepInside(prepared, halfSpace(prepared.frame.toLocal(plane.point), plane.normal));
  for (const ClipBox& box : scene.clipBoxes) {
    const auto sides = sidesOf(box, prepared.frame);
    if (!box.keepsInside) {
      cutAway(prepared, sides);
      continue;
    }
    for (const HalfSpace& side : sides) keepInside(prepared, side);
  }
  if (prepared.mesh.tetrahedra.empty()) prepared.notes.push_back("nothing of the mesh is left: it is clipped away");
}

}  // namespace havs
