#pragma once
#include <vector>

#include "light/light_data.h"
#include "light/light_plan.h"
#include "render/native/tile_light.h"
#include "scene/view.h"

namespace havs {

/// `rows` (LightData::rowsFor) must outlive it.
TileLight tileLight(const LightPlan& plan, const std::vector<float>& rows, const std::vector<ViewLight>& lights,
                    const View& view);

}  // namespace havs
