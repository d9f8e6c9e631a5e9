#include "gl/device.h"

#include <glad/gl.h>

#include <atomic>
#include <cstdlib>
#include <vector>

#include "core/error.h"
#include "core/find_row.h"
#include "gl/check.h"
#include "gl/devices.h"

namespace havs {

namespace {

std::atomic<bool> deviceLives = false;

std::string glText(GLenum which) {
  const auto* text = glGetString(which);
  return text ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace

Device::Device() {
  if (deviceLives.exchange(true)) {
    failRunning("two OpenGL devices at once", "", "let the first one go before making the next");
  }
}

Device::~Device() { deviceLives = false; }

void Device::load(GetProcAddress getProcAddress) {
  const int version = gladLoadGL(getProcAddress);
  const int major = GLAD_VERSION_MAJOR(version), minor = GLAD_VERSION_MINOR(version);
  if (major < 4 || (major == 4 && minor < 5)) {
    failRunning("OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " is too old, 4.5 is needed",
                "--device " + name(), "try another --device");
  }
  log_ = startDebugLog();
}

std::string Device::renderer() const { return glText(GL_RENDERER); }
std::string Device::version() const { return glText(GL_VERSION); }

bool Device::hasExtension(const std::string& wanted) const {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    if (reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))) == wanted) return true;
  }
  return false;
}

std::span<const DeviceRow> deviceRows() {
  static const std::vector<DeviceRow> rows = {
      {"osmesa", "Mesa's software rasteriser in memory; needs no display", makeOsmesaDevice},
      {"egl", "EGL without a surface; needs no display, uses a GPU where there is one", makeEglDevice},
#ifdef HAVS_HAS_GLFW
      {"glfw", "a hidden window; needs a display", makeGlfwDevice},
#endif
  };
  return rows;
}

std::unique_ptr<Device> makeDevice(const std::string& name, std::size_t threads) {
  if (threads > 0) setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  return findRow(deviceRows(), name, "device", "--device").make();
}

}  // namespace havs
