#include "render/order_advice.h"

#include <algorithm>

#include "render/plan.h"

namespace havs {
namespace {

/// Whether there is a method of this name, another than the scene's, that takes the scene's lookup.
bool canSwitchTo(const std::string& visibility, const Scene& scene) {
  const auto rows = visibilityMethods();
  const bool colors = lookupOf(scene).carries == Payload::color;
  return scene.visibility != visibility && std::any_of(rows.begin(), rows.end(), [&](const VisibilityMethod& row) {
           return row.name == visibility && (row.carriesColors || !colors);
         });
}

}  // namespace

std::string orderAdvice(const Scene& scene, int k) {
  std::string text;
  auto add = [&](const std::string& option) { text += (text.empty() ? "" : " or ") + option; };
  if (scene.sort != "topological") add("--sort topological");
  if (!scene.kAuto && k < largestK(scene, {})) add("--k auto");
  if (canSwitchTo("abuffer", scene)) add("--visibility abuffer");
  return text;
}

}  // namespace havs
