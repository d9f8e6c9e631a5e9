#pragma once
#include <memory>
#include <span>
#include <string>

namespace havs {

/// An OpenGL context that is current on this thread while it lives. Drawing goes to framebuffer objects only.
class Device {
 public:
  virtual ~Device() = default;
  virtual std::string name() const = 0;  ///< "osmesa"
  /// GL_RENDERER, GL_VERSION.
  std::string renderer() const;
  std::string version() const;
  bool hasExtension(const std::string& name) const;
};

/// One row of the table of devices (`--device`).
struct DeviceRow {
  std::string name;
  std::string description;
  std::unique_ptr<Device> (*make)();  ///< throws Error{running} when such a context cannot be had here
};
/// osmesa, egl and, where built, glfw.
std::span<const DeviceRow> deviceRows();

/// Makes the context (OpenGL 4.5 core), makes it current and loads the functions. `threads`: rasteriser threads of a CPU driver
/// (LP_NUM_THREADS), 0 = all cores. Throws Error{input} for an unknown name, Error{running} when it cannot be had (says what to try).
std::unique_ptr<Device> makeDevice(const std::string& name, std::size_t threads = 0);

}  // namespace havs
