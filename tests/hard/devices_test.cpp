// OpenGL that cannot be had.
#include "hard/trouble.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

class Devices : public TroubleTest {
 protected:
  using Environment = std::map<std::string, std::string>;  ///< "" removes a variable

  /// Status 1 and one last line with the reason and another device to try.
  void expectTold(const std::string& device, const Environment& environment, const std::string& says) {
    const Outcome outcome =
        run({"render", "cube.node", "--size", "16x16", "--table", "8", "--device", device, "-o", "a.png"}, [&] {
          for (const auto& [name, value] : environment)
            value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
          doNotLookForLeaks();
        });
    const std::size_t begin = outcome.error.find("havs: ");  // Mesa may print before
    ASSERT_NE(begin, std::string::npos) << outcome.status << outcome.error;
    const std::string message = outcome.error.substr(begin);
    EXPECT_THAT(message, HasSubstr(says));
    EXPECT_THAT(message, HasSubstr("native"));
    untold_ += outcome.status != 1 || !isMessage(message) || !files().empty();
  }
  void expectAllTold() { expectAtMost("ends without a message", untold_, 0); }

 private:
  int untold_ = 0;
};

TEST_F(Devices, OsmesaCannotMakeAContext) {
  tell({"Trouble while running",
        "Mesa's OSMesa ends with a segmentation fault where GALLIUM_DRIVER names a driver that it "
        "does not know",
        "the variable is looked at first; a context that cannot be made is told with the devices to try"});
  expectTold("osmesa", {{"GALLIUM_DRIVER", "no-such-driver"}}, "GALLIUM_DRIVER=no-such-driver");
  expectTold("osmesa", {{"GALLIUM_DRIVER", "softpipe"}}, "GALLIUM_DRIVER=softpipe");
  expectTold("osmesa", {{"MESA_GL_VERSION_OVERRIDE", "3.3"}}, "OpenGL 4.5");
  expectAllTold();
}

TEST_F(Devices, LibraryIsBroken) {
  tell({"Trouble while running", "a library of that name is another one, or of another version",
        "what it lacks is told, with the devices to try"});
  // A library that is on every machine this runs on, under the name of another: it has none of its functions.
  std::string path;
  std::istringstream maps(contentOf("/proc/self/maps"));
  for (std::string line; std::getline(maps, line);)
    if (line.find("libgcc_s.so") != std::string::npos) path = line.substr(line.find('/'));
  ASSERT_FALSE(path.empty());
  const std::filesystem::path libraries = folder / "cube.libraries";
  std::filesystem::create_directory(libraries);
  for (const char* name : {"libOSMesa.so.8", "libEGL.so.1"}) std::filesystem::copy_file(path, libraries / name);
  expectTold("osmesa", {{"LD_LIBRARY_PATH", libraries}}, "libOSMesa.so.8 has no function");
  expectTold("egl", {{"LD_LIBRARY_PATH", libraries}}, "libEGL.so.1 has no function");
  expectAllTold();
}

TEST_F(Devices, EglWithoutADriver) {
  tell({"Trouble while running", "EGL is there, and no driver for it",
        "every display is tried, and why each fails is told"});
  expectTold("egl", {{"LIBGL_DRIVERS_PATH", "/nowhere"}}, "EGL gives no OpenGL 4.5 core context");
  expectTold("egl", {{"__EGL_VENDOR_LIBRARY_DIRS", "/nowhere"}}, "EGL gives no OpenGL 4.5 core context");
  expectTold("egl", {{"MESA_GL_VERSION_OVERRIDE", "3.3"}}, "no OpenGL 4.5 core");
  expectAllTold();
}

TEST_F(Devices, WindowWithoutADisplay) {
  tell({"Trouble while running", "a window is asked for on a machine without a display",
        "told, with the devices that need "
        "none"});
  const Outcome named = run({"render", "cube.node", "--device", "glfw", "-o", "a.png", "--size", "8x8"});
  if (named.error.find("glfw") == std::string::npos || named.status == 2) GTEST_SKIP() << "built without GLFW";
  expectTold("glfw", {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, "no display");
  expectTold("glfw", {{"DISPLAY", ":4711"}, {"WAYLAND_DISPLAY", ""}}, "no display");
  expectAllTold();
}

}  // namespace
}  // namespace havs::test
