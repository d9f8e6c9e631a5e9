#pragma once
namespace havs {

/// What the current context can take.
struct Limits {
  int textureSize = 0;     ///< texels along an edge of a 2D texture
  int texture3dSize = 0;   ///< texels along an edge of a 3D texture
  int bufferTexels = 0;    ///< texels of a buffer texture
  int storageBlock = 0;    ///< bytes of a storage buffer that a shader sees
  int drawBuffers = 0;     ///< colour attachments drawn to at once
  int viewportWidth = 0;   ///< pixels
  int viewportHeight = 0;  ///< pixels
};
Limits limits();

}  // namespace havs
