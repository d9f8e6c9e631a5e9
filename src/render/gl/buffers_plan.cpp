// What the mesh takes in the memory of OpenGL.
#include "render/gl/renderers.h"

namespace havs {
namespace {

constexpr std::size_t kBytesPerNumber = 4;

}  // namespace

void planFaceBuffers(RenderPlan& plan, const SceneFacts& facts) {
  const bool colors = plan.lookup.carries == Payload::color;
  addItem(plan, PlanKind::vertexData, "place and scalar", "upload_mesh",
          "corners of faces; those of boundary faces a second time", 4 * kBytesPerNumber, "point", facts.points);
  addItem(plan, PlanKind::vertexData, "corners of faces", "upload",
          plan.sort.empty() ? "faces are drawn" : "written anew in each picture's order", 3 * kBytesPerNumber, "face",
          facts.faces);
  if (colors && !facts.cellData)
    addItem(plan, PlanKind::vertexData, "colour and extinction", "upload_mesh",
            "the lookup '" + plan.lookup.name + "' has fragments carry them", 4 * kBytesPerNumber, "point",
            facts.points);
  if (plan.light.lit)
    addItem(plan, PlanKind::vertexData, "light of points", "upload_mesh", "fragments are lit",
            static_cast<std::size_t>((plan.light.rowLength + 3) / 4 * 4) * kBytesPerNumber, "point", facts.points);
  if (!facts.cellData) return;
  addItem(plan, PlanKind::vertexData, colors ? "colours behind faces" : "scalars behind faces", "upload_mesh",
          "the field belongs to the cells", (colors ? 8 : 2) * kBytesPerNumber, "face", facts.faces);
  addItem(plan, PlanKind::vertexData, "numbers of faces", "upload", "fragments look up the cell behind their face",
          kBytesPerNumber, "face", facts.faces);
}

void planCellBuffers(RenderPlan& plan, const SceneFacts& facts) {
  addItem(plan, PlanKind::vertexData, "place and scalar", "upload_mesh", "corners of cells", 4 * kBytesPerNumber,
          "point", facts.points);
  addItem(plan, PlanKind::vertexData, "corners of faces and of the cells behind them", "upload_mesh",
          "a face's fragment finds where its ray leaves the cell", 5 * kBytesPerNumber, "face", facts.faces);
  addItem(plan, PlanKind::vertexData, "numbers of faces", "upload", "in which they are drawn", kBytesPerNumber, "face",
          facts.faces);
  if (facts.cellData)
    addItem(plan, PlanKind::vertexData, "scalars behind faces", "upload_mesh", "the field belongs to the cells",
            2 * kBytesPerNumber, "face", facts.faces);
}

}  // namespace havs
