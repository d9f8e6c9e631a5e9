#include "image/meshes_drawn.h"

#include <filesystem>

#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

std::optional<TetMesh> withSmoothField(TetMesh mesh) {
  auto values = smoothField(mesh.points);
  mesh.pointFields = {Field{"s", 1, std::move(values)}};
  return mesh;
}

MeshDrawn made(const std::string& name, TetMesh (*make)()) {
  return {name, 160, [make] { return withSmoothField(make()); }};
}

MeshDrawn real(const std::string& name, const std::string& file) {
  return {name, 256, [file]() -> std::optional<TetMesh> {
            const std::filesystem::path path = std::filesystem::path(HAVS_SHARED_DATA) / file;
            if (!std::filesystem::exists(path)) return std::nullopt;
            return readMesh(path);
          }};
}

MeshDrawn filled(const std::string& name, const std::string& surface, const std::string& switches) {
  return {name, 256, [=]() -> std::optional<TetMesh> {
            if (!HAVS_WITH_TETGEN) return std::nullopt;
            TetMesh mesh = readMesh(std::filesystem::path(HAVS_MESHES) / surface, {.tetgenSwitches = switches});
            mesh.pointFields = {fieldFromExpression(mesh, "s", "sqrt(x^2+y^2)+0.5*sin(5*z)*cos(3*x)")};
            return mesh;
          }};
}

}  // namespace

std::vector<MeshDrawn> meshesDrawn() {
  return {made("Ball", [] { return ball(8); }),
          made("JitteredBox", [] { return box(6, Cut::six, 0.25, 3); }),
          made("NestedShells", [] { return nestedShells(5); }),
          made("BoxWithHole", [] { return boxWithHole(6); }),
          made("StretchedLayers", [] { return stretchedLayers(10, 1.6); }),
          made("SeamOfAnOGrid", [] { return oGrid(5, 40, 5); }),
          filled("TetgenCube", "cube.poly", "pq1.4a0.001"),
          filled("TetgenTorusKnot", "torus_knot.off", "pq"),
          real("Spx", "spx.inp"),
          real("BluntFin", "bluntfinxyz.bin")};
}

}  // namespace havs::test
