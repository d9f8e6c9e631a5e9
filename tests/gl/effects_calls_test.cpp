// OpenGL is asked for what the plan says and for nothing else: programs, textures and buffers counted where its
// functions are loaded, for every subset of effects up to pairs.
#include <gmock/gmock.h>

#include "core/error.h"
#include "gl/drawing.h"
#include "render/devices.h"
#include "render/lookup_resources.h"
#include "render/make_renderer.h"
#include "support/effect_subsets.h"
#include "support/gl_calls.h"
#include "support/gl_test.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

using testing::IsEmpty;

using Labels = std::multiset<std::string>;

/// The objects that hold an item of a plan on OpenGL.
struct ItemObjects {
  std::string item;
  Labels objects;
};

const Labels kLayers{"begins of layers", "distances of layers", "colours of layers"};

/// Of targets, vertex data and layers; those of the plan's resources are found by the names that they have in shaders/.
Labels objectsOf(const RenderPlan& plan, const PlanItem& item) {
  static const std::vector<ItemObjects> kRows{
      {"layers of the boundary surface", kLayers},
      {"layers of the wire frame", kLayers},
      {"place and scalar", {"points"}},
      {"corners of faces", {"face indices"}},
      {"corners of faces and of the cells behind them", {"corners of faces", "corners behind faces"}},
      {"numbers of faces", {"face order"}},
      {"scalars behind faces", {"scalars behind faces"}},
      {"light of points", {"light of points"}},
      {"colour", {"colour"}},
      {"done pixels", {"done pixels"}},
      {"whether any fragment is late", {"late flag"}},
      {"what is gathered", {"sums"}},
      {"colour, counts, ends of lists", {"colour", "fragment counts", "ends of lists"}},
      {"lists of fragments", {"fragments"}}};
  if (item.name == "k-buffer entries") {
    Labels labels;
    for (int i = 1; i <= plan.entryTargets; ++i) labels.insert("k-buffer " + std::to_string(i));
    return labels;
  }
  for (const ItemObjects& row : kRows)
    if (row.item == item.name) return row.objects;
  ADD_FAILURE() << "this test does not know what holds the item '" << item.name << "'";
  return {};
}

bool isOnDevice(const PlanItem& item) {
  return item.kind == PlanKind::vertexData || item.kind == PlanKind::target || item.stage == "layers";
}

struct Expected {
  Labels programs;
  std::set<std::string> objects;
};

Expected expectedOf(const RenderPlan& plan, const PreparedScene& prepared) {
  Expected expected;
  for (const PlannedProgram& program : plan.programs)
    expected.programs.insert(program.vertex + " + " + program.fragment);
  for (const PlanItem& item : plan.items)
    if (isOnDevice(item))
      for (const std::string& name : objectsOf(plan, item)) expected.objects.insert(name);
  for (const ResourceData& resource : makeResources(prepared, plan, {}))
    for (const auto& [name, table] : resource.tables) expected.objects.insert(name);
  return expected;
}

/// Buffers that a texture lies over have its label, too.
std::set<std::string> objectsOf(const GlCalls& calls) {
  std::set<std::string> names(calls.textures.begin(), calls.textures.end());
  names.insert(calls.buffers.begin(), calls.buffers.end());
  return names;
}

void expectBytes(const RenderPlan& plan, const GlCalls& calls) {
  for (const PlanItem& item : plan.items) {
    if (!isOnDevice(item) || item.bytes == 0) continue;
    std::size_t bytes = 0;
    for (const std::string& name : objectsOf(plan, item)) bytes += calls.bytes.at(name);
    // Points of boundary faces are there a second time.
    if (item.of == "point") {
      EXPECT_GE(bytes, item.bytes) << item.name;
      EXPECT_LE(bytes, 2 * item.bytes) << item.name;
    } else {
      EXPECT_EQ(bytes, item.bytes) << item.name;
    }
  }
}

/// What is written in each picture, though nothing has changed: the order of the faces is part of a frame, and its time
/// of the frame's (StageTimes, `--repeat`), as that of layers is; lists of fragments are as long as they are counted to
/// be.
Labels writtenBesideLayers(const RenderPlan& plan) {
  if (plan.gathering != Gathering::composite) return {};
  if (plan.visibility.name == "abuffer") return {"ends of lists"};
  if (plan.visibility.name == "cells") return {"face order"};
  return plan.cellData ? Labels{"face indices", "face order"} : Labels{"face indices"};
}

Labels writtenInEachPicture(const RenderPlan& plan) {
  Labels written = writtenBesideLayers(plan);
  if (plan.layers) written.insert(kLayers.begin(), kLayers.end());
  return written;
}

class EffectCalls : public FramebufferFetch {
 protected:
  static constexpr int kSide = 24;

  Scene sceneOf(const std::string& modeName) const {
    Scene scene;
    scene.mode = modeName;
    scene.lookup = "3d-normalised";
    scene.tableSize = 8;
    scene.width = scene.height = kSide;
    if (!mode(modeName).seesVolume) scene.isosurfaces = {{.value = 0.55, .color = {}, .opacity = 0.5}};
    return scene;
  }

