#pragma once
// Tests that run once for every device that havs knows: TEST_P(GlTest, ...) and HAVS_FOR_EVERY_DEVICE(GlTest).
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "gl/device.h"
#include "gl/objects.h"
#include "support/xvfb.h"

namespace havs {

class GlTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override;

  std::unique_ptr<Xvfb> xServer_;  // for glfw
  std::unique_ptr<Device> device_;
};

/// The tests of those devices that have framebuffer fetch.
class FramebufferFetch : public GlTest {
 protected:
  void SetUp() override;
};
inline const ShaderOptions kFetch{{}, {"GL_EXT_shader_framebuffer_fetch"}};

std::vector<std::string> deviceNames();

/// makeDevice, whose driver stays loaded: the leak sanitizer could not name one that is gone.
std::unique_ptr<Device> makeTestDevice(const std::string& name);

/// A program from two texts.
Program makeProgram(const std::string& vertex, const std::string& fragment, const ShaderOptions& options = {});

}  // namespace havs

#define HAVS_FOR_EVERY_DEVICE(Suite)                                                 \
  INSTANTIATE_TEST_SUITE_P(Devices, Suite, testing::ValuesIn(::havs::deviceNames()), \
                           [](const auto& suiteInfo) { return suiteInfo.param; })
