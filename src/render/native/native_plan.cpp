// What drawing takes on the native device.
#include "core/error.h"
#include "render/native/renderers.h"

namespace havs {
namespace {

constexpr int kTileSide = 64;        // at most kLargestTileStamps stamps
constexpr int kPictureAndScale = 5;  // numbers of a pixel: colour, length of its ray for one unit of depth

constexpr std::size_t kBytesPerPoint = 64;  // RasterPoint

/// The targets of a tile, of which each thread has one.
void planTiles(RenderPlan& plan, int numbersOfPixel, const std::string& reason) {
  plan.bytesPerPixel = 4 * (kPictureAndScale + numbersOfPixel) + (plan.certificate ? 4 : 0);
  plan.tileWidth = plan.tileHeight = kTileSide;
  addItem(plan, PlanKind::target, "a tile", "draw", reason, static_cast<std::size_t>(plan.bytesPerPixel), "pixel",
          std::size_t{kTileSide} * kTileSide);
}

void planMesh(RenderPlan& plan, const SceneFacts& facts) {
  addItem(plan, PlanKind::vertexData, "points in the picture", "order", "faces are drawn from them", kBytesPerPoint,
          "point", facts.points);
  const bool colors = plan.lookup.carries == Payload::color;
  if (facts.cellData && plan.gathering != Gathering::sum)
    addItem(plan, PlanKind::vertexData, colors ? "colours behind faces" : "scalars behind faces", "",
            "the field belongs to the cells", colors ? 32 : 8, "face", facts.faces);
  if (colors && !facts.cellData)
    addItem(plan, PlanKind::vertexData, "colour and extinction", "",
            "the lookup '" + plan.lookup.name + "' has fragments carry them", 16, "point", facts.points);
  addItem(plan, PlanKind::pass, "points into the picture, faces or cells into tiles", "order",
          "each tile draws its own");
}

void planKernels(RenderPlan& plan, const std::string& tiles, const std::string& reason) {
  addProgram(plan, "tiles", "", tiles + ", " + plan.instructionSet, reason, {});
  if (!plan.lookup.shader.empty())
    addProgram(plan, "segments", "", plan.lookup.shader + ", " + plan.instructionSet,
               "segments are looked up together: " + plan.lookup.name, {});
}

}  // namespace

void planNativeKBuffer(RenderPlan& plan, const Scene& scene, const SceneFacts& facts, const Capabilities&) {
  if (scene.targetFormat != "32f")
    failInput("the native device keeps its k-buffer in 32-bit numbers", "--target-format",
              "leave it out, or draw on another device");
  plan.k = scene.k;
  plan.targetFormat = targetFormat(scene.targetFormat);
  planMesh(plan, facts);
  planKernels(plan, "k-buffer of " + std::to_string(plan.k), "the visibility method kbuffer");
  if (plan.speculate && plan.k > 1 && !(plan.earlyTermination > 0))
    addProgram(plan, "ordered tiles", "", "last fragment, " + plan.instructionSet,
               "most pixels have their fragments in order; the others are drawn again", {});
  const int ofLayers = plan.layers ? 2 : 0;  // the next, and the end
  planTiles(plan, 2 + plan.k * (2 + numbersOf(plan.lookup.carries)) + ofLayers, "k is " + std::to_string(plan.k));
  addItem(plan, PlanKind::pass, "draw the tiles", "draw", "the mode " + plan.mode);
}

void planNativeGathering(RenderPlan& plan, const Scene&, const SceneFacts& facts, const Capabilities&) {
  const std::string reason = "the mode " + plan.mode;
  planMesh(plan, facts);
  if (plan.gathering == Gathering::sum) {
    if (facts.cellData)
      addItem(plan, PlanKind::vertexData, "scalars of cells", "", "the field belongs to the cells", 4, "cell",
              facts.cells);
    planKernels(plan, "segments of cells", reason + " adds up what they measure");
  } else {
    planKernels(plan, plan.gathering == Gathering::greatest ? "greatest scalar" : "least scalar", reason);
  }
  planTiles(plan, plan.gathering == Gathering::sum ? 0 : 1, reason);
  addItem(plan, PlanKind::pass, "draw the tiles in any order", "draw", reason);
}

}  // namespace havs
