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
#include "render/devices.h"
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

/// Errors of settings on the probe, each drawn once.
class SettingsChooser::Probe {
 public:
  Probe(const Scene& scene, const PreparedScene& prepared, const std::string& measure)
      : prepared_(prepared),
        measure_(errorMeasure(measure)),
        size_(probeOf(scene)),
        view_(viewOf(size_, prepared)),
        device_(openRenderDevice(scene.device, scene.threads)),
        truths_("", prepared, "") {}

  /// Infinite for what this machine cannot draw.
  double errorOf(Scene scene) {
    scene.width = size_.width;
    scene.height = size_.height;
    const auto [found, isNew] = errors_.try_emplace(settingsKey(scene), kInfinite);
    if (isNew) found->second = draw(scene);
    return found->second;
  }

  /// The greatest of the candidate's errors; stops, with what it has, where that exceeds `enough`.
  double estimate(const std::vector<Candidate>& all, const Scene& scene, double enough) {
    double worst = errorOf(withExactLookup(scene));
    if (worst <= enough) worst = std::max(worst, errorOf(withLargestK(all, scene)));
    if (worst <= enough) worst = std::max(worst, errorOf(scene));
    return worst;
  }

  int width() const { return size_.width; }
  int height() const { return size_.height; }
  std::size_t drawn() const { return errors_.size(); }

 private:
  double draw(const Scene& scene) {
    const Truth& truth = truths_.of(size_);
    StageTimes stages;
    try {
      const RenderPlan chosen = plan(scene, prepared_.facts(), device_.capabilities);
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
  RenderDevice device_;
  Truths truths_;
  std::map<std::string, double> errors_;
};

SettingsChooser::SettingsChooser(const Scene& scene, const PreparedScene& prepared, const std::string& measure)
    : measure_(measure),
      candidates_(candidatesFor(scene, {countFragments(scene, prepared), prepared.knotsInCells})),
      probe_(std::make_unique<Probe>(scene, prepared, measure)) {
  if (candidates_.empty()) failInput("no lookup goes with the other settings that are asked for", "--max-error");
}

SettingsChooser::~SettingsChooser() = default;

ChosenSettings SettingsChooser::choose(double most, const Progress& progress) {
  checkGoal({most, measure_});
  const auto start = std::chrono::steady_clock::now();
  const ThreadLimit limit(candidates_.front().scene.threads);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (progress) progress("probing", static_cast<double>(i) / static_cast<double>(candidates_.size()));
    const double error = probe_->estimate(candidates_, candidates_[i].scene, kErrorMargin * most);
    if (error > kErrorMargin * most) continue;
    if (progress) progress("probing", 1.0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {candidates_[i].scene, error,           probe_->width(), probe_->height(),
            candidates_.size(),   probe_->drawn(), 1e3 * seconds};
  }
  failUnreached(most);
}

/// The best are those without a table; all of them have been drawn.
void SettingsChooser::failUnreached(double most) {
  double best = kInfinite;
  const Scene* with = &candidates_.back().scene;
  for (const Candidate& one : candidates_) {
    if (one.scene.lookup != "exact") continue;
    const double error = probe_->estimate(candidates_, one.scene, kInfinite);
    if (error < best) with = &one.scene;
    best = std::min(best, error);
  }
  failRunning(fmt::format("no settings keep the error ({}) below {:g}: a probe must reach {:g} of that, and the best "
                          "reached {:.2g}, with {}",
                          measure_, most, kErrorMargin, best, settingsLabel(*with)),
              "--max-error", fmt::format("ask for {:.2g}, or draw with havs reference", 1.1 * best / kErrorMargin));
}

ChosenSettings chooseSettings(const Scene& scene, const PreparedScene& prepared, const ErrorGoal& goal,
                              const Progress& progress) {
  checkGoal(goal);
  return SettingsChooser(scene, prepared, goal.measure).choose(goal.most, progress);
}

double trueError(const Scene& scene, const PreparedScene& prepared, const Image& image, const ErrorGoal& goal) {
  const ThreadLimit limit(scene.threads);
  Truths truths("", prepared, "");
  const Truth& truth = truths.of(scene);
  return compareImages(image, truth.image, truth.mask).rgba.*errorMeasure(goal.measure).value;
}

}  // namespace havs