  static TetMesh meshOf(bool cellData) {
    TetMesh mesh = ball(4);
    if (!cellData) {
      mesh.pointFields.push_back({"s", 1, linearField(mesh.points, {0.5, 0.2, 0})});
      return mesh;
    }
    std::vector<double> values;
    for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) values.push_back(static_cast<double>(c % 7));
    mesh.cellFields.push_back({"s", 1, std::move(values)});
    return mesh;
  }

  static EffectData dataOf(const PreparedScene& prepared) { return {prepared.curve.domain, prepared.frame.center}; }

  void expectOnlyWhatIsPlanned(const Scene& scene, bool cellData) {
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, meshOf(cellData), stages);
    const RenderPlan chosen = plan(scene, prepared.facts(), capabilitiesOf(*device_));
    const Expected expected = expectedOf(chosen, prepared);
    const View view = viewOf(scene, prepared);
    GlCallCounter counter;
    const auto renderer = makeRenderer(prepared, chosen, stages);
    renderer->draw(view, stages);
    const GlCalls first = counter.take();
    EXPECT_EQ(first.programs, expected.programs);
    EXPECT_EQ(first.shaders, 2 * expected.programs.size());
    EXPECT_EQ(objectsOf(first), expected.objects);
    for (const Labels* made : {&first.textures, &first.buffers})
      for (const std::string& name : *made) EXPECT_EQ(made->count(name), 1U) << name << " is made twice";
    if (!chosen.leavesOutCells) expectBytes(chosen, first);
    EXPECT_THAT(first.others, IsEmpty());
    EXPECT_FALSE(first.draws.empty());
    for (const auto& [program, draws] : first.draws) EXPECT_TRUE(expected.programs.contains(program)) << program;

    renderer->draw(view, stages);
    GlCalls second = counter.take();
    EXPECT_EQ(second.uploads, writtenInEachPicture(chosen));
    EXPECT_EQ(second.buffers, chosen.layers ? kLayers : Labels{});
    second.uploads.clear();
    second.buffers.clear();
    EXPECT_TRUE(second.madeNothing());
    EXPECT_EQ(second.draws, first.draws);
  }

  /// Of so many effects at most; those that the scene is refused with are left out.
  void expectOfSubsets(const Scene& plain, bool cellData, std::size_t mostEffects = 1) {
    StageTimes stages;
    const EffectData data = dataOf(prepareScene(plain, meshOf(cellData), stages));
    std::size_t drawn = 0;
    for (const EffectSubset& subset : subsetsUpToPairs()) {
      if (subset.size() > mostEffects) continue;
      SCOPED_TRACE(nameOf(subset) + (cellData ? ", cell data" : ""));
      const Scene scene = with(plain, subset, data);
      try {
        checkScene(scene);
        if (cellData && !scene.isosurfaces.empty()) continue;  // refused, too
      } catch (const Error&) {
        continue;
      }
      expectOnlyWhatIsPlanned(scene, cellData);
      ++drawn;
    }
    EXPECT_GT(drawn, 0U);
  }
};

TEST_P(EffectCalls, OfTheVolumeAreThoseOfThePlan) { expectOfSubsets(sceneOf("volume"), false, 2); }

TEST_P(EffectCalls, OfAPartOfTheCellsAreThoseOfThePlan) {
  Scene scene = sceneOf("volume");
  const TransferFile halfClear(R"({"version": 1, "opacity": "extinction", "unit_length": 1, "points": [
      {"scalar": 0, "color": [1, 1, 1], "opacity": 0}, {"scalar": 0.5, "color": [1, 1, 1], "opacity": 0},
      {"scalar": 1, "color": [1, 1, 1], "opacity": 1}]})");
  scene.transferFunction = halfClear.path();
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, meshOf(false), stages);
  ASSERT_TRUE(plan(scene, prepared.facts(), capabilitiesOf(*device_)).leavesOutCells);
  expectOfSubsets(scene, false);
}

TEST_P(EffectCalls, OfCellDataAreThoseOfThePlan) { expectOfSubsets(sceneOf("volume"), true); }

TEST_P(EffectCalls, OfOtherModesAreThoseOfThePlan) {
  for (const Mode& row : modes()) {
    if (row.name == "volume") continue;
    SCOPED_TRACE(row.name);
    expectOfSubsets(sceneOf(row.name), false);
    if (row.seesVolume) expectOfSubsets(sceneOf(row.name), true);
  }
}

TEST_P(EffectCalls, OfOtherVisibilityMethodsAreThoseOfThePlan) {
  for (const VisibilityMethod& row : visibilityMethods()) {
    if (row.name == "kbuffer") continue;
    SCOPED_TRACE(row.name);
    Scene scene = sceneOf("volume");
    scene.visibility = row.name;
    expectOfSubsets(scene, false);
    expectOfSubsets(scene, true);
  }
}

// What is called does not depend on how the context was made.
INSTANTIATE_TEST_SUITE_P(Devices, EffectCalls, testing::Values("osmesa"), [](const auto& test) { return test.param; });

// With a context of OpenGL current, which it must not touch.
TEST_P(EffectCalls, OfTheNativeDeviceAreNone) {
  const Capabilities native = openRenderDevice("native").capabilities;
  const Scene plain = sceneOf("volume");
  StageTimes stages;
  const EffectData data = dataOf(prepareScene(plain, meshOf(false), stages));
  for (const EffectSubset& subset : subsetsUpToPairs()) {
    if (subset.size() > 1) continue;
    SCOPED_TRACE(nameOf(subset));
    const Scene scene = with(plain, subset, data);
    const PreparedScene prepared = prepareScene(scene, meshOf(false), stages);
    GlCallCounter counter;
    makeRenderer(prepared, plan(scene, prepared.facts(), native), stages)->draw(viewOf(scene, prepared), stages);
    const GlCalls calls = counter.take();
    EXPECT_TRUE(calls.madeNothing());
    EXPECT_TRUE(calls.draws.empty());
  }
}

}  // namespace
}  // namespace havs::test
