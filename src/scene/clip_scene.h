#pragma once
#include <span>

#include "mesh/mesh_cut.h"
#include "scene/prepared_scene.h"

namespace havs {

/// `whole` with another mesh: its points, cells and scalars follow the cut, scalars of points linear along edges, those
/// of cells copied. All that is said of the mesh besides (frame, longest edge, curve, field, knots in cells, notes)
/// stays that of the whole, so that the same camera sees the same. Without faces (buildFaces).
PreparedScene cutScene(const PreparedScene& whole, const MeshCut& cut);

/// Whether the scene asks for a part of its mesh only: clip planes and boxes, a threshold.
bool asksForPart(const Scene& scene);

/// Throws Error{input} for what cannot be meant: numbers that are not finite, a normal without length, a box without
/// inside, a threshold the wrong way round.
void checkClipping(const Scene& scene);

/// Leaves of the prepared mesh what lies in all of the scene's clip planes and boxes, and of cells that do not, the
/// pieces that do; before that, only the cells that are within its threshold: with all their points (point data) or
/// by their own value. `values`: of the field, not normalised. Perhaps nothing is left. Notes how much is. Leaves the
/// faces to be built. Throws Error{input} as checkClipping, and for planes too far away for double.
void clip(PreparedScene& prepared, const Scene& scene, std::span<const double> values);

}  // namespace havs
