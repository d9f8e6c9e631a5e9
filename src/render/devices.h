#pragma once
// The table of devices: on what pictures are drawn.
#include <memory>
#include <span>
#include <string>

#include "gl/device.h"
#include "render/plan.h"

namespace havs {

/// A device that is ready to draw, while it lives.
struct RenderDevice {
  std::string name;      ///< of its row
  std::string renderer;  ///< what draws: "llvmpipe (LLVM 15.0.6, 256 bits)", "16 lanes (avx512)"
  std::string version;   ///< of its OpenGL; empty for the native device
  Capabilities capabilities;
  std::unique_ptr<Device> context;  ///< current on this thread; null for the native device
};

/// One row of the table (`--device`).
struct RenderDeviceRow {
  std::string name;
  std::string description;
  /// Throws Error{running} when it cannot be had here.
  RenderDevice (*open)(const RenderDeviceRow& row, std::size_t threads);
};
inline constexpr const char* kNativeDevice = "native";

/// The rows of deviceRows() (gl/device.h), then native.
std::span<const RenderDeviceRow> renderDevices();

/// Opens a device by its name. `threads`: see makeDevice (gl/device.h). Throws Error{input} for an unknown name,
/// Error{running} when it cannot be had (says what to try).
RenderDevice openRenderDevice(const std::string& name, std::size_t threads = 0);

}  // namespace havs
