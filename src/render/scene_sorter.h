#pragma once
#include <memory>
#include <string>

#include "scene/prepared_scene.h"
#include "sort/face_order.h"

namespace havs {

/// How the faces of a scene's visible part come into order, where the order follows the cells from one to the next.
enum class PartOrder {
  itsOwn,     ///< from the part alone: cheap, but gaps hide which cell is in front; refine() goes over to the other
  asInWhole,  ///< as the whole mesh's order has them: as exact as that, at its cost
};

/// The sorter of a row of sortMethods() for the faces of `prepared`, which must outlive it.
std::unique_ptr<FaceSorter> makeSceneSorter(const PreparedScene& prepared, const std::string& sort, PartOrder order);

}  // namespace havs
