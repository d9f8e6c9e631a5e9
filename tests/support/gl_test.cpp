#include "support/gl_test.h"

#include <dlfcn.h>
#include <link.h>

#include <string_view>

// Mesa leaks some hundred bytes with each context.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\nleak:_dri.so\n"; }

namespace havs {

namespace {

int addDriver(dl_phdr_info* library, std::size_t, void* drivers) {
  const std::string_view path = library->dlpi_name;
  if (path.ends_with("_dri.so")) static_cast<std::vector<std::string>*>(drivers)->emplace_back(path);
  return 0;
}

// A driver that is unloaded cannot be named in the suppressions above.
void keepDriversLoaded() {
  std::vector<std::string> drivers;
  dl_iterate_phdr(addDriver, &drivers);
  for (const std::string& driver : drivers) dlopen(driver.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
}

}  // namespace

void GlTest::SetUp() {
  if (GetParam() == "glfw") {
    try {
      xServer_ = std::make_unique<Xvfb>();
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  device_ = makeTestDevice(GetParam());
}

void FramebufferFetch::SetUp() {
  GlTest::SetUp();
  if (IsSkipped()) return;
  if (!device_->hasExtension(kFetch.extensions.front())) GTEST_SKIP() << "no framebuffer fetch here";
}

std::unique_ptr<Device> makeTestDevice(const std::string& name) {
  auto device = makeDevice(name);
  keepDriversLoaded();
  return device;
}

std::vector<std::string> deviceNames() {
  std::vector<std::string> names;
  for (const DeviceRow& row : deviceRows()) names.push_back(row.name);
  return names;
}

Program makeProgram(const std::string& vertex, const std::string& fragment, const ShaderOptions& options) {
  return Program("test", {{GL_VERTEX_SHADER, shaderSourceFromText("test.vert", vertex, {options.defines, {}})},
                          {GL_FRAGMENT_SHADER, shaderSourceFromText("test.frag", fragment, options)}});
}

}  // namespace havs
