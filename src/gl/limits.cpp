#include "gl/limits.h"

#include <glad/gl.h>

#include <algorithm>

namespace havs {

namespace {

int integer(GLenum which) {
  GLint value = 0;
  glGetIntegerv(which, &value);
  return value;
}

}  // namespace

Limits limits() {
  Limits found;
  found.textureSize = integer(GL_MAX_TEXTURE_SIZE);
  found.texture3dSize = integer(GL_MAX_3D_TEXTURE_SIZE);
  found.bufferTexels = integer(GL_MAX_TEXTURE_BUFFER_SIZE);
  found.storageBlock = integer(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
  found.drawBuffers = std::min(integer(GL_MAX_DRAW_BUFFERS), integer(GL_MAX_COLOR_ATTACHMENTS));
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  found.viewportWidth = viewport[0];
  found.viewportHeight = viewport[1];
  return found;
}

}  // namespace havs
