// A hidden window of GLFW: OpenGL as the desktop gives it.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "core/error.h"
#include "gl/devices.h"

namespace havs {

namespace {

std::string lastGlfwError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "no reason given";
}

// GLFW as a whole, for as long as a window is needed.
struct GlfwLibrary {
  GlfwLibrary() {
    if (glfwInit() == GLFW_TRUE) return;
    failRunning("no display (" + lastGlfwError() + ")", "--device glfw", "use --device osmesa, egl or native");
  }
  ~GlfwLibrary() { glfwTerminate(); }
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

GLFWwindow* createHiddenWindow() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  GLFWwindow* window = glfwCreateWindow(1, 1, "havs", nullptr, nullptr);
  if (!window) {
    failRunning("no window with OpenGL 4.5 core (" + lastGlfwError() + ")", "--device glfw",
                "use --device osmesa, egl or native");
  }
  return window;
}

class GlfwDevice : public Device {
 public:
  GlfwDevice() : window_(createHiddenWindow(), glfwDestroyWindow) {
    glfwMakeContextCurrent(window_.get());
    load(glfwGetProcAddress);
  }
  std::string name() const override { return "glfw"; }

 private:
  GlfwLibrary library_;
  std::unique_ptr<GLFWwindow, decltype(&glfwDestroyWindow)> window_;
};

}  // namespace

std::unique_ptr<Device> makeGlfwDevice() { return std::make_unique<GlfwDevice>(); }

}  // namespace havs
