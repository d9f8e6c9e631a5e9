#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/mesh_quality.h"
#include "mesh/defects.h"
#include "mesh/scalar_field.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// One field of a mesh: what `havs info` lists.
struct FieldSummary {
  std::string name;
  Centering centering = Centering::point;
  int components = 1;
  std::optional<Range>
      range;  ///< of the finite values at points (cells) in use, a vector's magnitude; none when there is no such value
};

/// A mesh as read and cut, before any repair.
struct MeshReport {
  std::filesystem::path file;
  std::size_t points = 0, cells = 0, tetrahedra = 0;  ///< cells: as in the file
  std::vector<FieldSummary> fields;
  std::optional<ScalarField>
      drawn;  ///< the field asked for, else the default one; none when the mesh has no field to draw
  MeshQuality quality;
  std::vector<Defect> defects;
  std::vector<std::string> notes;
};

/// `field`: as selectField's name; empty: the default. Throws Error{input} for a field that is asked for and not there.
MeshReport reportMesh(const TetMesh& mesh, const std::filesystem::path& file, const std::string& field);

/// Keys in snake_case; numbers from 0.
nlohmann::ordered_json reportAsJson(const MeshReport& report);
/// The same in a few lines for people.
std::string reportAsText(const MeshReport& report);

/// One object a kind, those with count 0 too.
nlohmann::ordered_json defectsAsJson(const std::vector<Defect>& defects);

}  // namespace havs
