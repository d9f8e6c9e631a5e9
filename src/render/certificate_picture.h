#pragma once
#include "image/image.h"
#include "scene/renderer.h"

namespace havs {

/// Where the order of a picture `width` pixels wide is wrong: black where no fragment was misordered, else a colour for
/// their number, on a logarithmic scale from violet (1) over red to pale yellow (the most that a pixel has). Opaque.
Image certificatePicture(const Certificate& certificate, int width);

/// The most misordered fragments of a pixel.
std::uint32_t mostMisordered(const Certificate& certificate);

}  // namespace havs
