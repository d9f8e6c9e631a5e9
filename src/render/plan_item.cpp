#include "render/plan_item.h"

namespace havs {

const char* nameOf(PlanKind kind) {
  switch (kind) {
    case PlanKind::pass:
      return "pass";
    case PlanKind::program:
      return "program";
    case PlanKind::vertexData:
      return "vertex data";
    case PlanKind::target:
      return "target";
    case PlanKind::table:
      return "table";
    case PlanKind::precomputation:
      return "precomputation";
  }
  return "";
}

}  // namespace havs
