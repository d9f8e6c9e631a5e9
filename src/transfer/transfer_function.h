#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace havs {

/// What opacity means (docs/02-method.md). `extinction`: kappa = opacity / unit length. `perUnit`: kappa = -ln(1 -
/// opacity) / unit length, the opacity that a slab one unit thick shows; opacity 1 is then an opaque surface.
enum class OpacityMeaning { extinction, perUnit };

struct ControlPoint {
  double scalar = 0;                     ///< in the transfer function's own scale
  std::array<double, 3> color{1, 1, 1};  ///< display-referred, 0 to 1
  double opacity = 0;                    ///< 0 to 1 (perUnit); >= 0 (extinction)
};

/// Colour and opacity over a scalar, linear between control points; two points at one scalar are a step.
struct TransferFunction {
  std::string name;
  std::vector<ControlPoint> points;  ///< ascending in scalar, at least one; constant beyond both ends
  bool normalised = true;            ///< scalars are fractions of the domain; else values in the data's unit
  OpacityMeaning meaning = OpacityMeaning::perUnit;
  std::optional<double> unitLength;  ///< in mesh units; default 1/20 of the bounding diagonal
  std::optional<std::array<double, 2>>
      domain;  ///< data values that 0 and 1 stand for; default the field's finite range
};

/// One row of the table of built-in transfer functions.
struct TransferPreset {
  std::string name;
  std::string description;
  TransferFunction function;
};
std::span<const TransferPreset> transferPresets();

/// A preset's name, or a file: our JSON, ParaView's colour map (.json or .xml), TF.bin (65,536 RGBA floats).
/// Throws Error{input}: unknown preset (names the nearest), missing file, broken content with its place, values out of
/// range.
TransferFunction loadTransferFunction(const std::string& presetOrFile);

/// The JSON text that loadTransferFunction reads back to the same function, bit for bit.
std::string toJson(const TransferFunction& function);

/// Colour and opacity at a scalar (in the function's own scale); at a step, the value of the upper side.
ControlPoint evaluate(const TransferFunction& function, double scalar);

/// The colours of a preset at `count` (at least 2) equal steps from 0 to 1, for colour bars and pictures of errors.
/// Throws Error{input} for an unknown name (names the nearest).
std::vector<std::array<double, 3>> presetColors(const std::string& name, std::size_t count = 256);

}  // namespace havs
