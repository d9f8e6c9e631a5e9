// What --max-error chooses among, and the model of its cost.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "render/devices.h"
#include "render/lookups.h"
#include "render/plan.h"
#include "render/visibility.h"
#include "scene/visible_part.h"
#include "study/axes.h"
#include "study/choose_settings.h"

namespace havs {
namespace {

struct LookupCost {
  const char* name;
  double fixed = 0, perSample = 0, perKnot = 0;  ///< knots: SceneFacts::knotsInCells
};
/// Nanoseconds a fragment and an entry of a table; only ratios matter.
struct CostModel {
  double fragment, entryOfK, tableEntry;
  std::array<LookupCost, 9> lookups;
};

/// llvmpipe with two threads, spx at 512 x 512 (a study).
constexpr CostModel kOpenGl{25,
                            1.5,
                            400,
                            {{{"2d", 0},
                              {"3d", 4},
                              {"post", 6},
                              {"integral", 12},
                              {"pre", 13},
                              {"3d-normalised", 15},
                              {"riemann", 0, 8.5},
                              {"riemann-linear", 0, 8.5},
                              {"exact", 165}}}};
/// The native device with AVX-512: bench_segments, bench_prepare and the frames of docs/07-performance.md. k costs
/// nothing where the order is right.
constexpr CostModel kNative{8.6,
                            0,
                            45,
                            {{{"2d", 3.6},
                              {"3d", 6.5},
                              {"post", 6.6},
                              {"integral", 10.7},
                              {"pre", 10.5},
                              {"3d-normalised", 9.7},
                              {"riemann", 0, 3.9},
                              {"riemann-linear", 0, 3.9},
                              {"exact", 7, 0, 0.5}}}};
constexpr std::array kAllK{2, 4, 8, 14};
constexpr std::array kSamples{4, 16};

/// A lookup that is not listed counts as the dearest.
double lookupCost(const CostModel& model, const Lookup& row, double knotsInCells) {
  const std::string plain = row.name.substr(0, row.name.find(':'));
  const auto listed = std::find_if(model.lookups.begin(), model.lookups.end() - 1,
                                   [&](const LookupCost& cost) { return plain == cost.name; });
  return listed->fixed + listed->perSample * row.number + listed->perKnot * knotsInCells;
}

double costOf(const Scene& scene, const SceneWork& work) {
  constexpr double kMilliseconds = 1e-6;
  const CostModel& model = scene.device == kNativeDevice ? kNative : kOpenGl;
  const Lookup row = lookup(scene.lookup);
  const LookupResource* table = tableOf(row);
  const double entries = table != nullptr ? std::pow(tableSizeOf(scene), table->axes) : 0;
  const int k = visibilityMethod(scene.visibility).maximumK > 0 ? scene.k : 0;
  const double frame =
      work.fragments * (model.fragment + model.entryOfK * k + lookupCost(model, row, work.knotsInCells));
  return kMilliseconds * (model.tableEntry * entries + scene.repeat * frame);
}

std::vector<std::string> lookupChoices() {
  std::vector<std::string> names;
  for (const Lookup& row : lookups()) {
    const std::string example = exampleName(row);
    if (row.parameter.empty()) names.push_back(example);
    for (const int samples : kSamples)
      if (!row.parameter.empty()) names.push_back(example.substr(0, example.find(':') + 1) + std::to_string(samples));
  }
  return names;
}

/// Two axes are filled in no time, so they may be longer.
std::vector<std::optional<int>> tableSizes(const Lookup& row, std::optional<int> given) {
  const LookupResource* table = tableOf(row);
  if (table == nullptr) return {given};
  if (table->axes == 2) return {64, 128, 256, 512};
  return {16, 32, 64, 128};
}

bool isAllowed(const Scene& scene) {
  try {
    checkScene(scene);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// All with this k, those dearer than `exact` left out.
void addCandidates(std::vector<Candidate>& all, Scene scene, const SceneWork& work) {
  scene.lookup = "exact";
  const double most = costOf(scene, work);
  const std::optional<int> given = scene.tableSize;
  for (const std::string& name : lookupChoices()) {
    scene.lookup = name;
    for (const std::optional<int> size : tableSizes(lookup(name), given)) {
      scene.tableSize = size;
      const double cost = costOf(scene, work);
      if (isAllowed(scene) && (cost < most || name == "exact")) all.push_back({scene, cost});
    }
    scene.tableSize = given;
  }
}

}  // namespace

std::vector<Candidate> candidatesFor(const Scene& scene, const SceneWork& work) {
  std::vector<Candidate> all;
  Scene one = scene;
  one.kAuto = false;
  if (visibilityMethod(scene.visibility).maximumK == 0) addCandidates(all, one, work);
  for (const int k : kAllK) {
    one.k = k;
    if (visibilityMethod(scene.visibility).maximumK > 0) addCandidates(all, one, work);
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return all;
}

double countFragments(const Scene& scene, const PreparedScene& whole) {
  const View view = viewOf(scene, whole);
  const std::optional<PreparedScene> part = visiblePart(whole);
  const PreparedScene& prepared = part ? *part : whole;
  std::vector<double> areas(prepared.faces.size(), 0);
  parallelFor(0, areas.size(), 4096, [&](std::size_t f) {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& point = prepared.points[prepared.faces.vertices[f][i]];
      if (!view.orthographic && dot(view.forward, point - view.eye) <= 0) return;
      p[i] = view.project(point);
      if (p[i].x < 0 || p[i].y < 0 || p[i].x > view.width || p[i].y > view.height) return;
    }
    areas[f] = 0.5 * std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
  });
  double sum = 0;
  for (const double area : areas) sum += area;
  return sum;
}

}  // namespace havs
