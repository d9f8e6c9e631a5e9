#include "render/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/effect_parts.h"
#include "render/effects.h"
#include "render/native/instruction_sets.h"
#include "sort/face_order.h"

namespace havs {
namespace {

constexpr double kMostTileBytes = 1024.0 * 1024 * 1024;  // of all targets of a tile
constexpr double kMostPixels = 1 << 30;                  // 16 GiB of float picture
constexpr int kLargestSide = 1 << 17;
constexpr int kSmallestTable = 2;
/// Most knots in a cell, on the mean, that `exact` is chosen for: measured (docs/07-performance.md, The lookup by
/// default).
constexpr double kFewKnots = 2;
/// Takes the light from knot to knot; others weigh that of a segment's two ends (docs/03-scene.md, Light).
constexpr const char* kLookupOfLit = "exact";

/// What segments are looked up in, or measured with.
void planLookup(RenderPlan& result, const Scene& scene, const SceneFacts& facts, const Capabilities& capabilities) {
  if (result.lookup.number > 0) result.defines.push_back({"HAVS_LOOKUP_NUMBER", std::to_string(result.lookup.number)});
  if (facts.cellData) result.defines.push_back({"HAVS_CELL_DATA", "1"});
  if (result.lookup.carries == Payload::color) {
    result.defines.push_back({"HAVS_COLOR_PAYLOAD", "1"});
    return;  // opaque surfaces are scalars, which such fragments do not know
  }
  if (result.opaqueSurfaces) result.defines.push_back({"HAVS_OPAQUE_SURFACES", "1"});
  for (const std::string& name : result.lookup.resources)
    addResource(result, name, "the lookup '" + result.lookup.name + "' reads it", scene, capabilities);
  if (result.opaqueSurfaces)
    for (const char* name : {"curve", "opaque intervals"})
      addResource(result, name, "the transfer function reaches opacity 1: segments end at opaque surfaces", scene,
                  capabilities);
}

/// The extension among those that the method can use, where it needs one.
std::string orderingOf(const VisibilityMethod& method, const Capabilities& capabilities) {
  const auto& needed = method.extensions;
  if (needed.empty()) return "";
  const auto found = std::find_if(needed.begin(), needed.end(), capabilities.hasExtension);
  if (found == needed.end())
    failRunning("this OpenGL cannot keep a pixel's reads and writes in order (it lacks " + needed.front() + ")", "",
                "try --device osmesa");
  return *found;
}

/// How the method draws on the device.
const DrawingWay& wayOf(const Mode& mode, const VisibilityMethod& method, const Capabilities& capabilities) {
  if (mode.gathering != Gathering::composite) return capabilities.native ? mode.native : mode.gl;
  if (!capabilities.native) return method.gl;
  if (method.native.make == nullptr) {
    std::string names;
    for (const VisibilityMethod& other : visibilityMethods())
      if (other.native.make != nullptr) names += (names.empty() ? "" : " or ") + other.name;
    failInput("the native device does not draw with the visibility method " + method.name, "--device native",
              "draw with --visibility " + names + ", or on another device");
  }
  return method.native;
}

void refuseWhatTheModeLacks(const Scene& scene, const Mode& mode) {
  if (!mode.seesVolume && scene.isosurfaces.empty())
    failInput("the mode " + mode.name + " has nothing to show", "--mode", "add --isosurface VALUE");
  if (mode.gathering == Gathering::composite) return;
  if (scene.earlyTermination > 0)
    failInput("the mode " + mode.name + " composites nothing that could end pixels early", "--early-termination",
              "leave it out");
}

void refuseWhatTheMethodLacks(const Scene& scene, const VisibilityMethod& method, const Lookup& chosen) {
  if (chosen.carries == Payload::color && !method.carriesColors)
    failInput("fragments of the lookup '" + chosen.name + "' carry colours, which the visibility method " +
                  method.name + " does not take",
              "--lookup", "draw with --visibility " + methodsWith(&VisibilityMethod::carriesColors));
  if (scene.earlyTermination > 0 && !method.endsPixelsEarly)
    failInput("the visibility method " + method.name + " cannot end pixels early", "--early-termination",
              "leave it out, or draw with --visibility " + methodsWith(&VisibilityMethod::endsPixelsEarly));
  if (scene.compositeLate && !method.dropsLateFragments)
    failInput("the visibility method " + method.name + " knows no late fragments", "--composite-late",
              "leave it out, or draw with --visibility " + methodsWith(&VisibilityMethod::dropsLateFragments));
}

/// Cells that show nothing are left out, where the mode does not look at them.
void planPart(RenderPlan& result, const Scene& scene, const Mode& shown, const SceneFacts& facts) {
  result.shows.volume = shown.seesVolume;
  result.leavesOutCells = shown.seesVolume ? facts.clearCells && !shown.seesClearCells : facts.cellsWithoutSurface;
  if (!result.leavesOutCells) return;
  std::string reason = shown.seesVolume ? "the transfer function is clear at every scalar of the others" : "";
  if (!scene.isosurfaces.empty())
    reason += (reason.empty() ? "" : ", and ") + std::string("no isosurface crosses them");
  addItem(result, PlanKind::precomputation, "the cells that show anything", "visible", reason);
}

/// What brings a pixel's fragments into order.
void planOrder(RenderPlan& result, const Scene& scene, const Capabilities& capabilities) {
  result.visibility = visibilityMethod(scene.visibility);
  if (!result.native) result.ordering = orderingOf(result.visibility, capabilities);
  result.earlyTermination = scene.earlyTermination;
  result.compositeLate = scene.compositeLate;
  if (!result.visibility.needsOrder) return;
  result.sort = scene.sort;
  addItem(result, PlanKind::pass, "order of the faces, " + scene.sort, "order",
          "the visibility method " + result.visibility.name + " takes them near first");
}

Lookup measureOf(const Mode& shown, const SceneFacts& facts) {
  if (!shown.measureOfFewPieces.shader.empty() && facts.fewPieces > 0) {
    Lookup measure = shown.measureOfFewPieces;
    measure.number = facts.fewPieces;
    return measure;
  }
  Lookup measure = shown.measure;
  if (!shown.measureOfFewKnots.empty() && fewKnots(facts.knotsInCells)) measure.shader = shown.measureOfFewKnots;
  return measure;
}

}  // namespace

std::string methodsWith(bool VisibilityMethod::*property) {
  std::string names;
  for (const VisibilityMethod& method : visibilityMethods())
    if (method.*property) names += (names.empty() ? "" : " or ") + method.name;
  return names;
}

void checkRange(double value, double least, double most, const std::string& name) {
  if (!(value >= least && value <= most)) {
    failInput(fmt::format("{} is {}", name, value), "", fmt::format("it must lie between {} and {}", least, most));
  }
}

bool fewKnots(double knotsInCells) { return knotsInCells <= kFewKnots; }

std::string lookupFor(double knotsInCells) { return fewKnots(knotsInCells) ? "exact" : "3d-normalised"; }

Lookup lookupOf(const Scene& scene) {
  const Lookup named = lookup(scene.lookup == kAutoLookup ? lookupFor(0) : scene.lookup);
  const Mode& shown = mode(scene.mode);
  return shown.gathering == Gathering::composite && !usesLookup(shown) ? shown.measure : named;
}

int tableSizeOf(const Scene& scene) {
  const LookupResource* table = tableOf(lookupOf(scene));
  return table == nullptr ? 0 : scene.tableSize.value_or(table->ownSize);
}

int entriesPerTarget(Payload carries) { return carries == Payload::scalar ? 2 : 1; }

int largestK(const Scene& scene, const Capabilities& capabilities) {
  const int perTarget = entriesPerTarget(payloadOf(scene));
  const int mostTargets = (visibilityMethod(scene.visibility).maximumK + 1) / 2;  // at two entries each
  return perTarget * std::min(mostTargets, capabilities.maximumDrawBuffers - 1);
}

void chooseTile(RenderPlan& plan, const Scene& scene, const Capabilities& capabilities, std::size_t mostPixels) {
  plan.tileWidth = std::min(scene.width, capabilities.maximumTextureSize);
  plan.tileHeight = std::min(scene.height, capabilities.maximumTextureSize);
  const double most = std::min(kMostTileBytes / plan.bytesPerPixel, static_cast<double>(mostPixels));
  while (static_cast<double>(plan.tileWidth) * plan.tileHeight > most) {
    int& longer = plan.tileWidth >= plan.tileHeight ? plan.tileWidth : plan.tileHeight;
    longer = (longer + 1) / 2;
  }
}

void checkScene(const Scene& scene) {
  const VisibilityMethod& method = visibilityMethod(scene.visibility);
  const Lookup row = lookupOf(scene);
  refuseWhatTheModeLacks(scene, mode(scene.mode));
  refuseWhatTheMethodLacks(scene, method, row);
  for (const Effect& effect : effects())
    if (effect.wanted(scene)) effect.check(scene);
  if (method.maximumK > 0 && !scene.kAuto) checkRange(scene.k, 1, largestK(scene, {}), "k");
  checkLights(scene);
  sortMethod(scene.sort);
  targetFormat(scene.targetFormat);
  if (const LookupResource* table = tableOf(row)) {
    tableFormat(scene.tableFormat);
    checkRange(tableSizeOf(scene), kSmallestTable, table->largestSize, "the table's size");
  }
  checkRange(scene.width, 1, kLargestSide, "the picture's width");
  checkRange(scene.height, 1, kLargestSide, "the picture's height");
  if (static_cast<double>(scene.width) * scene.height > kMostPixels)
    failInput("a picture of " + std::to_string(scene.width) + " x " + std::to_string(scene.height) + " is too large",
              "", "2^30 pixels are the most");
  checkRange(scene.earlyTermination, 0, 1, "the opacity of early termination");
  checkRange(scene.repeat, 1, 1000000, "repeat");
  if (scene.unitLength && !(*scene.unitLength > 0 && std::isfinite(*scene.unitLength)))
    failInput("the unit length must be greater than 0", "", "give it in mesh units");
  const auto& domain = scene.domain;
  if (domain && !((*domain)[0] < (*domain)[1] && std::isfinite((*domain)[0]) && std::isfinite((*domain)[1])))
    failInput("the domain must be two finite numbers, the smaller first", "", "for example 0,1");
}

void addItem(RenderPlan& plan, PlanKind kind, const std::string& name, const std::string& stage,
             const std::string& reason, std::size_t bytesEach, const std::string& of, std::size_t count) {
  plan.items.push_back({kind, name, reason, stage, count * bytesEach, bytesEach, of});
}

void addResource(RenderPlan& plan, const std::string& name, const std::string& reason, const Scene& scene,
                 const Capabilities& capabilities) {
  const LookupResource& resource = lookupResource(name);
  for (const LookupResource& other : plan.resources)
    if (other.name == name) return;
  plan.resources.push_back(resource);
  if (resource.axes == 0) return addItem(plan, PlanKind::table, resource.description, "table", reason);
  plan.tableFormat = tableFormat(scene.tableFormat);
  plan.tableSize = tableSizeOf(scene);
  if (plan.tableFormat.filteredInShader) plan.defines.push_back({"HAVS_FILTER_IN_SHADER", "1"});
  addItem(plan, PlanKind::table, resource.description, "table", reason, plan.tableFormat.bytesPerEntry, "entry",
          resource.entries(static_cast<std::size_t>(plan.tableSize)));
  const int most = resource.axes == 3 ? capabilities.maximum3dTextureSize : capabilities.maximumTextureSize;
  if (plan.tableSize > most)
    failRunning("a table of " + std::to_string(plan.tableSize) + "^" + std::to_string(resource.axes) +
                    " is larger than this OpenGL's textures (" + std::to_string(most) + ")",
                "", "choose a smaller one");
}

void addProgram(RenderPlan& plan, const std::string& role, const std::string& vertex, const std::string& fragment,
                const std::string& reason, const ShaderOptions& options) {
  plan.programs.push_back({role, vertex, fragment, options});
  std::string name = vertex.empty() ? fragment : vertex + " + " + fragment;
  for (const auto& [define, value] : options.defines) name += " " + define + (value.empty() ? "" : "=" + value);
  addItem(plan, PlanKind::program, name, "", reason);
}

const PlannedProgram& programOf(const RenderPlan& plan, const std::string& role) {
  for (const PlannedProgram& program : plan.programs)
    if (program.role == role) return program;
  failRunning("the plan has no program '" + role + "'");
}

RenderPlan plan(const Scene& asked, const SceneFacts& facts, const Capabilities& capabilities) {
  checkScene(asked);
  Scene scene = asked;
  const Payload carries = payloadOf(scene);
  if (scene.lookup == kAutoLookup)
    scene.lookup = carries == Payload::lit ? kLookupOfLit : lookupFor(facts.knotsInCells);
  const Mode& shown = mode(scene.mode);
  RenderPlan result;
  result.mode = shown.name;
  result.gathering = shown.gathering;
  result.start = shown.start;
  result.finish = shown.finish;
  result.native = capabilities.native;
  if (result.native) result.instructionSet = instructionSet(scene.instructionSet).name;
  result.cellData = facts.cellData;
  result.opaqueSurfaces = facts.opaqueSurfaces && shown.seesOpaqueSurfaces;
  result.certificate = scene.certificate;
  planPart(result, scene, shown, facts);
  if (shown.gathering == Gathering::composite) {
    planOrder(result, scene, capabilities);
    result.lookup = lookupOf(scene);
    result.lookup.carries = carries;
    result.light = lightPlanOf(scene);
  } else {
    result.lookup = measureOf(shown, facts);
  }
  result.way = wayOf(shown, result.visibility, capabilities);
  planLookup(result, scene, facts, capabilities);
  for (const Effect& effect : effects())
    if (effect.wanted(scene)) effect.plan(result, scene, facts, capabilities);
  result.way.plan(result, scene, facts, capabilities);
  return result;
}

}  // namespace havs
