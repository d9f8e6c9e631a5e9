#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "render/devices.h"
#include "scene/prepared_scene.h"
#include "study/records.h"
#include "study/renderer_pool.h"
#include "study/truth.h"

namespace havs {

/// One mesh seen by one camera, prepared to be measured with any settings. `prepared` and `device` must outlive it.
class Subject {
 public:
  /// `folder`: of the study; pictures go to images/ in it. `keepBytes`: memory for renderers kept between visits.
  /// Throws Error{input} for a camera that cannot be used.
  /// `preparing`: stages of prepareScene.
  Subject(std::string id, const Scene& baseline, const PreparedScene& prepared, const StageTimes& preparing,
          const RenderDevice& device, std::filesystem::path folder, std::size_t keepBytes);

  const SubjectRecord& record() const { return record_; }

  /// Draws and times the run once, after a drawing that is not timed where its renderer had to be made; on the first
  /// visit of a run (`withQuality`) also measures its error and its certificate and writes its pictures. What the
  /// drawing throws becomes VisitRecord::failed. Throws Error{running} when a picture cannot be written.
  VisitRecord visit(const PlannedRun& run, int round, bool withQuality);

  /// Only draws and times it, as visit does. Throws what the drawing throws.
  FrameTime time(const PlannedRun& run);

  /// The references drawn so far.
  const std::vector<ReferenceRecord>& references() const { return truths_.records(); }

 private:
  struct Made;
  struct Visited;
  Made make(const Scene& scene) const;
  Visited draw(const PlannedRun& run);
  std::optional<std::array<std::size_t, 2>> certificateOf(const Scene& scene);

  const PreparedScene& prepared_;
  StageTimes preparing_;
  const RenderDevice& device_;
  std::filesystem::path folder_;
  SubjectRecord record_;
  Truths truths_;
  RendererPool pool_;
  std::map<std::string, std::optional<std::array<std::size_t, 2>>> certificates_;  ///< by settings
};

/// A part of a file name that stands for a run: what is no letter or digit or one of "=,.-" becomes '_'.
std::string fileNameOf(const std::string& runId);

}  // namespace havs
