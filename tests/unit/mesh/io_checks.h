#pragma once
// What the tests of readers and writers share.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "mesh/read.h"
#include "mesh/tet_mesh.h"
#include "support/temporary_folder.h"

namespace havs::test {

using Folder = TemporaryFolder;

inline double signedVolume(const TetMesh& mesh, const Tetrahedron& t) {
  const auto& p = mesh.points;
  return glm::dot(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), p[t[3]] - p[t[0]]) / 6;
}

/// Of the cells' volumes without sign.
inline double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) sum += std::abs(signedVolume(mesh, t));
  return sum;
}

inline const Field* find(const std::vector<Field>& fields, const std::string& name) {
  const auto found = std::ranges::find(fields, name, &Field::name);
  return found == fields.end() ? nullptr : &*found;
}

/// The field has value(point) at each point, to `tolerance`.
template <class Value>
void expectPointField(const TetMesh& mesh, const std::string& name, const Value& value, double tolerance) {
  const Field* field = find(mesh.pointFields, name);
  ASSERT_NE(field, nullptr) << name;
  ASSERT_EQ(field->tuples(), mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    ASSERT_NEAR(field->values[i], value(mesh.points[i]), tolerance) << name << " at point " << i;
}

/// Reading fails with exit status 2 and one line that names the file and contains `part`; nothing is printed.
inline void expectRefused(const std::filesystem::path& file, const std::string& part, const ReadOptions& options = {}) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string message;
  int status = 0;
  try {
    readMesh(file, options);
  } catch (const Error& error) {
    message = error.what();
    status = error.exitStatus();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << file;
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << file;
  EXPECT_EQ(status, 2) << file << ": " << message;
  EXPECT_THAT(message, testing::HasSubstr(file.stem().string())) << file;
  EXPECT_THAT(message, testing::HasSubstr(part)) << file;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace havs::test
