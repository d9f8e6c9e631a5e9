#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/camera.h"
#include "scene/clipping.h"
#include "scene/isosurface.h"
#include "scene/lighting.h"
#include "scene/overlays.h"

namespace havs {

/// The lookup that suits the transfer function (lookupFor in render/plan.h).
inline constexpr const char* kAutoLookup = "auto";

/// What is asked for. Names refer to the tables: renderDevices() (render/devices.h), modes() (render/modes.h),
/// visibilityMethods() (render/visibility.h), lookups() and tableFormats() (render/lookups.h), targetFormats()
/// (render/target_formats.h), instructionSets() (render/native/instruction_sets.h), sortMethods() (sort/face_order.h),
/// transferPresets() (transfer/transfer_function.h).
struct Scene {
  std::filesystem::path mesh;
  std::filesystem::path plot3dSolution;
  std::string tetgenSwitches = "pq";
  std::string field;                            ///< empty: the default field
  std::string transferFunction = "viridis";     ///< preset or file
  std::optional<double> unitLength;             ///< mesh units; overrides the transfer function's
  std::optional<std::array<double, 2>> domain;  ///< in the data's unit; overrides the transfer function's
  std::vector<Isosurface> isosurfaces;          ///< with the volume, or alone (mode `isosurfaces`)
  Overlays overlays;                            ///< the mesh's outline, boundary surface, wire frame
  std::vector<ClipPlane> clipPlanes;            ///< what is in all of these and of the boxes is drawn
  std::vector<ClipBox> clipBoxes;
  std::optional<std::array<double, 2>> threshold;  ///< in the data's unit, both included: other cells are holes
  int width = 1024;
  int height = 1024;
  Camera camera;
  std::string mode = "volume";                  ///< what a pixel shows: row of modes() (render/modes.h)
  std::optional<Lighting> lighting;             ///< by the gradient; empty: colours as they are
  std::vector<SceneLight> lights;               ///< kMostLights at most; none: a head light where light is needed
  bool shadows = false;                         ///< lights are dimmed by what they go through; implies lighting
  std::optional<AmbientOcclusion> occlusion;    ///< dims the ambient light; implies lighting
  std::optional<AmbientScattering> scattering;  ///< adds light that is scattered on the way
  double modulation = 0;  ///< 0 to 1: extinction times 1 - modulation + modulation * |gradient| / its largest
  std::string device = "osmesa";
  std::string instructionSet;  ///< of the native device; empty: the widest that the processor has
  std::string visibility = "kbuffer";
  std::string sort = "topological";
  int k = 6;
  bool kAuto = false;  ///< the smallest k without a misordered fragment instead of `k` (render/k_search.h)
  std::string lookup = "3d-normalised";  ///< or kAutoLookup
  std::optional<int> tableSize;          ///< of the lookup's table; empty: its own (tableSizeOf in render/plan.h)
  std::string tableFormat = "rgba32f";   ///< or rgba8
  std::string targetFormat = "32f";      ///< numbers of the k-buffer's render targets; or 16f
  double earlyTermination = 0;           ///< opacity at which a pixel is done; 0: never
  bool certificate = false;              ///< count misordered fragments (design: the order certificate)
  bool compositeLate = false;            ///< late fragments are composited (the paper) instead of dropped
  std::optional<Background> background = Background{};  ///< none: transparent
  std::size_t threads = 0;                              ///< 0: all cores
  int repeat = 1;
};

/// What is known of the data when a plan is made.
struct SceneFacts {
  bool cellData = false;             ///< the scalar belongs to the cells
  bool opaqueSurfaces = false;       ///< the transfer function reaches opacity 1 (per_unit)
  double knotsInCells = 0;           ///< meanKnotsInCells (scene/knots_in_cells.h)
  int fewPieces = 0;                 ///< of the transfer function: countFewPieces (transfer/few_pieces.h)
  bool clearCells = false;           ///< some cells show nothing: volume nor isosurface (scene/visible_part.h)
  bool cellsWithoutSurface = false;  ///< some cells show no isosurface
  std::size_t points = 0, cells = 0, faces = 0;  ///< of the mesh
};

/// The paper's own choices (`--paper`): centroid, k 6, `3d` with an RGBA8 128^3 table, termination at 0.99, late
/// fragments composited.
void applyPaperPreset(Scene& scene);

}  // namespace havs
