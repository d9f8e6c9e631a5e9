// EGL without a surface: Mesa's surfaceless platform (a GPU where there is one, else llvmpipe), else the devices that
// EGL lists (NVIDIA's driver), else the default display. The first that gives an OpenGL 4.5 core context is taken.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "gl/devices.h"
#include "gl/shared_library.h"

namespace havs {

namespace {

constexpr std::array kEglNames = {"libEGL.so.1", "libEGL.so"};
constexpr EGLint kMaxDevices = 16;

// clang-format off
constexpr EGLint kDesktopOpenGl[] = {
    EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_SURFACE_TYPE, EGL_DONT_CARE,
    EGL_NONE};
constexpr EGLint kEglCore45[] = {
    EGL_CONTEXT_MAJOR_VERSION, 4,
    EGL_CONTEXT_MINOR_VERSION, 5,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
    EGL_NONE};
// clang-format on

/// libEGL, opened when asked for.
struct Egl {
  SharedLibrary library{kEglNames, "install libegl1 and libegl-mesa0, or try --device osmesa or native"};
  decltype(&eglGetProcAddress) getProcAddress = library.function<decltype(eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglQueryString) queryString = library.function<decltype(eglQueryString)>("eglQueryString");
  decltype(&eglGetDisplay) getDisplay = library.function<decltype(eglGetDisplay)>("eglGetDisplay");
  decltype(&eglInitialize) initialize = library.function<decltype(eglInitialize)>("eglInitialize");
  decltype(&eglTerminate) terminate = library.function<decltype(eglTerminate)>("eglTerminate");
  decltype(&eglBindAPI) bindApi = library.function<decltype(eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) chooseConfig = library.function<decltype(eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) createContext = library.function<decltype(eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroyContext = library.function<decltype(eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) makeCurrent = library.function<decltype(eglMakeCurrent)>("eglMakeCurrent");
  decltype(&eglGetError) getError = library.function<decltype(eglGetError)>("eglGetError");

  /// `display` EGL_NO_DISPLAY: the client's extensions.
  bool has(EGLDisplay display, std::string_view extension) const {
    const char* list = queryString(display, EGL_EXTENSIONS);
    return list && (" " + std::string(list) + " ").find(fmt::format(" {} ", extension)) != std::string::npos;
  }
  template <class F>
  F extensionFunction(const char* name) const {
    return reinterpret_cast<F>(getProcAddress(name));
  }
};

/// The displays to try, best first; found one after the other.
std::vector<std::function<EGLDisplay()>> candidates(const Egl& egl) {
  std::vector<std::function<EGLDisplay()>> found;
  const auto getPlatformDisplay = egl.extensionFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (getPlatformDisplay && egl.has(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    found.emplace_back([=] { return getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr); });
  }
  const auto queryDevices = egl.extensionFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (getPlatformDisplay && queryDevices && egl.has(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, kMaxDevices> devices{};
    EGLint count = 0;
    queryDevices(kMaxDevices, devices.data(), &count);
    for (EGLint i = 0; i < count; ++i) {
      found.emplace_back([=, device = devices[static_cast<std::size_t>(i)]] {
        return getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
      });
    }
  }
  found.emplace_back([&egl] { return egl.getDisplay(EGL_DEFAULT_DISPLAY); });
  return found;
}

/// A display with a current context, or the reason why there is none.
class EglContext {
 public:
  EglContext(const Egl& egl, EGLDisplay display) : egl_(egl), display_(display) {
    const char* missing = open();
    if (missing) failure_ = fmt::format("{} (EGL error {:#x})", missing, egl_.getError());
  }
  ~EglContext() {
    if (!initialised_) return;
    egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) egl_.destroyContext(display_, context_);
    egl_.terminate(display_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  /// Empty: the context is current.
  const std::string& failure() const { return failure_; }

 private:
  /// What cannot be had; nullptr where the context is current.
  const char* open() {
    if (display_ == EGL_NO_DISPLAY || !egl_.initialize(display_, nullptr, nullptr)) return "no display";
    initialised_ = true;
    if (!egl_.has(display_, "EGL_KHR_surfaceless_context")) return "no EGL_KHR_surfaceless_context";
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (!egl_.bindApi(EGL_OPENGL_API)) return "no desktop OpenGL";
    if (!egl_.chooseConfig(display_, kDesktopOpenGl, &config, 1, &configs) || configs < 1) return "no configuration";
    context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, kEglCore45);
    if (context_ == EGL_NO_CONTEXT) return "no OpenGL 4.5 core";
    if (!egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return "cannot be made current";
    return nullptr;
  }

  const Egl& egl_;
  EGLDisplay display_;
  bool initialised_ = false;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string failure_;
};

class EglDevice : public Device {
 public:
  EglDevice() {
    std::string reasons;
    for (const auto& candidate : candidates(egl_)) {
      context_ = std::make_unique<EglContext>(egl_, candidate());
      if (context_->failure().empty()) break;
      reasons += (reasons.empty() ? "" : ", ") + context_->failure();
      context_.reset();
    }
    if (!context_) {
      failRunning("EGL gives no OpenGL 4.5 core context without a surface: " + reasons, "--device egl",
                  "install libegl-mesa0 and libgl1-mesa-dri, or try --device osmesa or native");
    }
    load(egl_.getProcAddress);
  }
  std::string name() const override { return "egl"; }

 private:
  Egl egl_;
  std::unique_ptr<EglContext> context_;
};

}  // namespace

std::unique_ptr<Device> makeEglDevice() { return std::make_unique<EglDevice>(); }

}  // namespace havs
