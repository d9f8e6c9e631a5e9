#pragma once
#include "gl/program.h"
#include "gl/vertex_array.h"

namespace havs {

/// Spares pixels that take no more fragments the shader: from time to time they are marked in the stencil
/// (shaders/done_pixels.frag), which is tested before the shader runs.
class DonePixels {
 public:
  /// `program`: of done_pixels.frag, for the targets in use.
  explicit DonePixels(const Program& program) : program_(program) {}
  /// No pixel of the framebuffer in use is done; those that are marked later are skipped.
  void begin() const;
  /// Marks the pixels of at least `terminalOpacity`. Another program and vertex array are in use afterwards.
  void mark(float terminalOpacity) const;
  /// Nothing is skipped any more.
  void end() const;

 private:
  const Program& program_;
  VertexArray noVertices_{"no vertices"};
};

}  // namespace havs
