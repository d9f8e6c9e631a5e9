#pragma once
#include "core/vec.h"

namespace havs {

/// Keeps the half of the mesh that `normal` points to. In mesh units; the normal's length does not matter.
struct ClipPlane {
  Vec3 point{0};
  Vec3 normal{0, 0, 1};
};

/// Keeps what lies in a box along the axes, or what lies outside of it. In mesh units, low < high along each.
struct ClipBox {
  Vec3 low{0}, high{1};
  bool keepsInside = true;
};

}  // namespace havs
