#include "support/gl_test.h"

namespace havs {

void GlTest::SetUp() {
  if (GetParam() == "glfw") {
    try {
      xServer_ = std::make_unique<Xvfb>();
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  device_ = makeDevice(GetParam());
}

void FramebufferFetch::SetUp() {
  GlTest::SetUp();
  if (IsSkipped()) return;
  if (!device_->hasExtension(kFetch.extensions.front())) GTEST_SKIP() << "no framebuffer fetch here";
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
