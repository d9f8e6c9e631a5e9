#pragma once
#include "gl/buffer.h"
#include "gl/program.h"
#include "render/gl/tile.h"
#include "scene/renderer.h"

namespace havs {

inline constexpr GLuint kLateFragmentsBinding = 2;  // as in certificate.glsl

/// A certificate without a late fragment, of a picture of this size.
Certificate emptyCertificate(int width, int height);

/// Counts the late fragments of a tile in a storage buffer (shaders/certificate.glsl), and all its fragments by an
/// occlusion query. A driver that drops fragments of opaque triangles would drop counts with them: programs that count
/// read the framebuffer, or draw with the colour mask off (docs/llvmpipe.md).
class CertificateCounter {
 public:
  /// For tiles of up to `width` x `height` pixels. Throws Error{running} when there is no memory.
  CertificateCounter(int width, int height);
  CertificateCounter(const CertificateCounter&) = delete;
  CertificateCounter& operator=(const CertificateCounter&) = delete;
  ~CertificateCounter();

  /// Counts from 0 what `program` draws from now on.
  void begin(const Program& program, const Tile& tile);
  void end();
  /// Adds the tile's counts to those of a picture of `pictureHeight` rows; waits for the drawing.
  void addTo(Certificate& certificate, const Tile& tile, int pictureHeight) const;

 private:
  Buffer counts_;  ///< of each pixel of the tile, rows from the bottom up
  GLuint query_ = 0;
};

}  // namespace havs
