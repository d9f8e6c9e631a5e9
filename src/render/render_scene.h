#pragma once
#include <optional>
#include <span>
#include <string>

#include "core/progress.h"
#include "core/stage_times.h"
#include "image/image.h"
#include "mesh/defects.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"
#include "scene/scene.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// A picture and all that a report says of how it was made.
struct RenderReport {
  Image image;
  std::size_t points = 0, cells = 0, faces = 0, boundaryFaces = 0;  ///< of the mesh drawn
  std::size_t drawnCells = 0;      ///< those that show anything (scene/visible_part.h); the reference: all
  std::vector<Defect> defects;     ///< of the mesh as read
  std::vector<std::string> notes;  ///< what reading and repair did, one sentence each
  std::string field;
  std::string centering;  ///< "point" or "cell"
  std::array<double, 2> fieldRange{0, 0};
  std::string transferFunction;
  OpacityMeaning meaning = OpacityMeaning::perUnit;
  double unitLength = 0;
  std::array<double, 2> domain{0, 1};
  std::vector<ShownIsosurface> isosurfaces;  ///< ascending
  std::string camera;                        ///< JSON object, all parts set
  std::string renderer, glVersion;
  std::string ordering;           ///< how pixels are kept in order ("GL_EXT_shader_framebuffer_fetch")
  std::size_t bytesPerPixel = 0;  ///< of the render targets
  std::size_t targetBytes = 0;    ///< all targets together
  std::size_t tiles = 1;
  std::string lookup;             ///< used: the scene's, what `auto` stood for, or the mode's own
  int tableSize = 0;              ///< of its table; 0: it has none
  int k = 0;                      ///< used: the scene's, or the one that the search chose
  std::size_t fragments = 0;      ///< of the picture, where the method keeps them all (a-buffer)
  std::size_t fragmentBytes = 0;  ///< of memory that these took at once
  std::optional<Certificate> certificate;
  std::size_t cycles = 0;      ///< cut by the topological order
  StageTimes stages;           ///< read, faces, order, upload, table, draw, flush, readback, total;
                               ///< k_search where k is searched for, visible (what shows), eye_cut
  double cpuMilliseconds = 0;  ///< of the whole call, all threads
  std::vector<PlanItem> plan;  ///< what was run for it
  bool reference = false;      ///< drawn by drawReference: what is said of OpenGL, the plan and orders is unset
  std::vector<unsigned char> edgeMask;  ///< boundaryEdgeMask (reference/edge_mask.h), where it was asked for
};

/// Reads, prepares and draws a scene, Scene::repeat times (medians of each stage; the picture is the last). Throws
/// Error{input} (anything wrong with the scene, its files), Error{running} (no context, ...).
RenderReport renderScene(const Scene& scene, const Progress& progress = {});

/// The same of a scene that prepareScene has made ready. `before`: what that took, for the report, its total too; its
/// processor time is of the drawing only.
RenderReport renderScene(const Scene& scene, const PreparedScene& prepared, const StageTimes& before,
                         const Progress& progress = {});

/// Several pictures of one scene, whose `scenes` differ by the camera alone: the mesh is read and made ready once, and
/// one renderer draws them all, but where k is searched. At least one; a report for each, the first with the stages of
/// what they share. Throws as renderScene.
std::vector<RenderReport> renderScenes(std::span<const Scene> scenes, const Progress& progress = {});

/// The plan that renderScene draws by, of the first k that is asked for where one is searched. Reads the mesh and opens
/// the device; draws nothing. Throws as renderScene.
RenderPlan planScene(const Scene& scene, const Progress& progress = {});

/// The same by the ground truth (reference/reference_renderer.h), without OpenGL: of the method, only Scene::threads
/// and repeat have an effect. `edgeMask`: fills RenderReport::edgeMask. Throws as renderScene.
RenderReport drawReference(const Scene& scene, bool edgeMask = false, const Progress& progress = {});
/// Of several, as renderScenes.
std::vector<RenderReport> drawReferences(std::span<const Scene> scenes, bool edgeMask = false,
                                         const Progress& progress = {});

}  // namespace havs
