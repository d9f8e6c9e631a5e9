#pragma once
// The cheapest settings whose error stays below a bound (`--max-error`).
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "image/compare.h"
#include "image/image.h"
#include "scene/prepared_scene.h"

namespace havs {

/// What an error is measured by (`--error-measure`): one row of a table.
struct ErrorMeasure {
  std::string name;
  std::string description;
  double ErrorMeasures::*value = nullptr;
};
std::span<const ErrorMeasure> errorMeasures();
/// Throws Error{input}, naming the nearest.
const ErrorMeasure& errorMeasure(const std::string& name);

/// The error must stay below `most`, over RGBA, against the reference, outside the edge mask.
struct ErrorGoal {
  double most = 0;
  std::string measure = "p999";
};
/// Throws Error{input} unless `most` is greater than 0 and finite and the measure is known.
void checkGoal(const ErrorGoal& goal);

/// What the probe's error must stay below, as a part of the goal: the probe has fewer pixels than the picture.
constexpr double kErrorMargin = 0.5;
/// Pixels along the probe's longer side, at most the picture's.
constexpr int kProbeSide = 160;

/// Settings and what a picture with them should cost.
struct Candidate {
  Scene scene;
  double cost = 0;  ///< milliseconds by the model, of the table and Scene::repeat frames
};

/// What the cost of a picture depends on besides its settings.
struct SceneWork {
  double fragments = 0;     ///< countFragments
  double knotsInCells = 0;  ///< meanKnotsInCells (scene/knots_in_cells.h)
};

/// What may be chosen, cheapest first: every lookup, k, sizes of the table; all else as in the scene. Without those
/// that cost more than the lookup `exact` with the same k. The cost is a model, so that the choice is the same on every
/// run: nanoseconds of each lookup a fragment and a table's entry, measured on llvmpipe, and on the native device for
/// that.
std::vector<Candidate> candidatesFor(const Scene& scene, const SceneWork& work);

/// How many fragments the faces of the cells that show anything have in a picture of the scene, from their projected
/// areas (an estimate: faces that reach behind the eye or beyond the border count whole or not at all).
double countFragments(const Scene& scene, const PreparedScene& whole);

/// What was chosen, and why.
struct ChosenSettings {
  Scene scene;          ///< as asked for, with the settings chosen
  double estimate = 0;  ///< of its error, on the probe
  int probeWidth = 0, probeHeight = 0;
  std::size_t candidates = 0, probes = 0;  ///< that there were, and pictures drawn to choose among them
  double probeMs = 0;                      ///< wall time of choosing, the probe's reference included
};

/// Chooses among the candidates by probes, which it keeps from one choice to the next. Holds a device while it lives.
class SettingsChooser {
 public:
  /// `prepared` must outlive it. `measure`: a row of errorMeasures(). Throws Error as checkGoal, prepareScene,
  /// openRenderDevice.
  SettingsChooser(const Scene& scene, const PreparedScene& prepared, const std::string& measure);
  ~SettingsChooser();
  SettingsChooser(const SettingsChooser&) = delete;
  SettingsChooser& operator=(const SettingsChooser&) = delete;

  /// The cheapest candidate whose estimate is at most kErrorMargin * most. An estimate is the greatest of three errors
  /// against the reference, on a probe picture of the same camera: of the candidate; of its lookup and table with the
  /// largest k; of its k with the lookup `exact`. It does not depend on `most`, so a smaller bound never chooses
  /// cheaper settings. Throws Error{running} when no candidate reaches it (says the best).
  ChosenSettings choose(double most, const Progress& progress = {});

 private:
  class Probe;
  [[noreturn]] void failUnreached(double most);

  std::string measure_;
  std::vector<Candidate> candidates_;
  std::unique_ptr<Probe> probe_;
};

/// One choice. Throws as SettingsChooser.
ChosenSettings chooseSettings(const Scene& scene, const PreparedScene& prepared, const ErrorGoal& goal,
                              const Progress& progress = {});

/// The error of a picture of the scene against the reference at its full size.
double trueError(const Scene& scene, const PreparedScene& prepared, const Image& image, const ErrorGoal& goal);

}  // namespace havs
