#include "hard/random_case.h"

#include <fstream>

#include "app/scene_file.h"
#include "mesh/read.h"

namespace havs::test {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMesh = "mesh.node";
constexpr const char* kTransfer = "transfer.json";

Json readJson(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream);
}

Json sceneFile(const RandomCase& c) {
  Json scene{{"version", 1}, {"mesh", kMesh}, {"transfer_function", kTransfer}};
  scene.update(c.scene);
  return scene;
}

}  // namespace

void writeCase(const RandomCase& c, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scene.json") << sceneFile(c).dump(1) << '\n';
  std::ofstream(folder / kTransfer) << c.transfer.dump(1) << '\n';
  std::ofstream(folder / "case.json") << Json{{"story", c.story}, {"remedy", c.remedy}, {"overlaps", c.overlaps}}.dump(
                                             1)
                                      << '\n';
  writeMesh(c.mesh, folder / kMesh);
}

RandomCase readCase(const std::filesystem::path& folder) {
  const Json about = readJson(folder / "case.json");
  RandomCase c{readJson(folder / "scene.json"),
               readJson(folder / kTransfer),
               readMesh(folder / kMesh),
               about["overlaps"],
               about["story"],
               about["remedy"]};
  for (const char* key : {"version", "mesh", "transfer_function"}) c.scene.erase(key);
  return c;
}

Scene sceneOf(const RandomCase& c, const std::filesystem::path& folder) {
  std::ofstream(folder / kTransfer) << c.transfer.dump() << '\n';
  std::ofstream(folder / "scene.json") << sceneFile(c).dump() << '\n';
  SceneOptions options;
  options.mesh = (folder / "scene.json").string();
  std::vector<std::filesystem::path> outputs;
  readSceneFile(options, outputs, {});
  return makeScene(options);
}

}  // namespace havs::test
