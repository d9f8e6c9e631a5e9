#include "image/native_scene.h"

#include <fmt/format.h>

#include <bit>

#include "render/devices.h"
#include "render/make_renderer.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

PreparedScene prepare(const Scene& scene, TetMesh mesh) {
  StageTimes stages;
  return prepareScene(scene, std::move(mesh), stages);
}

}  // namespace

NativeScene::NativeScene(Scene asked, TetMesh mesh)
    : scene(std::move(asked)),
      prepared(prepare(scene, std::move(mesh))),
      view(makeView(scene.camera, prepared.frame, scene.width, scene.height)) {}

havs::Drawing NativeScene::drawAs(const Scene& asked, const PlanChange& change) const {
  StageTimes stages;
  RenderPlan chosen = plan(asked, prepared.facts(), openRenderDevice("native").capabilities);
  if (change) change(chosen);
  return makeRenderer(prepared, chosen, stages)->draw(view, stages);
}

havs::Drawing NativeScene::draw(const PlanChange& change) const { return drawAs(scene, change); }

Image NativeScene::truth() const {
  StageTimes stages;
  return makeReference(scene, prepared)->draw(view, stages).image;
}

Comparison NativeScene::againstTruth() const { return compareImages(draw().image, truth()); }

TetMesh withSmoothPoints(TetMesh mesh) {
  auto values = smoothField(mesh.points);
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  mesh.cellFields.clear();
  return mesh;
}

TetMesh withSmoothCells(TetMesh mesh) {
  std::vector<Vec3> centers;
  for (const Tetrahedron& cell : mesh.tetrahedra)
    centers.push_back(0.25 *
                      (mesh.points[cell[0]] + mesh.points[cell[1]] + mesh.points[cell[2]] + mesh.points[cell[3]]));
  auto values = smoothField(centers);
  mesh.pointFields.clear();
  mesh.cellFields = {Field{"c", 1, std::move(values)}};
  return mesh;
}

std::string differenceInBits(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return "other sizes";
  std::size_t pixels = 0, first = 0;
  double most = 0;
  for (std::size_t i = 0; i < a.rgba.size() / 4; ++i) {
    bool same = true;
    for (std::size_t c = 4 * i; c < 4 * i + 4; ++c) {
      same = same && std::bit_cast<std::uint32_t>(a.rgba[c]) == std::bit_cast<std::uint32_t>(b.rgba[c]);
      most = std::max<double>(most, std::abs(a.rgba[c] - b.rgba[c]));
    }
    if (same) continue;
    if (pixels++ == 0) first = i;
  }
  if (pixels == 0) return "";
  const auto width = static_cast<std::size_t>(a.width);
  return fmt::format("{} of {} pixels differ, by up to {}, first {},{}", pixels, a.rgba.size() / 4, most, first % width,
                     first / width);
}

std::string differenceInBits(const havs::Drawing& a, const havs::Drawing& b) {
  std::string text = differenceInBits(a.image, b.image);
  if (a.certificate.has_value() != b.certificate.has_value()) return text + " one has no certificate";
  if (!a.certificate) return text;
  if (a.certificate->count != b.certificate->count)
    text += fmt::format(" {} and {} late", a.certificate->misordered, b.certificate->misordered);
  if (a.certificate->fragments != b.certificate->fragments)
    text += fmt::format(" {} and {} looked at", a.certificate->fragments, b.certificate->fragments);
  return text;
}

}  // namespace havs::test
