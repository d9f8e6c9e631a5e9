#include "scene/prepared_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "core/error.h"
#include "core/memory_budget.h"
#include "core/parallel.h"
#include "mesh/overlaps.h"
#include "mesh/read.h"
#include "mesh/spatial_order.h"
#include "scene/clip_scene.h"
#include "scene/knots_in_cells.h"
#include "scene/visible_part.h"
#include "transfer/few_pieces.h"
#include "transfer/resolution.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

/// Beyond the mesh as read: neighbours, faces, local points, and the order (docs/07-performance.md, Faces, order,
/// tables).
constexpr double kBytesPerTetrahedron = 140;
/// Overlapping cells are looked for in larger meshes by `havs info` only: it takes longer than all else before a
/// picture.
constexpr std::size_t kMostCellsForOverlaps = 20000;

/// Adds up the parts of the two stages, which do not run in one go; each counts as one run in the end.
class StageSums {
 public:
  explicit StageSums(StageTimes& stages) : stages_(stages) {}
  ~StageSums() {
    for (const char* stage : {"prepare", "faces"}) stages_.add(stage, sums_[stage]);
  }
  StageSums(const StageSums&) = delete;
  StageSums& operator=(const StageSums&) = delete;

  /// work(), as a part of the stage.
  template <class Work>
  auto time(const std::string& stage, const Work& work) {
    const Part part{sums_[stage]};
    return work();
  }

 private:
  struct Part {
    double& sum;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Part() { sum += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(); }
  };

  StageTimes& stages_;
  std::map<std::string, double> sums_;
};

void noteRepairs(PreparedScene& prepared) {
  for (const Defect& defect : prepared.defects)
    if (defect.count > 0) prepared.notes.push_back(describe(defect));
}

TransferFunction transferFunctionOf(const Scene& scene) {
  TransferFunction function = loadTransferFunction(scene.transferFunction);
  if (scene.unitLength) function.unitLength = scene.unitLength;
  if (scene.domain) function.domain = scene.domain;
  return function;
}

std::vector<double> normalisedScalars(const ScalarField& field, const ExtinctionCurve& curve) {
  std::vector<double> scalars(field.values.size());
  parallelFor(0, scalars.size(), 4096, [&](std::size_t i) { scalars[i] = curve.normalise(field.values[i]); });
  return scalars;
}

/// The field, its values numbered as the prepared mesh is, and no cell where it is not finite. Whether cells went.
bool prepareField(PreparedScene& prepared, ScalarField field) {
  prepared.field = std::move(field);
  const std::size_t holes = withoutHoles(prepared.mesh, prepared.field);
  if (holes > 0) prepared.notes.push_back(fmt::format("{} cells without a finite scalar are holes", holes));
  return holes > 0;
}

/// `field`, of a mesh that is numbered anew.
ScalarField renumberedField(ScalarField field, const SpatialNumbers& numbers) {
  field.values = renumbered(field.values, field.centering == Centering::cell ? numbers.cells : numbers.points);
  return field;
}

/// The way of most meshes, which need no mending: nothing is looked for that the faces tell anyway, and all is done in
/// numbers that follow space. Leaves `mesh` and returns false where there is something to mend.
bool prepareSound(PreparedScene& prepared, const Scene& scene, TetMesh& mesh, StageSums& stages) {
  std::optional<SpatialNumbers> numbers;
  TetMesh ordered;
  const bool sound = stages.time("prepare", [&] {
    numbers = spatialNumbers(mesh.points, mesh.tetrahedra);
    ordered = renumbered(mesh, *numbers);
    return isSound(ordered);
  });
  if (!sound) return false;
  Faces faces = stages.time("faces", [&] { return buildFaces(ordered); });
  if (!faces.plain) return false;
  const bool holes = stages.time("prepare", [&] {
    prepared.defects = inspectFields(mesh);
    if (ordered.tetrahedra.size() <= kMostCellsForOverlaps)
      enterOverlaps(prepared.defects, overlappingCells(ordered, faces, numbers->cells));
    else
      leaveOutOverlaps(prepared.defects);
    noteRepairs(prepared);
    ScalarField field = renumberedField(selectField(mesh, scene.field), *numbers);
    mesh = {};
    prepared.mesh = std::move(ordered);
    return prepareField(prepared, std::move(field));
  });
  if (holes) faces = stages.time("faces", [&] { return buildFaces(prepared.mesh); });
  prepared.faces = std::move(faces);
  return true;
}

void prepareMended(PreparedScene& prepared, const Scene& scene, TetMesh mesh, StageSums& stages) {
  stages.time("prepare", [&] {
    prepared.defects = inspectMesh(mesh, mesh.tetrahedra.size() <= kMostCellsForOverlaps);
    noteRepairs(prepared);
    mesh = repairMesh(std::move(mesh));
    const SpatialNumbers numbers = spatialNumbers(mesh.points, mesh.tetrahedra);
    prepared.mesh = renumbered(mesh, numbers);
    prepareField(prepared, renumberedField(selectField(mesh, scene.field), numbers));
    mesh = {};
  });
  prepared.faces = stages.time("faces", [&] { return buildFaces(prepared.mesh); });
}

