#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace havs {

struct DebugLog;

/// An OpenGL context that is current on this thread while it lives. Drawing goes to framebuffer objects only.
/// One at a time in a process, for OpenGL's functions are loaded for one; GL objects are to be gone before their
/// device.
class Device {
 public:
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device();
  virtual std::string name() const = 0;  ///< "osmesa"
  /// GL_RENDERER, GL_VERSION.
  std::string renderer() const;
  std::string version() const;
  bool hasExtension(const std::string& name) const;

 protected:
  using Function = void (*)();
  using GetProcAddress = Function (*)(const char* name);
  /// Throws Error{running} while another device lives.
  Device();
  /// To be called once the context is current: loads OpenGL's functions through `getProcAddress`, checks for
  /// version 4.5 and starts to collect the driver's messages. Throws Error{running} where the version is lower.
  void load(GetProcAddress getProcAddress);

 private:
  std::unique_ptr<DebugLog> log_;
};

/// One row of the table of devices (`--device`).
struct DeviceRow {
  std::string name;
  std::string description;
  std::unique_ptr<Device> (*make)();  ///< throws Error{running} when such a context cannot be had here
};
/// osmesa, egl and, where built, glfw.
std::span<const DeviceRow> deviceRows();

/// Makes the context (OpenGL 4.5 core), makes it current and loads the functions. `threads`: rasteriser threads of a
/// CPU driver (LP_NUM_THREADS), 0 = as that variable says, else all cores; a driver reads it once a process, with its
/// first context. Throws Error{input} for an unknown name, Error{running} when it cannot be had (says what to try).
std::unique_ptr<Device> makeDevice(const std::string& name, std::size_t threads = 0);

}  // namespace havs
