#pragma once
// The views of a scene file: pictures of one scene by several cameras, with the mesh read and prepared once.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/scene_options.h"

namespace havs {

inline constexpr const char* kViewsKey = "views";

/// The list under kViewsKey; null: none. Throws Error{input}: no such list, an unknown key (naming the nearest), a
/// value of another kind, an empty list, a view without outputs where others have some.
std::vector<ViewOptions> readViews(const nlohmann::ordered_json& list, const std::filesystem::path& file);
/// Back, as readViews reads it from a file in `folder`.
nlohmann::ordered_json viewsAsJson(const std::vector<ViewOptions>& views, const std::filesystem::path& folder);
nlohmann::ordered_json viewsSchema();

/// The options of each view, without views of their own; where there are none, of the scene alone. What a view does
/// not say is the scene's.
std::vector<SceneOptions> optionsOfViews(const SceneOptions& options);

/// Throws Error{input} where the scene has several views: `option` is for one picture.
void refuseViews(const SceneOptions& options, const char* option);

}  // namespace havs
