#pragma once
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "scene/prepared_scene.h"
#include "sort/face_order.h"

namespace havs {

/// Faces with the cells on both their sides in the memory of OpenGL, as cells.vert reads them: buffer textures, which
/// may be larger than storage blocks.
class CellBuffers {
 public:
  /// Throws Error{running} for more points or faces than a buffer texture has texels (2^27 in llvmpipe).
  explicit CellBuffers(const PreparedScene& prepared);

  /// Without it faces are drawn as they lie in memory.
  void setOrder(const FaceOrder& order) { order_.buffer.upload(std::span(order.faces)); }
  /// Binds the textures for `program` and sets their names.
  void bind(const Program& program) const;
  /// Draws all faces in that order with the program in use.
  void draw() const;

 private:
  CellBuffers(const PreparedScene& prepared, const std::vector<std::array<Index, 2>>& behind);
  /// A buffer seen as a texture.
  struct Texels {
    Buffer buffer;
    Texture texture;
  };
  template <class T>
  static Texels texels(const char* name, GLenum format, const std::vector<T>& values);

  std::size_t faceCount_;
  Texels points_, corners_, back_, order_;
  std::optional<Texels> scalars_;  ///< cell data
  VertexArray array_{"no vertices"};
};

}  // namespace havs
