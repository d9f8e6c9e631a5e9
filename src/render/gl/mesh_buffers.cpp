#include "render/gl/mesh_buffers.h"

#include <algorithm>
#include <array>
#include <deque>

#include "core/parallel.h"
#include "gl/fence.h"
#include "render/fragment_values.h"

namespace havs {
namespace {

using Triangle = std::array<Index, 3>;
struct Vertex {
  float x, y, z, scalar;
};

/// llvmpipe bins triangles faster than it rasterises them and keeps all bins that wait: 500 bytes a tetrahedron when a
/// million are drawn in one go. Batches are therefore waited for, the last but so many first, which costs no processor
/// time (docs/llvmpipe.md).
constexpr std::size_t kFacesPerBatch = 32768;
constexpr std::size_t kBatchesUnderWay = 2;

constexpr GLuint kFaceScalarsBinding = 0, kFaceOrderBinding = 1;  // as in kbuffer.frag

/// Numbers the points of boundary faces from `first` on.
std::vector<Index> numberBoundaryCopies(const Faces& faces, std::size_t pointCount, std::vector<Index>& copied) {
  std::vector<Index> copy(pointCount, kNoIndex);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!faces.isBoundary(f)) continue;
    for (const Index p : faces.vertices[f])
      if (copy[p] == kNoIndex) {
        copy[p] = static_cast<Index>(pointCount + copied.size());
        copied.push_back(p);
      }
  }
  return copy;
}

}  // namespace

MeshBuffers::MeshBuffers(const PreparedScene& prepared, Payload carries)
    : faces_(prepared.faces), indices_("face indices", prepared.faces.size() * sizeof(Triangle)), array_("faces") {
  uploadVertices(prepared, carries);
  array_.attribute(0, *vertices_, 4, GL_FLOAT, sizeof(Vertex));
  if (colors_) array_.attribute(1, *colors_, 4, GL_FLOAT, sizeof(ColorAndExtinction));
  array_.elements(indices_);
  if (prepared.facts().cellData) {
    cellScalars_ = carries == Payload::color ? Buffer::of("colours behind faces", colorsBehindFaces(prepared))
                                             : Buffer::of("scalars behind faces", scalarsBehindFaces(prepared));
    order_.emplace("face order", prepared.faces.size() * sizeof(Index));
  }
}

void MeshBuffers::uploadVertices(const PreparedScene& prepared, Payload carries) {
  const bool pointData = !prepared.facts().cellData;
  const std::size_t pointCount = prepared.points.size();
  std::vector<Index>& copied = copied_;
  boundaryCopy_ = numberBoundaryCopies(faces_, pointCount, copied);
  firstBoundaryVertex_ = static_cast<int>(pointCount);

  std::vector<Vertex> vertices(pointCount + copied.size());
  parallelFor(0, vertices.size(), 16384, [&](std::size_t i) {
    const std::size_t p = i < pointCount ? i : copied[i - pointCount];
    const Vec3& q = prepared.points[p];
    vertices[i] = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                   pointData ? static_cast<float>(prepared.scalars[p]) : 0.0f};
  });
  vertices_ = Buffer::of("points", vertices);
  if (carries != Payload::color || !pointData) return;
  std::vector<ColorAndExtinction> colors = colorsOfPoints(prepared);
  colors.reserve(vertices.size());
  for (const Index p : copied) colors.push_back(colors[p]);
  colors_ = Buffer::of("colours of points", colors);
}

void MeshBuffers::setOrder(const FaceOrder& order) {
  indices_.fill<Triangle>([&](std::span<Triangle> triangles) {
    parallelFor(0, order.faces.size(), 16384, [&](std::size_t i) {
      const Index f = order.faces[i];
      Triangle corners = faces_.vertices[f];
      if (faces_.isBoundary(f))
        for (Index& corner : corners) corner = boundaryCopy_[corner];
      triangles[i] = corners;
    });
  });
  if (order_) order_->upload(std::span(order.faces));
}

void MeshBuffers::setLight(const std::vector<float>& rows, int rowLength) {
  const auto length = static_cast<std::size_t>(rowLength), padded = (length + 3) / 4 * 4;
  const std::size_t points = rows.size() / length;
  std::vector<float> numbers(padded * (points + copied_.size()));
  parallelFor(0, points + copied_.size(), 16384, [&](std::size_t i) {
    const std::size_t p = i < points ? i : copied_[i - points];
    std::copy_n(&rows[p * length], length, &numbers[i * padded]);
  });
  light_ = Buffer::of("light of points", numbers);
  for (std::size_t vector = 0; vector < padded / 4; ++vector)
    array_.attribute(static_cast<GLuint>(2 + vector), *light_, 4, GL_FLOAT,
                     static_cast<GLsizei>(padded * sizeof(float)), 4 * sizeof(float) * vector);
}

void MeshBuffers::bind() const {
  array_.bind();
  if (!cellScalars_) return;
  cellScalars_->bindBase(GL_SHADER_STORAGE_BUFFER, kFaceScalarsBinding);
  order_->bindBase(GL_SHADER_STORAGE_BUFFER, kFaceOrderBinding);
}

void MeshBuffers::drawInBatches(const std::function<void(std::size_t)>& prepare) const {
  havs::drawInBatches(faces_.size(), [&](std::size_t first, std::size_t count) {
    prepare(first);
    bind();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(Triangle)));
  });
}

void drawInBatches(std::size_t faces, const std::function<void(std::size_t, std::size_t)>& draw) {
  std::deque<Fence> underWay;
  for (std::size_t first = 0; first < faces; first += kFacesPerBatch) {
    if (underWay.size() == kBatchesUnderWay) {
      underWay.front().wait();
      underWay.pop_front();
    }
    draw(first, std::min(kFacesPerBatch, faces - first));
    underWay.emplace_back();
  }
}

}  // namespace havs
