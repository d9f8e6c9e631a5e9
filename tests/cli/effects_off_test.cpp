// A scene that mentions an effect switched off is the scene that does not mention it: the same plan, and the same bits
// of its picture. For every row of effects().
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "render/effects.h"

namespace havs::test {
namespace {

using nlohmann::json;

/// Keys of a scene file. A row of effects() without one here fails.
struct OffForm {
  std::string effect;
  json base;  ///< what a scene has besides
  json off;   ///< the effect, mentioned and switched off
  json on;    ///< switched on: what off is held against
};
const std::vector<OffForm>& offForms() {
  static const std::vector<OffForm> rows{
      {"clipping",
       {},
       {{"clip_plane", json::array()}, {"clip_box", json::array()}, {"cut_box", json::array()}},
       {{"clip_plane", {0.5, 0.5, 0.5, 1, 0, 0}}}},
      {"threshold", {}, {{"threshold", nullptr}}, {{"threshold", {0, 1}}}},
      {"lighting", {}, {{"lighting", nullptr}}, {{"lighting", "default"}}},
      {"silhouettes",
       {{"lighting", "default"}},
       {{"lighting", {{"silhouettes", 0}}}},
       {{"lighting", {{"silhouettes", 1}}}}},
      {"modulation", {}, {{"modulation", 0}}, {{"modulation", 1}}},
      {"ambient occlusion", {}, {{"occlusion", nullptr}}, {{"occlusion", {{"directions", 8}}}}},
      {"shadows", {{"lighting", "default"}}, {{"shadows", false}}, {{"shadows", true}}},
      {"ambient scattering", {}, {{"scattering", nullptr}}, {{"scattering", "default"}}},
      {"isosurfaces", {}, {{"isosurfaces", json::array()}}, {{"isosurfaces", {{{"value", 3}}}}}},
      {"outline", {}, {{"outline", nullptr}}, {{"outline", "default"}}},
      {"surface", {}, {{"surface", nullptr}}, {{"surface", "default"}}},
      {"wire frame", {}, {{"wireframe", nullptr}}, {{"wireframe", "default"}}}};
  return rows;
}

/// Gradients that differ from point to point.
const std::string kCurvedNode =
    "8 3 1 0\n"
    "0 0 0 0 0\n1 1 0 0 1\n2 0 1 0 1\n3 1 1 0 4\n"
    "4 0 0 1 2\n5 1 0 1 2\n6 0 1 1 5\n7 1 1 1 9\n";

class EffectsOff : public testing::TestWithParam<std::string> {
 protected:
  EffectsOff() { writeTetgenMesh(folder, "cube", kCurvedNode, kCubeEle); }

  std::string run(const std::string& command, const std::string& name, const json& scene,
                  const std::vector<std::string>& more) const {
    json whole{{"version", 1}, {"mesh", "cube.node"}, {"size", {32, 24}}, {"unit_length", 1}, {"device", GetParam()}};
    whole.update(scene);
    folder.write(name + ".json", whole.dump());
    std::vector<std::string> arguments{command, name + ".json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runHavs(arguments, folder.path());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return outcome.output;
  }
  std::string pictureOf(const std::string& name, const json& scene) const {
    run("render", name, scene, {"-o", name + ".exr", "--quiet"});
    return contentOf(folder / (name + ".exr"));
  }
  std::string planOf(const json& scene) const { return run("plan", "plan", scene, {"--json", "--quiet"}); }

  static json with(json scene, const json& keys) {
    if (scene.is_null()) scene = json::object();
    if (!keys.is_null()) scene.update(keys);
    return scene;
  }

  TemporaryFolder folder;
};

TEST_P(EffectsOff, AreTheSceneThatDoesNotMentionThem) {
  for (const OffForm& form : offForms()) {
    SCOPED_TRACE(form.effect);
    const json plain = with({}, form.base), off = with(plain, form.off);
    const std::string picture = pictureOf("plain", plain);
    EXPECT_EQ(planOf(plain), planOf(off));
    EXPECT_TRUE(picture == pictureOf("off", off)) << "the bits of the pictures differ";
    EXPECT_FALSE(picture == pictureOf("on", with(plain, form.on))) << "the effect shows nothing here";
  }
}

TEST_P(EffectsOff, AllAtOnceAreTheSceneThatMentionsNone) {
  json all = json::object();
  for (const OffForm& form : offForms())
    if (form.base.is_null()) all.update(form.off);
  EXPECT_EQ(planOf(json::object()), planOf(all));
  EXPECT_TRUE(pictureOf("plain", json::object()) == pictureOf("off", all));
}

INSTANTIATE_TEST_SUITE_P(Devices, EffectsOff, testing::Values("native", "osmesa"),
                         [](const auto& test) { return test.param; });

TEST(EffectsOffForms, AreThereForEveryEffect) {
  for (const Effect& effect : effects())
    EXPECT_TRUE(std::any_of(offForms().begin(), offForms().end(),
                            [&](const OffForm& form) { return form.effect == effect.name; }))
        << effect.name << " needs a row here";
  EXPECT_EQ(offForms().size(), effects().size());
}

// What an option says wins over the file.
TEST_P(EffectsOff, AnOptionTakesAnEffectAwayFromAFile) {
  const json lit{{"lighting", "default"}, {"occlusion", {{"directions", 8}}}, {"threshold", {0, 9}}};
  run("render", "lit", lit,
      {"--lighting", "none", "--occlusion", "none", "--scattering", "none", "--threshold", "none", "-o", "gone.exr",
       "--quiet"});
  EXPECT_TRUE(contentOf(folder / "gone.exr") == pictureOf("plain", json::object()));
}

}  // namespace
}  // namespace havs::test
