#pragma once
// What the mesh tests measure by themselves, without the code they test.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "mesh/cells.h"
#include "mesh/tet_mesh.h"

namespace havs::test {

inline double volumeOf(const TetMesh& mesh, const Tetrahedron& t) {
  const Vec3 a = mesh.points[t[0]];
  return glm::dot(glm::cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a), mesh.points[t[3]] - a) / 6;
}

inline double totalVolume(const TetMesh& mesh) {
  double sum = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) sum += volumeOf(mesh, t);
  return sum;
}

inline double smallestVolume(const TetMesh& mesh) {
  double smallest = 1e300;
  for (const Tetrahedron& t : mesh.tetrahedra) smallest = std::min(smallest, volumeOf(mesh, t));
  return smallest;
}

/// How many tetrahedra have each face.
inline std::map<std::array<Index, 3>, int> faceCounts(const TetMesh& mesh) {
  std::map<std::array<Index, 3>, int> counts;
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      std::array<Index, 3> face{};
      for (std::size_t i = 0, to = 0; i < 4; ++i)
        if (i != opposite) face[to++] = t[i];
      std::sort(face.begin(), face.end());
      ++counts[face];
    }
  return counts;
}

/// The number of faces that exactly one tetrahedron has; -1 when a face has more than two.
inline int boundaryFaces(const TetMesh& mesh) {
  int boundary = 0;
  for (const auto& [face, count] : faceCounts(mesh)) {
    if (count > 2) return -1;
    boundary += count == 1 ? 1 : 0;
  }
  return boundary;
}

inline void addCell(CellSoup& soup, std::uint8_t type, const std::vector<std::int64_t>& numbers) {
  if (soup.offsets.empty()) soup.offsets.push_back(0);
  soup.types.push_back(type);
  soup.connectivity.insert(soup.connectivity.end(), numbers.begin(), numbers.end());
  soup.offsets.push_back(static_cast<std::int64_t>(soup.connectivity.size()));
}

/// The message of the input error that `call` throws; empty when it throws none.
template <class Call>
std::string inputError(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.kind() == ErrorKind::input ? error.what() : "";
  }
  return "";
}

/// A folder that goes with all in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int number = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("havs_mesh_test_" + std::to_string(getpid()) + "_" + std::to_string(number++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace havs::test
