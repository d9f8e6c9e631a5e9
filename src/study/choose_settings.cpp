// The candidates are gone through from the cheapest; those whose lookup or k alone errs too much are left out without
// being drawn.
#include "study/choose_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.h"
#include "core/find_row.h"
#include "core/parallel.h"
#include "gl/device.h"
#include "render/make_renderer.h"
#include "study/axes.h"
#include "study/truth.h"

namespace havs {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Scene probeOf(const Scene& scene) {
  Scene probe = scene;
  axis("size").apply(probe, std::to_string(std::min(kProbeSide, std::max(scene.width, scene.height))));
  probe.repeat = 1;
  probe.certificate = false;
  return probe;
}

/// Errors of settings on the probe, each drawn once.
class Probe {
 public:
  Probe(const Scene& scene, const PreparedScene& prepared, const ErrorGoal& goal)
      : prepared_(prepared),
        measure_(errorMeasure(goal.measure)),
        size_(probeOf(scene)),
        view_(viewOf(size_, prepared)),
        device_(makeDevice(scene.device, scene.threads)),
        truths_("", prepared, "") {}

  /// Infinite for what this machine cannot draw.
  double errorOf(Scene scene) {
    scene.width = size_.width;
    scene.height = size_.height;
    const auto [found, isNew] = errors_.try_emplace(settingsKey(scene), kInfinite);
    if (isNew) found->second = draw(scene);
    return found->second;
  }

  int width() const { return size_.width; }
  int height() const { return size_.height; }
  std::size_t drawn() const { return errors_.size(); }

 private:
  double draw(const Scene& scene) {
    const Truth& truth = truths_.of(size_);
    StageTimes stages;
    try {
      const RenderPlan chosen = plan(scene, prepared_.facts(), capabilitiesOf(*device_));
      const Image image = makeRenderer(prepared_, chosen, stages)->draw(view_, stages).image;
      return compareImages(image, truth.image, truth.mask).rgba.*measure_.value;
    } catch (const Error&) {
      return kInfinite;
    }
  }

  const PreparedScene& prepared_;
  const ErrorMeasure& measure_;
  Scene size_;
  View view_;
  std::unique_ptr<Device> device_;
  Truths truths_;
  std::map<std::string, double> errors_;
};

/// The same lookup and table with the largest k that goes with it.
const Scene& withLargestK(const std::vector<Candidate>& all, const Scene& scene) {
  const Scene* largest = &scene;
  for (const Candidate& one : all)
    if (one.scene.lookup == scene.lookup && one.scene.tableSize == scene.tableSize && one.scene.k > largest->k)
      largest = &one.scene;
  return *largest;
}

Scene withExactLookup(Scene scene) {
  scene.lookup = "exact";
  return scene;
}

/// The greatest of the candidate's errors; stops, with what it has, where that exceeds `enough`.
double estimate(Probe& probe, const std::vector<Candidate>& all, const Scene& scene, double enough) {
  double worst = probe.errorOf(withExactLookup(scene));
  if (worst <= enough) worst = std::max(worst, probe.errorOf(withLargestK(all, scene)));
  if (worst <= enough) worst = std::max(worst, probe.errorOf(scene));
  return worst;
}

[[noreturn]] void failUnreached(const ErrorGoal& goal, double best, const Scene& scene) {
  failRunning(fmt::format("no settings keep the error ({}) below {:g} by the probe: the best reached {:.2g}, with {}; "
                          "half of what is asked must be reached there",
                          goal.measure, goal.most, best, settingsLabel(scene)),
              "--max-error", fmt::format("ask for {:.2g}, or draw with havs reference", best / kErrorMargin * 1.01));
}

}  // namespace

std::span<const ErrorMeasure> errorMeasures() {
  static const std::vector<ErrorMeasure> rows{
      {"p999", "99.9% of the pixels are nearer, each by its worst channel", &ErrorMeasures::p999},
      {"rmse", "root of the mean square", &ErrorMeasures::rmse},
  };
  return rows;
}

const ErrorMeasure& errorMeasure(const std::string& name) {
  return findRow(errorMeasures(), name, "error measure", "--error-measure");
}

void checkGoal(const ErrorGoal& goal) {
  errorMeasure(goal.measure);
  if (!(goal.most > 0 && std::isfinite(goal.most)))
    failInput("the error must be greater than 0", "--max-error", "colours go from 0 to 1: 0.01, for example");
}

ChosenSettings chooseSettings(const Scene& scene, const PreparedScene& prepared, const ErrorGoal& goal,
                              const Progress& progress) {
  checkGoal(goal);
  const auto start = std::chrono::steady_clock::now();
  const ThreadLimit limit(scene.threads);
  const std::vector<Candidate> all = candidatesFor(scene, countFragments(scene, prepared));
  if (all.empty()) failInput("no settings go with the others that are asked for", "--max-error");
  Probe probe(scene, prepared, goal);
  const Candidate* chosen = nullptr;
  const Candidate* best = nullptr;
  double chosenEstimate = kInfinite, leastError = kInfinite;
  for (const Candidate& one : all) {
    if (progress) progress("probing", static_cast<double>(&one - all.data()) / static_cast<double>(all.size()));
    const double error = estimate(probe, all, one.scene, kErrorMargin * goal.most);
    if (best == nullptr || error < leastError) best = &one;
    leastError = std::min(leastError, error);
    if (error > kErrorMargin * goal.most) continue;
    chosen = &one;
    chosenEstimate = error;
    break;
  }
  if (progress) progress("probing", 1.0);
  if (chosen == nullptr) failUnreached(goal, leastError, best->scene);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {chosen->scene, chosenEstimate, probe.width(), probe.height(), all.size(), probe.drawn(), 1e3 * seconds};
}

double trueError(const Scene& scene, const PreparedScene& prepared, const Image& image, const ErrorGoal& goal) {
  const ThreadLimit limit(scene.threads);
  Truths truths("", prepared, "");
  const Truth& truth = truths.of(scene);
  return compareImages(image, truth.image, truth.mask).rgba.*errorMeasure(goal.measure).value;
}

}  // namespace havs
