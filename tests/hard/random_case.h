#pragma once
// A case of the random tests: what the files hold that `havs render` draws it from.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "mesh/tet_mesh.h"
#include "scene/scene.h"

namespace havs::test {

struct RandomCase {
  nlohmann::ordered_json scene;     ///< a scene file, without `mesh` and `transfer_function`
  nlohmann::ordered_json transfer;  ///< a transfer function's file
  TetMesh mesh;                     ///< with one field
  bool overlaps = false;            ///< cells may: no truth is known, the picture must be one
  std::string story, remedy;        ///< of a case that was found: what it showed, what was done
};

/// scene.json, transfer.json, mesh.node, mesh.ele, and case.json with what havs does not read.
void writeCase(const RandomCase& c, const std::filesystem::path& folder);
/// The same from there.
RandomCase readCase(const std::filesystem::path& folder);

/// The scene, read by the program's own reader from files that are written to `folder`, and used from there.
Scene sceneOf(const RandomCase& c, const std::filesystem::path& folder);

}  // namespace havs::test
