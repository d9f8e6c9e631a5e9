#include "scene/plan.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace havs {
namespace {

constexpr int kBytesPerTarget = 16;                      // RGBA32F
constexpr double kMostTileBytes = 1024.0 * 1024 * 1024;  // of all targets of a tile
constexpr double kMostPixels = 1 << 30;                  // 16 GiB of float picture
constexpr int kLargestSide = 1 << 17;
constexpr int kSmallestTable = 2, kLargestTable = 512;

void checkRange(double value, double least, double most, const std::string& name) {
  if (!(value >= least && value <= most)) {
    auto text = [](double x) {
      return x == std::floor(x) ? std::to_string(static_cast<long long>(x)) : std::to_string(x);
    };
    failInput(name + " is " + text(value), "", "it must lie between " + text(least) + " and " + text(most));
  }
}

/// Halves the longer side until all targets of a tile fit.
void chooseTile(RenderPlan& result, const Scene& scene, const Capabilities& capabilities) {
  result.tileWidth = std::min(scene.width, capabilities.maximumTextureSize);
  result.tileHeight = std::min(scene.height, capabilities.maximumTextureSize);
  while (static_cast<double>(result.tileWidth) * result.tileHeight * result.bytesPerPixel > kMostTileBytes) {
    int& longer = result.tileWidth >= result.tileHeight ? result.tileWidth : result.tileHeight;
    longer = (longer + 1) / 2;
  }
}

std::vector<ShaderDefine> definesOf(const RenderPlan& result, const Scene& scene, const SceneFacts& facts) {
  std::vector<ShaderDefine> defines{{"HAVS_K", std::to_string(result.k)},
                                    {"HAVS_ENTRY_TARGETS", std::to_string(result.entryTargets)}};
  if (scene.earlyTermination > 0) defines.push_back({"HAVS_EARLY_TERMINATION", "1"});
  if (scene.compositeLate) defines.push_back({"HAVS_COMPOSITE_LATE", "1"});
  if (facts.cellData) defines.push_back({"HAVS_CELL_DATA", "1"});
  if (facts.opaqueSurfaces) defines.push_back({"HAVS_OPAQUE_SURFACES", "1"});
  if (result.lookup.table == LookupTable::table3d && result.tableFormat.eightBits)
    defines.push_back({"HAVS_FILTER_IN_SHADER", "1"});
  return defines;
}

}  // namespace

void checkScene(const Scene& scene) {
  const VisibilityMethod& method = visibilityMethod(scene.visibility);
  checkRange(scene.k, 1, method.maximumK, "k");
  const Lookup& row = lookup(scene.lookup);
  if (row.table == LookupTable::table3d) {
    tableFormat(scene.tableFormat);
    checkRange(scene.tableSize, kSmallestTable, kLargestTable, "the table's size");
  }
  checkRange(scene.width, 1, kLargestSide, "the picture's width");
  checkRange(scene.height, 1, kLargestSide, "the picture's height");
  if (static_cast<double>(scene.width) * scene.height > kMostPixels)
    failInput("a picture of " + std::to_string(scene.width) + " x " + std::to_string(scene.height) + " is too large",
              "", "2^30 pixels are the most");
  checkRange(scene.earlyTermination, 0, 1, "the opacity of early termination");
  checkRange(scene.repeat, 1, 1000000, "repeat");
  if (scene.unitLength && !(*scene.unitLength > 0 && std::isfinite(*scene.unitLength)))
    failInput("the unit length must be greater than 0", "", "give it in mesh units");
  if (scene.domain &&
      !((*scene.domain)[0] < (*scene.domain)[1] && std::isfinite((*scene.domain)[1] - (*scene.domain)[0])))
    failInput("the domain must be two finite numbers, the smaller first", "", "for example 0,1");
}

RenderPlan plan(const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities) {
  checkScene(scene);
  RenderPlan result;
  result.visibility = visibilityMethod(scene.visibility);
  const auto& needed = result.visibility.extensions;
  const auto found = std::find_if(needed.begin(), needed.end(), capabilities.hasExtension);
  if (!needed.empty() && found == needed.end())
    failRunning("this OpenGL cannot keep a pixel's reads and writes in order (it lacks " + needed.front() + ")", "",
                "try --device osmesa");
  if (found != needed.end()) result.ordering = *found;

  result.k = scene.k;
  result.entryTargets = (scene.k + 1) / 2;
  if (1 + result.entryTargets > capabilities.maximumDrawBuffers)
    failRunning("k = " + std::to_string(scene.k) + " needs " + std::to_string(1 + result.entryTargets) +
                    " render targets, this OpenGL has " + std::to_string(capabilities.maximumDrawBuffers),
                "", "choose a smaller k");
  result.bytesPerPixel = kBytesPerTarget * (1 + result.entryTargets);

  result.lookup = lookup(scene.lookup);
  if (result.lookup.table == LookupTable::table3d) {
    result.tableFormat = tableFormat(scene.tableFormat);
    result.tableSize = scene.tableSize;
    if (scene.tableSize > capabilities.maximum3dTextureSize)
      failRunning("a table of " + std::to_string(scene.tableSize) + "^3 is larger than this OpenGL's 3D textures (" +
                      std::to_string(capabilities.maximum3dTextureSize) + ")",
                  "", "choose a smaller one");
  }
  result.earlyTermination = scene.earlyTermination;
  result.cellData = facts.cellData;
  result.needsCurveTexture = result.lookup.table == LookupTable::curve || facts.opaqueSurfaces;
  result.defines = definesOf(result, scene, facts);
  chooseTile(result, scene, capabilities);
  return result;
}

}  // namespace havs
