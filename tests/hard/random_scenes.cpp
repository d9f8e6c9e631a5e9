#include "hard/random_scenes.h"

#include <algorithm>

#include "hard/random_meshes.h"
#include "mesh/defects.h"
#include "render/lookups.h"
#include "render/modes.h"
#include "sort/face_order.h"

namespace havs::test {
namespace {

using Json = nlohmann::ordered_json;

Json listOf(const Vec3& v) { return {v.x, v.y, v.z}; }

/// What sizes and places are measured by.
struct Extent {
  Vec3 center{0};
  double radius = 1;
  double low = 0, high = 1;  ///< of the field's numbers
};

Extent extentOf(const TetMesh& mesh) {
  Extent extent;
  Vec3 low(1e300), high(-1e300);
  for (const Tetrahedron& cell : mesh.tetrahedra)
    for (const Index i : cell)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], mesh.points[i][axis]);
        high[axis] = std::max(high[axis], mesh.points[i][axis]);
      }
  extent.center = 0.5 * (low + high);
  extent.radius = 0.5 * length(high - low);
  const Field& field = mesh.pointFields.empty() ? mesh.cellFields[0] : mesh.pointFields[0];
  double least = 1e300, most = -1e300;
  for (const double v : field.values) {
    if (!std::isfinite(v)) continue;
    least = std::min(least, v);
    most = std::max(most, v);
  }
  extent.low = least;
  extent.high = most > least ? most : least + 1;
  return extent;
}

double opacity(Dice& dice, bool extinction, bool opaque, double scale) {
  switch (dice.below(4)) {
    case 0:
      return 0;
    case 1:
      return dice.magnitude(1e-7, 0.999);
    default:
      if (extinction) return scale * dice.unit();
      return opaque && dice.chance(0.3) ? 1 : 0.999 * dice.unit();
  }
}

Json randomTransfer(Dice& dice, const Extent& extent) {
  const bool extinction = dice.chance(0.5), opaque = dice.chance(0.25);
  const double scale = dice.magnitude(0.1, 20);
  Json transfer{{"version", 1}, {"opacity", extinction ? "extinction" : "per_unit"}};
  if (dice.chance(0.8)) transfer["unit_length"] = extent.radius * dice.magnitude(0.05, 5);
  if (dice.chance(0.3)) {
    const double span = extent.high - extent.low, a = extent.low + span * dice.between(-0.2, 1);
    transfer["domain"] = {a, a + span * dice.magnitude(0.05, 2)};
  }
  const int count = dice.whole(1, 20);
  const bool even = dice.chance(0.3);
  std::vector<double> scalars;
  for (int i = 0; i < count; ++i) {
    const bool step = i > 0 && dice.chance(0.15);
    scalars.push_back(step ? scalars.back() : even ? dice.whole(0, 8) / 8.0 : dice.unit());
  }
  std::sort(scalars.begin(), scalars.end());
  for (std::size_t i = 2; i < scalars.size();)  // a step has two sides
    scalars[i] == scalars[i - 2] ? void(scalars.erase(scalars.begin() + static_cast<std::ptrdiff_t>(i))) : void(++i);
  transfer["points"] = Json::array();
  for (const double s : scalars) {
    const double r = dice.unit(), g = dice.unit(), b = dice.unit();
    transfer["points"].push_back(
        {{"scalar", s}, {"color", {r, g, b}}, {"opacity", opacity(dice, extinction, opaque, scale)}});
  }
  return transfer;
}

/// A place inside a cell.
Vec3 insideOf(Dice& dice, const TetMesh& mesh) {
  const Tetrahedron& cell = dice.of(mesh.tetrahedra);
  Vec3 place(0);
  double sum = 0;
  for (const Index i : cell) {
    const double share = dice.unit() + 1e-3;
    place += share * mesh.points[i];
    sum += share;
  }
  return place / sum;
}

Json randomCamera(Dice& dice, const TetMesh& mesh, const Extent& extent) {
  Json camera;
  const bool orthographic = dice.chance(0.35);
  if (orthographic) camera["projection"] = "orthographic";
  if (!orthographic && dice.chance(0.5)) camera["field_of_view"] = dice.chance(0.3) ? 150 : dice.between(2, 120);
  const std::size_t kind = dice.below(10);
  if (kind < 4) {
    camera["azimuth"] = dice.between(-180, 180);
    camera["elevation"] = dice.between(-90, 90);
  } else if (kind < 6) {  // along the axes and diagonals of grids
    camera["azimuth"] = 45 * dice.whole(0, 7);
    camera["elevation"] = 45 * dice.whole(-2, 2);
  } else {
    const bool inside = kind == 6, near = kind == 7;
    const double away = near ? dice.between(0.5, 1.5) : dice.magnitude(1.5, 1e4);
    const Vec3 eye = inside ? insideOf(dice, mesh) : extent.center + away * extent.radius * dice.direction();
    camera["eye"] = listOf(eye);
    camera["target"] = listOf(dice.chance(0.5) ? insideOf(dice, mesh) : eye + extent.radius * dice.direction());
    if (!inside && !near) {
      camera["target"] = listOf(extent.center);
      if (!orthographic) camera["field_of_view"] = std::clamp(120 / away, 0.001, 120.0);
    }
    if (dice.chance(0.3)) camera["up"] = listOf(dice.direction());
  }
  if (dice.chance(0.3)) camera["zoom"] = dice.magnitude(0.5, 30);
  return camera;
}

