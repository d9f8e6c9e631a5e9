#pragma once
#include <array>
#include <functional>
#include <optional>

#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/lookups.h"
#include "scene/prepared_scene.h"
#include "sort/face_order.h"

namespace havs {

/// Has `draw` draw all faces, so many from the first on at a time, and waits for the last but one batch: a driver keeps
/// what waits (docs/llvmpipe.md).
void drawInBatches(std::size_t faces, const std::function<void(std::size_t first, std::size_t count)>& draw);

/// The mesh in the memory of OpenGL: its points once, its faces anew in each picture's order.
/// Points of boundary faces are there a second time, behind all others, so that the vertex shader can tell such faces
/// by their vertex numbers.
class MeshBuffers {
 public:
  /// `carries`: what fragments are to carry, a colour besides or instead of the scalar.
  explicit MeshBuffers(const PreparedScene& prepared, Payload carries = Payload::scalar);

  /// Writes the indices of the faces in `order`, in parallel.
  void setOrder(const FaceOrder& order);
  /// Draws all faces in that order, in batches. Before each, `prepare` is told the number of its first face in the
  /// order (the uniform firstFace of programs for cell data); it must leave the program in use that is to draw.
  void drawInBatches(const std::function<void(std::size_t firstFace)>& prepare) const;

  /// The light of the points: rows of `rowLength` numbers, one a point.
  void setLight(const std::vector<float>& rows, int rowLength);

  /// Number of the first vertex that is a copy for boundary faces.
  int firstBoundaryVertex() const { return firstBoundaryVertex_; }

 private:
  void bind() const;
  void uploadVertices(const PreparedScene& prepared, Payload carries);

  const Faces& faces_;
  std::vector<Index> copied_;        ///< points that are there a second time, behind all
  std::vector<Index> boundaryCopy_;  ///< of each point; kNoIndex where it has none
  int firstBoundaryVertex_ = 0;
  std::optional<Buffer> vertices_;
  Buffer indices_;
  std::optional<Buffer> colors_;       ///< of points, where fragments carry them
  std::optional<Buffer> light_;        ///< of points, padded to four numbers
  std::optional<Buffer> cellScalars_;  ///< cell data: behind each face, seen from its front and from its back (colours)
  std::optional<Buffer> order_;        ///< cell data: the face that each primitive is
  VertexArray array_;
};

}  // namespace havs
