#pragma once
// What may be drawn of the mesh's shape inside its volume (docs/03-scene.md, The mesh's shape).
#include <optional>

#include "image/image.h"

namespace havs {

struct Scene;

/// The edges of the box around the whole mesh, before it is cut, along the axes of its coordinates.
struct Outline {
  Color color{0.5, 0.5, 0.5};
  double width = 1.5;  ///< pixels
};

/// The boundary faces of the mesh as it is shown, clipped and by threshold.
struct BoundarySurface {
  Color color{0.8, 0.8, 0.8};
  double opacity = 0.3;  ///< of (0, 1]
  /// Whether a head light falls on both sides of the faces: the colour times kAmbient + (1 - kAmbient) |n.r|, n the
  /// face's normal, r the ray's direction, both of length 1. Else the colour is as it is.
  bool shaded = true;
  static constexpr double kAmbient = 0.3;
};

/// The edges of these faces, each drawn on the faces that it bounds.
struct WireFrame {
  Color color{0, 0, 0};
  double width = 1;    ///< pixels
  double opacity = 1;  ///< of (0, 1]
  /// Degrees: only edges between two faces whose normals differ by more, and those that do not lie between two. Empty:
  /// all.
  std::optional<double> featureAngle;
};

struct Overlays {
  std::optional<Outline> outline;
  std::optional<BoundarySurface> surface;
  std::optional<WireFrame> wireFrame;
  bool any() const { return outline || layers(); }
  /// Whether any lies at many depths inside the volume.
  bool layers() const { return surface || wireFrame; }
};

inline constexpr double kWidestLine = 64;  ///< pixels

/// Numbers that are: colours of [0, 1], widths above 0 up to kWidestLine, opacities of (0, 1], angles of [0, 180].
/// Throws Error{input}.
void checkOutline(const Outline& outline);
void checkSurface(const BoundarySurface& surface);
void checkWireFrame(const WireFrame& wireFrame);

}  // namespace havs
