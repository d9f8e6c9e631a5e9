#pragma once
// The table of visibility methods: how the fragments of a pixel are brought into order (docs/06-add-a-method.md).
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/stage_times.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs {

struct Capabilities;
struct RenderPlan;

/// How a visibility method draws on one kind of device.
struct DrawingWay {
  /// Its part of the plan: passes, programs, vertex data, targets, tiles. A pure function. Throws Error like plan().
  void (*plan)(RenderPlan& plan, const Scene& scene, const SceneFacts& facts,
               const Capabilities& capabilities) = nullptr;
  /// `prepared` and the current device must outlive the renderer. Stages timed: table, upload_mesh.
  std::unique_ptr<Renderer> (*make)(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                    const Progress& progress) = nullptr;
};

/// One row of the table (`--visibility`).
struct VisibilityMethod {
  std::string name;
  std::string description;
  std::vector<std::string> extensions;  ///< any one of them is needed; empty: none
  bool needsOrder = true;               ///< faces are sorted before they are drawn (`--sort`)
  int maximumK = 0;                     ///< largest k; 0: the method knows no k
  bool endsPixelsEarly = true;          ///< knows early termination (`--early-termination`)
  bool dropsLateFragments = false;      ///< knows late fragments, and may composite them (`--composite-late`)
  bool carriesColors = false;           ///< fragments may carry colours (Payload::color)
  bool carriesLight = false;            ///< fragments may carry light (Payload::lit)
  bool takesLayers = false;             ///< composites layers between segments (RenderPlan::layers)
  DrawingWay gl;                        ///< on OpenGL
  DrawingWay native;                    ///< on the native device; make is null where it does not draw that way
};
std::span<const VisibilityMethod> visibilityMethods();
/// Throws Error{input}, naming the nearest.
const VisibilityMethod& visibilityMethod(const std::string& name);

}  // namespace havs
