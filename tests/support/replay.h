#pragma once
// The k-buffer replayed on the CPU: for each pixel the fragments of the faces in the given order, with exact coverage,
// through the very functions that the shaders run (core/arithmetic.h), in double. Counts misordered fragments and
// checks entries against exits.
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "mesh/faces.h"
#include "scene/view.h"
#include "sort/face_order.h"

namespace havs::test {

/// Premultiplied colour of a segment of the ray.
using Rgba = std::array<double, 4>;
using SegmentColor = std::function<Rgba(double scalarFront, double scalarBack, double length)>;

/// What is drawn. All points must lie in front of the eye (std::invalid_argument otherwise).
struct ReplayInput {
  std::span<const Vec3> points;  ///< local
  const Faces* faces = nullptr;
  std::span<const Index> order;     ///< faces as they come
  std::span<const double> scalars;  ///< one a point; empty: 0
  View view;
};

struct ReplayResult {
  std::vector<Rgba> image;  ///< row 0 on top; empty when no colour was asked for
  std::size_t fragments = 0;
  std::size_t misordered = 0;  ///< late fragments (docs/02-method.md, The k-buffer)
  std::size_t misorderedPixels = 0;
  std::size_t unbalancedPixels = 0;  ///< where entries and exits differ in number
  std::size_t negativePixels = 0;    ///< where the inside-count is negative over more than a tie
  double longestSegment = 0;         ///< of those drawn
};

/// Replays with each k of `ks` (1 to 14); one result each, in the order of `ks`. Parallel over tiles.
std::vector<ReplayResult> replay(const ReplayInput& input, std::span<const int> ks, const SegmentColor& color = {});
ReplayResult replay(const ReplayInput& input, int k, const SegmentColor& color = {});

/// What a sorter needs to know of the view.
ViewPoint viewPoint(const View& view);

/// Colour 1 and opacity 1 - exp(-extinction * length), premultiplied: closed form for constant extinction.
SegmentColor constantExtinction(double extinction);
/// Colour (s, s^2, 1) at the mean scalar and extinction * mean scalar: tells scalars apart, too.
SegmentColor scalarExtinction(double extinction);

/// Largest difference of any component.
double greatestDifference(const std::vector<Rgba>& a, const std::vector<Rgba>& b);

}  // namespace havs::test
