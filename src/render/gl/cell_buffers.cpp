#include "render/gl/cell_buffers.h"

#include <array>
#include <numeric>

#include "core/parallel.h"
#include "render/corners_behind.h"
#include "render/fragment_values.h"
#include "render/gl/mesh_buffers.h"

namespace havs {
namespace {

constexpr GLuint kFirstUnit = 8;  // behind the lookup's textures

std::vector<std::array<float, 4>> pointsOf(const PreparedScene& prepared) {
  const bool pointData = !prepared.facts().cellData;
  std::vector<std::array<float, 4>> points(prepared.points.size());
  parallelFor(0, points.size(), kGrain, [&](std::size_t p) {
    const Vec3& q = prepared.points[p];
    points[p] = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                 pointData ? static_cast<float>(prepared.scalars[p]) : 0.0f};
  });
  return points;
}

/// As they lie in memory.
std::vector<Index> facesInOrder(std::size_t count) {
  std::vector<Index> faces(count);
  std::iota(faces.begin(), faces.end(), Index{0});
  return faces;
}

/// Three corners of each face, and that of the cell behind its front.
std::vector<std::array<Index, 4>> cornersOf(const Faces& faces, const std::vector<std::array<Index, 2>>& behind) {
  std::vector<std::array<Index, 4>> corners(faces.size());
  parallelFor(0, corners.size(), kGrain, [&](std::size_t f) {
    const auto& [a, b, c] = faces.vertices[f];
    corners[f] = {a, b, c, behind[f][0]};
  });
  return corners;
}

std::vector<Index> backCornersOf(const std::vector<std::array<Index, 2>>& behind) {
  std::vector<Index> corners(behind.size());
  parallelFor(0, corners.size(), kGrain, [&](std::size_t f) { corners[f] = behind[f][1]; });
  return corners;
}

}  // namespace

template <class T>
CellBuffers::Texels CellBuffers::texels(const char* name, GLenum format, const std::vector<T>& values) {
  Buffer buffer = Buffer::of(name, values);
  Texture texture = Texture::overBuffer(name, format, buffer);
  return {std::move(buffer), std::move(texture)};
}

CellBuffers::CellBuffers(const PreparedScene& prepared) : CellBuffers(prepared, cornersBehindFaces(prepared)) {}

CellBuffers::CellBuffers(const PreparedScene& prepared, const std::vector<std::array<Index, 2>>& behind)
    : faceCount_(prepared.faces.size()),
      points_(texels("points", GL_RGBA32F, pointsOf(prepared))),
      corners_(texels("corners of faces", GL_RGBA32UI, cornersOf(prepared.faces, behind))),
      back_(texels("corners behind faces", GL_R32UI, backCornersOf(behind))),
      order_(texels("face order", GL_R32UI, facesInOrder(prepared.faces.size()))) {
  if (prepared.facts().cellData) scalars_ = texels("scalars behind faces", GL_RG32F, scalarsBehindFaces(prepared));
}

void CellBuffers::bind(const Program& program) const {
  GLuint unit = kFirstUnit;
  auto use = [&](const Texels& texels, const char* name) {
    texels.texture.bind(unit);
    program.set(name, static_cast<int>(unit++));
  };
  use(points_, "points");
  use(corners_, "faceCorners");
  use(back_, "backCorners");
  use(order_, "faceOrder");
  if (scalars_) use(*scalars_, "faceScalars");
}

void CellBuffers::draw() const {
  array_.bind();
  drawInBatches(faceCount_, [](std::size_t first, std::size_t count) {
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first), static_cast<GLsizei>(3 * count));
  });
}

}  // namespace havs
