#pragma once
#include <string>

#include "scene/scene.h"

namespace havs {

/// Options that may put in order what a picture of this scene, drawn with `k` entries, left misordered: "--sort
/// topological or --k auto". Empty where nothing is left to try.
std::string orderAdvice(const Scene& scene, int k);

}  // namespace havs
