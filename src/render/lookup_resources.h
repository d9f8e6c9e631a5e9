#pragma once
// The makers of the rows of lookupResources(): what lookups read, as numbers. OpenGL reads them from textures
// (render/gl/lookup_textures.h), the native device from memory (render/native/lookup_data.h).
#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/progress.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"

namespace havs {

/// What resources are made from.
struct ResourceInput {
  const PreparedScene& prepared;
  const ExtinctionCurve& seen;  ///< the curve without its opaque intervals: what lies before an opaque surface
  const RenderPlan& plan;       ///< tableSize, tableFormat
  const Progress& progress;
};

/// Numbers that a lookup reads, the first axis fastest.
struct ResourceTable {
  /// Entries along each axis. One axis: read by number (Texels in shaders/). Two or three: over [0, 1] along each,
  /// filtered linearly (Table2d, Table3d), four numbers an entry, each one that the plan's table format holds.
  std::vector<int> sizes;
  int components = 4;  ///< numbers an entry: 1 or 4
  std::vector<float> values;
};

/// Tables and numbers by the names that they have in shaders/.
struct ResourceData {
  std::map<std::string, ResourceTable> tables;
  std::map<std::string, std::variant<int, float>> numbers;
  std::map<std::string, std::vector<float>> rows;  ///< of as many numbers as the shader says (UNIFORM_NUMBERS)
};

/// All that the plan's lookup reads, one for each of its resources. Throws Error{running} (no memory).
std::vector<ResourceData> makeResources(const PreparedScene& prepared, const RenderPlan& plan,
                                        const Progress& progress);

/// The mean length, local units, of the segments that rays from everywhere cut out of the cells: 4 V / S of each cell
/// for all lines through it (Cauchy), S the surface, so 4 (sum of V) / (sum of S) for all cells. The 2D table is made
/// for it.
double meanSegmentLength(const PreparedScene& prepared);

ResourceData makeCurve(const ResourceInput& input);
ResourceData makeFewPieces(const ResourceInput& input);
ResourceData makeIntegrals(const ResourceInput& input);
ResourceData makeOpaqueIntervals(const ResourceInput& input);
ResourceData makeIsosurfaces(const ResourceInput& input);
ResourceData makeTable2d(const ResourceInput& input);
ResourceData makeTable3d(const ResourceInput& input);
ResourceData makeMeanColorTable(const ResourceInput& input);

}  // namespace havs
