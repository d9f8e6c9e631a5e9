#include "render/gl/done_pixels.h"

namespace havs {
namespace {

constexpr GLuint kAllBits = 0xFF;

void skipMarked() {
  glStencilFunc(GL_EQUAL, 0, kAllBits);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

}  // namespace

void DonePixels::begin() const {
  glStencilMask(kAllBits);
  glClearStencil(0);
  glClear(GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  skipMarked();
}

void DonePixels::mark(float terminalOpacity) const {
  program_.set("terminalOpacity", terminalOpacity);
  program_.use();
  noVertices_.bind();
  glStencilFunc(GL_ALWAYS, 1, kAllBits);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  skipMarked();
}

void DonePixels::end() const { glDisable(GL_STENCIL_TEST); }

}  // namespace havs