Json randomPlane(Dice& dice, const TetMesh& mesh) {
  const bool throughPoint = dice.chance(0.3), alongAxis = dice.chance(0.3);
  const Vec3 place = throughPoint ? dice.of(mesh.points) : insideOf(dice, mesh);
  Vec3 normal = dice.direction();
  if (alongAxis) {
    normal = Vec3(0);
    normal[dice.whole(0, 2)] = dice.chance(0.5) ? 1 : -1;
  }
  return {place.x, place.y, place.z, normal.x, normal.y, normal.z};
}

Json randomBox(Dice& dice, const TetMesh& mesh, const Extent& extent) {
  const Vec3 place = insideOf(dice, mesh);
  Json box = Json::array();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) box.push_back(place[axis] + side * extent.radius * dice.magnitude(1e-3, 1));
  return box;
}

void addParts(Dice& dice, Json& scene, const TetMesh& mesh, const Extent& extent) {
  if (dice.chance(0.2)) scene["clip_plane"] = randomPlane(dice, mesh);
  if (dice.chance(0.08)) scene["clip_box"] = randomBox(dice, mesh, extent);
  if (dice.chance(0.08)) scene["cut_box"] = randomBox(dice, mesh, extent);
  if (dice.chance(0.12)) {
    const double span = extent.high - extent.low, low = extent.low + span * dice.between(-0.1, 0.5);
    scene["threshold"] = {low, low + span * dice.between(0.2, 1)};
  }
}

void addIsosurfaces(Dice& dice, Json& scene, const Json& transfer, const TetMesh& mesh, const Extent& extent) {
  const double low = transfer.contains("domain") ? transfer["domain"][0].get<double>() : extent.low;
  const double high = transfer.contains("domain") ? transfer["domain"][1].get<double>() : extent.high;
  scene["isosurfaces"] = Json::array();
  for (int i = dice.whole(1, 4); i > 0; --i) {
    double value = dice.between(low, high);
    if (dice.chance(0.2)) value = dice.of(mesh.pointFields[0].values);  // that of a point, maybe of whole faces
    if (!(value >= low && value <= high)) value = low;
    Json surface{{"value", value}};
    const double r = dice.unit(), g = dice.unit(), b = dice.unit();
    if (dice.chance(0.7)) surface["color"] = {r, g, b};
    if (dice.chance(0.6)) surface["opacity"] = dice.magnitude(0.05, 1);
    scene["isosurfaces"].push_back(surface);
  }
}

void addMethod(Dice& dice, Json& scene) {
  if (dice.chance(0.6)) {
    scene["lookup"] = "exact";
  } else {
    const auto rows = lookups();
    const Lookup& row = rows[dice.below(rows.size())];
    const std::string name = exampleName(row);
    scene["lookup"] =
        row.parameter.empty() ? name : name.substr(0, name.find(':') + 1) + std::to_string(dice.whole(1, 12));
    if (tableOf(row) != nullptr) scene["table"] = dice.whole(4, 16);
  }
  scene["k"] = scene["lookup"] == "pre" ? dice.whole(1, 7) : dice.whole(1, 14);
  if (dice.chance(0.5)) {
    const auto rows = sortMethods();
    scene["sort"] = rows[dice.below(rows.size())].name;
  }
  if (dice.chance(0.1)) scene["composite_late"] = true;
  if (dice.chance(0.1)) scene["early_termination"] = dice.between(0.5, 1);
}

}  // namespace

RandomCase randomCase(Dice& dice) {
  RandomCase c;
  c.overlaps = dice.chance(0.05);
  c.mesh = c.overlaps ? randomOverlappingMesh(dice) : randomMesh(dice);
  addRandomField(dice, c.mesh);
  weldPoints(c.mesh);  // as reading a file does
  const Extent extent = extentOf(c.mesh);
  c.transfer = randomTransfer(dice, extent);
  c.scene["size"] = {dice.whole(8, 24), dice.whole(8, 24)};
  c.scene["camera"] = randomCamera(dice, c.mesh, extent);
  addParts(dice, c.scene, c.mesh, extent);
  addMethod(dice, c.scene);
  const bool surfaces = !c.mesh.pointFields.empty() && c.scene["lookup"] != "pre" && dice.chance(0.25);
  if (surfaces) addIsosurfaces(dice, c.scene, c.transfer, c.mesh, extent);
  if (surfaces && dice.chance(0.3)) {
    c.scene["mode"] = "isosurfaces";
  } else if (!surfaces && dice.chance(0.25)) {
    std::vector<std::string> names;
    for (const Mode& row : modes())
      if (row.gathering != Gathering::composite) names.push_back(row.name);
    c.scene["mode"] = dice.of(names);
    for (const char* key : {"early_termination", "composite_late"}) c.scene.erase(key);
  }
  return c;
}

}  // namespace havs::test
