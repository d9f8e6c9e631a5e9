#pragma once
#include <vector>

#include "image/image.h"
#include "overlay/line_coverage.h"
#include "scene/overlays.h"
#include "scene/view.h"

namespace havs {

/// The twelve edges of a box about the local frame's origin, as a view has them. The box is convex and the mesh inside,
/// so whatever a ray meets of an edge comes before all of the mesh or behind it.
struct OutlineLines {
  std::vector<PictureLine> front;  ///< of a side that faces the eye: rays meet them where they enter the box
  std::vector<PictureLine> back;   ///< the others, where rays leave it; all for an eye in the box
};
/// `halfSize`: of the box, local units.
OutlineLines outlineLines(const Vec3& halfSize, const View& view);

/// Composites the outline over the picture (front) and under it (back), where more than one edge covers a pixel the
/// coverage that is greatest. Parallel.
void addOutline(Image& image, const Outline& outline, const Vec3& halfSize, const View& view);

}  // namespace havs
