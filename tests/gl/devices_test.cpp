#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/error.h"
#include "support/gl_test.h"

namespace havs {
namespace {

using testing::HasSubstr;

TEST_P(GlTest, GivesOpenGl45Core) {
  GLint major = 0, minor = 0, profile = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(major * 10 + minor, 45);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
  EXPECT_EQ(device_->name(), GetParam());
  EXPECT_FALSE(device_->renderer().empty());
  EXPECT_FALSE(device_->version().empty());
  RecordProperty("renderer", device_->renderer());
  RecordProperty("version", device_->version());
}

TEST_P(GlTest, KnowsItsExtensions) {
  EXPECT_TRUE(device_->hasExtension("GL_KHR_debug"));
  EXPECT_FALSE(device_->hasExtension("GL_KHR_deb"));
}

TEST_P(GlTest, LimitsReachTheLeastOfOpenGl45) {
  const Limits found = limits();
  EXPECT_GE(found.textureSize, 16384);
  EXPECT_GE(found.texture3dSize, 2048);
  EXPECT_GE(found.bufferTexels, 65536);
  EXPECT_GE(found.drawBuffers, 8);
  EXPECT_GE(found.viewportWidth, found.textureSize);
  EXPECT_GE(found.viewportHeight, found.textureSize);
}

TEST_P(GlTest, CanBeMadeAgainAfterItsEnd) {
  for (int i = 0; i < 3; ++i) {
    device_.reset();
    device_ = makeDevice(GetParam());
    Buffer buffer = Buffer::of("ints", std::vector<int>{1, 2, 3});
    EXPECT_EQ(buffer.read<int>(3), (std::vector<int>{1, 2, 3}));
  }
}

TEST_P(GlTest, RefusesASecondDevice) {
  EXPECT_THROW(makeDevice(GetParam()), Error);
  device_.reset();
  EXPECT_NO_THROW(device_ = makeDevice(GetParam()));
}

HAVS_FOR_EVERY_DEVICE(GlTest);

TEST(Devices, FollowOneAnotherInOneProcess) {
  for (int round = 0; round < 2; ++round) {
    for (const char* name : {"osmesa", "egl"}) {
      const auto device = makeDevice(name);
      Buffer buffer = Buffer::of("ints", std::vector<int>{4, 5});
      EXPECT_EQ(buffer.read<int>(2), (std::vector<int>{4, 5})) << name;
    }
  }
}

// llvmpipe calls its threads by its own name.
int rasteriserThreads() {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream file(task.path() / "comm");
    std::string name;
    count += std::getline(file, name) && name.starts_with("llvmpipe");
  }
  return count;
}

// A thread takes its name when it first runs, which a busy machine delays: waits for that many, then for any in excess.
int settledRasteriserThreads(int expected) {
  using namespace std::chrono_literals;
  for (auto waited = 0ms; rasteriserThreads() < expected && waited < 10s; waited += 10ms) {
    std::this_thread::sleep_for(10ms);
  }
  std::this_thread::sleep_for(50ms);
  return rasteriserThreads();
}

TEST(Devices, ThreadsAreThoseOfLlvmpipe) {
  const int before = rasteriserThreads();  // OSMesa keeps its own to the end of the process
  for (int threads : {1, 3}) {
    const auto device = makeDevice("egl", static_cast<std::size_t>(threads));
    if (device->renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "a GPU draws";
    EXPECT_EQ(settledRasteriserThreads(before + threads), before + threads);
  }
  unsetenv("LP_NUM_THREADS");
}

TEST(Devices, UnknownNameIsAnInputErrorThatNamesTheNearest) {
  try {
    makeDevice("osmeso");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr("'osmeso'"));
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'osmesa'"));
  }
}

TEST(Devices, GlfwWithoutADisplaySaysWhatToUse) {
  const auto names = deviceNames();
  if (std::find(names.begin(), names.end(), "glfw") == names.end()) GTEST_SKIP() << "built without GLFW";
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  try {
    makeDevice("glfw");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::running);
    EXPECT_THAT(error.what(), HasSubstr("no display"));
    EXPECT_THAT(error.what(), HasSubstr("--device osmesa, egl or native"));
  }
}

}  // namespace
}  // namespace havs