/// Of a function in the data's unit: that float tells apart what it tells apart, but for some steep places.
void refuseWhatFloatBlurs(const PreparedScene& prepared, const TransferFunction& function) {
  const std::vector<double>& values = prepared.field.values;
  const std::size_t blurred = parallelReduce(
      0, values.size(), 4096, std::size_t{0},
      [&](std::size_t first, std::size_t last) {
        return static_cast<std::size_t>(std::count_if(
            values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(last),
            [&](double value) { return std::isfinite(value) && !holdsInFloat(function, prepared.curve, value); }));
      },
      std::plus<>());
  if (100 * blurred <= values.size()) return;
  const auto& [low, high] = prepared.curve.domain;
  failInput(fmt::format("'{}' goes from {:.6g} to {:.6g}: within so wide a domain float does not tell {} of {} values "
                        "apart as the transfer function does",
                        prepared.field.name, low, high, blurred, values.size()),
            "transfer function", "give the part to be seen as --domain, beyond which values are cut off");
}

void prepareCurve(PreparedScene& prepared, const Scene& scene) {
  const TransferFunction function = transferFunctionOf(scene);
  CurveSetting setting;
  setting.fieldRange = {prepared.field.minimum, prepared.field.maximum};
  setting.boundingDiagonal = prepared.frame.diagonal;
  setting.radius = prepared.frame.radius;
  prepared.curve = makeCurve(function, setting);
  if (!function.normalised) refuseWhatFloatBlurs(prepared, function);
  prepared.transferFunction = function.name;
  prepared.meaning = function.meaning;
}

}  // namespace

PreparedScene prepareScene(const Scene& scene, TetMesh mesh, StageTimes& stages) {
  PreparedScene prepared;
  StageSums sums(stages);
  prepared.notes = mesh.notes;
  needMemory(kBytesPerTetrahedron * static_cast<double>(mesh.tetrahedra.size()),
             fmt::format("making {} tetrahedra ready to be drawn", mesh.tetrahedra.size()), scene.mesh.string(),
             "draw a coarser mesh");
  if (!prepareSound(prepared, scene, mesh, sums)) prepareMended(prepared, scene, std::move(mesh), sums);
  sums.time("prepare", [&] {
    prepared.frame = localFrame(prepared.mesh);
    if (!std::isfinite(prepared.frame.diagonal))
      failInput("the mesh is larger than the largest double", "", "give its points in a larger unit");
    prepared.points = localPoints(prepared.mesh, prepared.frame);
    prepared.longestEdge = longestEdge(prepared.mesh, prepared.points);
    prepareCurve(prepared, scene);
    prepared.isosurfaces = prepareIsosurfaces(scene, prepared);
    prepared.scalars = normalisedScalars(prepared.field, prepared.curve);
    prepared.knotsInCells = meanKnotsInCells(prepared);
    prepared.clearCells = hasClearCells(prepared);
    prepared.cellsWithoutSurface = prepared.isosurfaces.empty() || hasClearCells(prepared, {.volume = false});
    // Last, so that all that was found out above is of the whole mesh.
    if (asksForPart(scene)) clip(prepared, scene, prepared.field.values);
    prepared.field.values = {};
  });
  if (asksForPart(scene)) prepared.faces = sums.time("faces", [&] { return buildFaces(prepared.mesh); });
  return prepared;
}

PreparedScene prepareScene(const Scene& scene, StageTimes& stages, const Progress& progress) {
  TetMesh mesh;
  {
    const ScopedStage timer(stages, "read");
    ReadOptions options;
    options.plot3dSolution = scene.plot3dSolution;
    options.tetgenSwitches = scene.tetgenSwitches;
    options.progress = progress;
    mesh = readMesh(scene.mesh, options);
  }
  return prepareScene(scene, std::move(mesh), stages);
}

SceneFacts PreparedScene::facts() const {
  SceneFacts facts;
  facts.cellData = field.centering == Centering::cell;
  facts.opaqueSurfaces = !curve.opaque.empty();
  facts.knotsInCells = knotsInCells;
  facts.fewPieces = countFewPieces(withSurfaceColors(curve));
  facts.clearCells = clearCells;
  facts.cellsWithoutSurface = cellsWithoutSurface;
  facts.points = points.size();
  facts.cells = mesh.tetrahedra.size();
  facts.faces = faces.size();
  return facts;
}

PreparedScene withoutMesh(const PreparedScene& whole) {
  PreparedScene part;
  part.defects = whole.defects;
  part.notes = whole.notes;
  part.field = whole.field;
  part.frame = whole.frame;
  part.longestEdge = whole.longestEdge;
  part.curve = whole.curve;
  part.isosurfaces = whole.isosurfaces;
  part.transferFunction = whole.transferFunction;
  part.meaning = whole.meaning;
  return part;
}

View viewOf(const Scene& scene, const PreparedScene& prepared) {
  return makeView(scene.camera, prepared.frame, scene.width, scene.height);
}

bool reachesMesh(const PreparedScene& prepared, const Vec3& point, double reach) {
  std::atomic<bool> found{false};
  const auto& cells = prepared.mesh.tetrahedra;
  parallelFor(0, cells.size(), 16384, [&](std::size_t c) {
    std::array<Vec3, 4> r;
    for (int i = 0; i < 4; ++i) r[i] = prepared.points[cells[c][i]] - point;
    // Six volumes with the point and each face: its distance from the face, times twice the face's area.
    auto within = [&](int i, int j, int k) {
      const double volume = dot(cross(r[i], r[j]), r[k]);
      return volume >= 0 || (reach > 0 && -volume <= reach * length(cross(r[j] - r[i], r[k] - r[i])));
    };
    if (within(1, 2, 3) && within(2, 0, 3) && within(0, 1, 3) && within(1, 0, 2))
      found.store(true, std::memory_order_relaxed);
  });
  return found;
}

}  // namespace havs
