#pragma once
// Boxes with a field that is linear in place: a ray's whole way through one is a segment, whatever the cells.
#include <algorithm>
#include <cmath>

#include "hard/hard_case.h"
#include "hard/segment_truth.h"
#include "support/meshes.h"

namespace havs::test {

inline TetMesh withPoints(TetMesh mesh, std::vector<double> values) {
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

/// [-1, 1]^3 with inner points moved, and low + range * (place along a slanted direction, from 0 to 1).
struct SlantedBox {
  double low = 0, range = 1;
  int cells = 3;

  double valueAt(const Vec3& p) const { return low + range * (0.5 + dot(Vec3(0.2, 0.15, 0.15), p)); }
  TetMesh mesh() const {
    TetMesh mesh = box(cells, Cut::five, 0.2);
    auto values = pointValues(mesh.points, [&](const Vec3& p) { return valueAt(p); });
    return withPoints(std::move(mesh), std::move(values));
  }
};

/// Where a pixel's ray goes through [-1, 1]^3, in mesh units; the same point twice where it misses.
struct Chord {
  Vec3 entry, exit;
};

inline Chord chordOf(const HardPicture& picture, int x, int y) {
  const View& view = picture.view;
  const LocalFrame& frame = picture.prepared.frame;
  const double u = (2.0 * (x + 0.5) / view.width - 1.0) * view.halfWidth;
  const double v = (1.0 - 2.0 * (y + 0.5) / view.height) * view.halfHeight;
  const Vec3 across = u * view.right + v * view.up;
  const Vec3 origin = frame.center + frame.radius * (view.orthographic ? view.center + across : view.eye);
  const Vec3 direction = view.orthographic ? view.forward : normalize(view.forward + across);
  double first = -1e300, last = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (-1 - origin[axis]) / direction[axis], b = (1 - origin[axis]) / direction[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last)) return {origin, origin};
  return {origin + first * direction, origin + last * direction};
}

/// The largest difference of the reference, at one pixel of 29, from the definition's integral over the whole
/// chord. The transfer function's domain is [0, 1].
inline double worstChord(const HardPicture& picture, const SegmentTruth& truth, const SlantedBox& box) {
  double worst = 0;
  for (int i = 0; i < picture.view.width * picture.view.height; i += 29) {
    const int x = i % picture.view.width, y = i / picture.view.width;
    const Chord chord = chordOf(picture, x, y);
    const double extent = length(chord.exit - chord.entry);
    SegmentRgba expected{};
    if (extent > 0)
      expected = truth.along(std::clamp(box.valueAt(chord.entry), 0.0, 1.0),
                             std::clamp(box.valueAt(chord.exit), 0.0, 1.0), extent);
    const float* pixel = &picture.truth.rgba[4 * static_cast<std::size_t>(i)];
    worst = std::max(worst, distance({pixel[0], pixel[1], pixel[2], pixel[3]}, expected));
  }
  return worst;
}

/// Of the native device, where extinction is great: both ends of a ray's way are float distances of up to one radius,
/// off by 2^-25 each, and what that much extinction shows between them.
inline HardBounds boundsOfDensity(double mostExtinction, double unitLength) {
  const double radius = std::sqrt(3.0);
  HardBounds bounds;
  bounds.native += 0x1p-24 * mostExtinction * radius / unitLength;
  return bounds;
}

}  // namespace havs::test
