#pragma once
// The makers of the rows of lookupResources(): what lookups read, as textures.
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/progress.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
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

/// Textures by the name of their sampler in the shader, and other uniforms by theirs.
struct ResourceTextures {
  std::map<std::string, Texture> samplers;
  std::map<std::string, std::variant<int, float, glm::vec3>> uniforms;
  std::vector<Buffer> buffers;  ///< that buffer textures look at
};

/// The mean length, local units, of the segments that rays from everywhere cut out of the cells: 4 V / S of each cell
/// for all lines through it (Cauchy), S the surface, so 4 (sum of V) / (sum of S) for all cells. The 2D table is made
/// for it.
double meanSegmentLength(const PreparedScene& prepared);

ResourceTextures makeCurveTextures(const ResourceInput& input);
ResourceTextures makeIntegralTextures(const ResourceInput& input);
ResourceTextures makeOpaqueTextures(const ResourceInput& input);
ResourceTextures makeTable2dTextures(const ResourceInput& input);
ResourceTextures makeTable3dTextures(const ResourceInput& input);
ResourceTextures makeMeanColorTextures(const ResourceInput& input);

}  // namespace havs
