#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/stage_times.h"
#include "mesh/defects.h"
#include "mesh/faces.h"
#include "mesh/local_frame.h"
#include "mesh/mesh_cut.h"
#include "mesh/scalar_field.h"
#include "mesh/tet_mesh.h"
#include "scene/scene.h"
#include "scene/view.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// A scene's data made ready to be drawn by any renderer: mended, normalised, with faces.
struct PreparedScene {
  TetMesh mesh;                 ///< without fields; points in mesh units
  std::vector<Defect> defects;  ///< of the mesh as read
  std::vector<std::string> notes;
  ScalarField field;  ///< without values; they are in `scalars`
  LocalFrame frame;
  std::vector<Vec3> points;  ///< local frame
  double longestEdge = 0;    ///< local frame
  Faces faces;
  ExtinctionCurve curve;
  std::string transferFunction;
  OpacityMeaning meaning = OpacityMeaning::perUnit;
  std::vector<ShownIsosurface> isosurfaces;  ///< ascending
  double knotsInCells = 0;                   ///< scene/knots_in_cells.h
  bool clearCells = false;                   ///< SceneFacts::clearCells
  bool cellsWithoutSurface = false;          ///< SceneFacts::cellsWithoutSurface
  std::vector<double> scalars;               ///< normalised to the domain, [0, 1]; one a point or one a cell
  const PreparedScene* whole = nullptr;      ///< of which this is the part that shows anything (scene/visible_part.h)
  std::vector<Index> pointsInWhole;          ///< then, the number there of each point; ascending
  const PreparedScene* uncut = nullptr;      ///< of which this is what lies before the eye (scene/eye_cut.h)
  std::vector<MeshCut> cuts;                 ///< then, one after the other from that
  Vec3 origin{0};                            ///< then, where its local frame has its origin in that one's
  glm::dmat3 axes{1};                        ///< then, the axes of its local frame in that one's, as columns
  std::vector<Index> facesInWhole;           ///< then, the number there of each of `faces`; ascending

  SceneFacts facts() const;
};

/// Reads and prepares. Stages timed: read, prepare, faces. Throws Error{input} for anything wrong with the scene's
/// files and names.
PreparedScene prepareScene(const Scene& scene, StageTimes& stages, const Progress& progress = {});

/// Prepares a mesh that is in memory already (tests, studies).
PreparedScene prepareScene(const Scene& scene, TetMesh mesh, StageTimes& stages);

/// What is said of a scene besides its cells (frame, longest edge, curve, isosurfaces, field, notes): for a part of it.
PreparedScene withoutMesh(const PreparedScene& whole);

/// The view of the scene's camera. Throws Error{input} as makeView.
View viewOf(const Scene& scene, const PreparedScene& prepared);

/// Whether a point of the local frame lies in a cell, its boundary included, or beyond no side of one by more than
/// `reach`. Parallel.
bool reachesMesh(const PreparedScene& prepared, const Vec3& point, double reach = 0);

}  // namespace havs
