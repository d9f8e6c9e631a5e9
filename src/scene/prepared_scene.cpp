#include "scene/prepared_scene.h"

#include <fmt/format.h>

#include <atomic>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/read.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

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

void prepareField(PreparedScene& prepared, const Scene& scene) {
  prepared.field = selectField(prepared.mesh, scene.field);
  prepared.mesh.pointFields.clear();
  prepared.mesh.cellFields.clear();
  prepared.mesh.pointFields.shrink_to_fit();
  prepared.mesh.cellFields.shrink_to_fit();
  if (const std::size_t holes = withoutHoles(prepared.mesh, prepared.field))
    prepared.notes.push_back(fmt::format("{} cells without a finite scalar are holes", holes));
}

void prepareCurve(PreparedScene& prepared, const Scene& scene) {
  const TransferFunction function = transferFunctionOf(scene);
  CurveSetting setting;
  setting.fieldRange = {prepared.field.minimum, prepared.field.maximum};
  setting.boundingDiagonal = prepared.frame.diagonal;
  setting.radius = prepared.frame.radius;
  prepared.curve = makeCurve(function, setting);
  prepared.transferFunction = function.name;
  prepared.meaning = function.meaning;
}

}  // namespace

PreparedScene prepareScene(const Scene& scene, TetMesh mesh, StageTimes& stages) {
  PreparedScene prepared;
  {
    const ScopedStage timer(stages, "prepare");
    prepared.notes = mesh.notes;
    prepared.defects = inspectMesh(mesh);
    noteRepairs(prepared);
    prepared.mesh = repairMesh(std::move(mesh));
    prepareField(prepared, scene);
    prepared.frame = localFrame(prepared.mesh);
    prepared.points = localPoints(prepared.mesh, prepared.frame);
    prepared.longestEdge = longestEdge(prepared.mesh, prepared.points);
    prepareCurve(prepared, scene);
    prepared.scalars = normalisedScalars(prepared.field, prepared.curve);
    prepared.field.values = {};
  }
  const ScopedStage timer(stages, "faces");
  prepared.faces = buildFaces(prepared.mesh);
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

View viewOf(const Scene& scene, const PreparedScene& prepared) {
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  if (!view.orthographic && insideMesh(prepared, view.eye))
    failInput("the camera is inside the mesh", "camera", "move it out, or look with an orthographic projection");
  return view;
}

bool insideMesh(const PreparedScene& prepared, const Vec3& point) {
  std::atomic<bool> found{false};
  const auto& cells = prepared.mesh.tetrahedra;
  parallelFor(0, cells.size(), 16384, [&](std::size_t c) {
    std::array<Vec3, 4> r;
    for (int i = 0; i < 4; ++i) r[i] = prepared.points[cells[c][i]] - point;
    auto volume = [&](int i, int j, int k) { return dot(cross(r[i], r[j]), r[k]); };
    const bool inside = volume(1, 2, 3) >= 0 && volume(2, 0, 3) >= 0 && volume(0, 1, 3) >= 0 && volume(1, 0, 2) >= 0;
    if (inside) found.store(true, std::memory_order_relaxed);
  });
  return found;
}

}  // namespace havs
