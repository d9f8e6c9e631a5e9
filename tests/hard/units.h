#pragma once
// A mesh, and all that a scene says in its units, told in other units: the picture may not change.
#include "mesh/tet_mesh.h"
#include "scene/scene.h"

namespace havs::test {

struct Units {
  double length = 1;  ///< of one unit of length as it was
  Vec3 place{0};      ///< where the origin goes to
  double scalar = 1;  ///< of one unit of the field as it was
  double offset = 0;  ///< where the field's 0 goes to

  Vec3 point(const Vec3& p) const { return length * p + place; }
  double value(double v) const { return scalar * v + offset; }
  /// What point() and value() leave of a number: the way there and back.
  Vec3 rounded(const Vec3& p) const { return (point(p) - place) / length; }
  double rounded(double v) const { return (value(v) - offset) / scalar; }
};

template <class Point, class Value>
TetMesh mapped(TetMesh mesh, const Point& point, const Value& value) {
  for (Vec3& p : mesh.points) p = point(p);
  for (auto* fields : {&mesh.pointFields, &mesh.cellFields})
    for (Field& field : *fields)
      for (double& v : field.values) v = value(v);
  return mesh;
}

inline TetMesh meshIn(const Units& units, const TetMesh& mesh) {
  return mapped(
      mesh, [&](const Vec3& p) { return units.point(p); }, [&](double v) { return units.value(v); });
}

/// The mesh that is left when its numbers have been rounded to what they are in `units`.
inline TetMesh roundedBy(const Units& units, const TetMesh& mesh) {
  return mapped(
      mesh, [&](const Vec3& p) { return units.rounded(p); }, [&](double v) { return units.rounded(v); });
}

/// Unit length and domain must be those of the scene, its transfer function over fractions of the domain.
inline Scene sceneIn(const Units& units, Scene scene) {
  if (scene.unitLength) *scene.unitLength *= units.length;
  for (auto* range : {&scene.domain, &scene.threshold})
    if (*range) *range = {units.value((**range)[0]), units.value((**range)[1])};
  for (auto* place : {&scene.camera.eye, &scene.camera.target})
    if (*place) **place = units.point(**place);
  if (scene.camera.viewHeight) *scene.camera.viewHeight *= units.length;
  for (Isosurface& surface : scene.isosurfaces) surface.value = units.value(surface.value);
  for (ClipPlane& plane : scene.clipPlanes) plane.point = units.point(plane.point);
  for (ClipBox& box : scene.clipBoxes) {
    box.low = units.point(box.low);
    box.high = units.point(box.high);
  }
  for (SceneLight& light : scene.lights)
    if (light.kind == SceneLight::Kind::point) light.place = units.point(light.place);
  return scene;
}

}  // namespace havs::test
