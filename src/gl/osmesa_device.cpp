// Mesa's off-screen interface: llvmpipe in memory, without window system, display or GPU.
#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <type_traits>

#include "core/error.h"
#include "gl/devices.h"
#include "gl/shared_library.h"

namespace havs {

namespace {

constexpr std::array kOsMesaNames = {"libOSMesa.so.8", "libOSMesa.so"};

// clang-format off
constexpr int kOsMesaCore45[] = {
    OSMESA_FORMAT, OSMESA_RGBA,
    OSMESA_DEPTH_BITS, 0,
    OSMESA_STENCIL_BITS, 0,
    OSMESA_ACCUM_BITS, 0,
    OSMESA_PROFILE, OSMESA_CORE_PROFILE,
    OSMESA_CONTEXT_MAJOR_VERSION, 4,
    OSMESA_CONTEXT_MINOR_VERSION, 5,
    0};
// clang-format on

SharedLibrary openOsmesa() {
  const char* driver = std::getenv("GALLIUM_DRIVER");
  // Mesa 22 crashes on a name that OSMesa does not know, and of those that it knows only llvmpipe has OpenGL 4.5.
  if (driver && *driver && std::string_view(driver) != "llvmpipe")
    failRunning(std::string("OSMesa cannot draw with GALLIUM_DRIVER=") + driver, "--device osmesa",
                "unset it, or try --device egl or native");
  return {kOsMesaNames, "install libosmesa6, or try --device egl or native"};
}

class OsmesaDevice : public Device {
 public:
  OsmesaDevice()
      : library_(openOsmesa()),
        context_(library_.function<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs")(kOsMesaCore45,
                                                                                                       nullptr),
                 library_.function<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext")) {
    if (!context_) {
      failRunning("OSMesa cannot make an OpenGL 4.5 core context", "--device osmesa",
                  "unset MESA_GL_VERSION_OVERRIDE, or try --device egl or native");
    }
    const auto makeCurrent = library_.function<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    if (!makeCurrent(context_.get(), pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      failRunning("OSMesa cannot make its context current", "--device osmesa", "try --device egl or native");
    }
    load(library_.function<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress"));
  }
  std::string name() const override { return "osmesa"; }

 private:
  using Context = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, decltype(&OSMesaDestroyContext)>;

  SharedLibrary library_;
  std::array<unsigned char, 4> pixel_{};  // OSMesa wants a picture to draw into; we draw into framebuffer objects only
  Context context_;
};

}  // namespace

std::unique_ptr<Device> makeOsmesaDevice() { return std::make_unique<OsmesaDevice>(); }

}  // namespace havs
