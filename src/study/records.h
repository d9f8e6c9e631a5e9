#pragma once
// What a study knows: what is to be drawn, and what was measured of it.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/compare.h"
#include "render/plan_item.h"
#include "scene/scene.h"

namespace havs {

/// Why a run is drawn.
enum class RunKind {
  baseline,  ///< the settings of the command line
  axis,      ///< one axis moved away from the baseline
  paper,     ///< the paper's own choice (applyPaperPreset)
  front,     ///< values that did well on several axes, together
  effect     ///< the baseline with one effect more or less
};
std::string nameOf(RunKind kind);

/// One setting to be measured on one subject (a mesh seen by a camera).
struct PlannedRun {
  std::string id;       ///< "spx-0/k=2", one of its kind in a study
  std::string subject;  ///< "spx-0"
  RunKind kind = RunKind::baseline;
  std::string axis, value;  ///< RunKind::axis only
  Scene scene;
  std::string effect;             ///< RunKind::effect only: row of effects() (render/effects.h)
  bool adds = false;              ///< then: the baseline lacks it; else it is left out of the baseline
  std::vector<std::string> also;  ///< then: other effects that come and go with it
};

/// What does not change from one drawing to the next.
struct Quality {
  ErrorMeasures error;                                    ///< against the reference, outside the edge mask
  ErrorMeasures errorWithMasked;                          ///< over all pixels
  std::optional<std::array<std::size_t, 2>> certificate;  ///< misordered fragments, and pixels that have any
  std::size_t bytesPerPixel = 0;                          ///< of the render targets
  std::vector<PlanItem> plan;                             ///< what was run, built and kept
  std::string image, difference;                          ///< files, relative to the study's folder; may be empty
};

/// Wall milliseconds of stages (StageTimes), in the order in which they ran.
using StageMilliseconds = std::vector<std::pair<std::string, double>>;

/// What a frame took.
struct FrameTime {
  double wallMs = 0, cpuMs = 0;
};

/// One visit of a run: drawn and timed once.
struct VisitRecord {
  std::string run;
  int round = 0;
  double wallMs = 0;                ///< of the frame: all stages but readback
  double cpuMs = 0;                 ///< processor time of the same, all threads
  StageMilliseconds stagesMs;       ///< wall: of the frame; where this visit made the renderer, what that took, too
  std::optional<double> tableMs;    ///< wall, where this visit had to make the table
  std::optional<double> prepareMs;  ///< wall, where this visit made the renderer: all that is done once, from the mesh
                                    ///< as read to the first picture of a view
  std::optional<FrameTime> baseline;  ///< of the baseline, drawn beside it; RunKind::effect only
  std::optional<Quality> quality;     ///< of the first visit
  std::string failed;                 ///< why it could not be drawn; then the rest is not set
};

/// A mesh seen by a camera.
struct SubjectRecord {
  std::string id;
  std::string mesh;     ///< file name
  std::string content;  ///< fingerprint of the prepared mesh, its scalars and the transfer function
  std::size_t points = 0, cells = 0, faces = 0;
  std::string field, transferFunction;
  std::string camera;  ///< JSON object, all parts set
  int width = 0, height = 0;
  std::size_t maskedPixels = 0;
  bool operator==(const SubjectRecord&) const = default;
};

/// The ground truth as drawn for one subject at one size.
struct ReferenceRecord {
  std::string subject;
  int width = 0, height = 0;
  std::string image;
  double wallMs = 0, cpuMs = 0;
};

/// The device that draws.
struct DeviceRecord {
  std::string renderer, version;
};

}  // namespace havs
