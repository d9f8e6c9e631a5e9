#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "support/gl_test.h"

namespace havs {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder of shaders that HAVS_SHADERS names while it lives.
class ShaderFolder {
 public:
  ShaderFolder() : path_(std::filesystem::temp_directory_path() / ("havs-shaders-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_ / "core");
    setenv("HAVS_SHADERS", path_.c_str(), 1);
  }
  ~ShaderFolder() {
    unsetenv("HAVS_SHADERS");
    std::filesystem::remove_all(path_);
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

 private:
  std::filesystem::path path_;
};

template <class Action>
std::string errorOf(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ShaderSource, TheFilesOfShadersAreEmbeddedWordForWord) {
  const ShaderSource source = shaderSource("core/compositing.glsl");
  ASSERT_EQ(source.files.size(), 2U);
  std::ifstream file(HAVS_SHADERS_FOLDER "/core/compositing.glsl");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_FALSE(text.empty());
  EXPECT_EQ(source.files[1].text, text);
}

TEST(ShaderSource, HeaderComesFirstThenFilesWithTheirLines) {
  const ShaderFolder folder;
  folder.write("main.frag", "a\n#include \"core/x.glsl\"\nb\n  # include \"core/y.glsl\" // again\nc\n");
  folder.write("core/x.glsl", "#include \"core/y.glsl\"\nx\n");
  folder.write("core/y.glsl", "y\n");
  const ShaderSource source = shaderSource("main.frag", {{{"HAVS_K", "6"}, {"FLAG", ""}}, {"GL_EXT_some"}});
  EXPECT_EQ(source.text,
            "#version 450 core\n#extension GL_EXT_some : require\n#define FLAG \n#define HAVS_K 6\n"
            "#line 1 1\na\n"
            "#line 1 2\n"
            "#line 1 3\ny\n"
            "#line 2 2\nx\n"
            "#line 3 1\nb\n"
            "#line 5 1\nc\n");
}

TEST(ShaderSource, AFileThatIncludesItselfIsTakenOnce) {
  const ShaderFolder folder;
  folder.write("loop.frag", "#include \"loop.frag\"\nend\n");
  EXPECT_THAT(shaderSource("loop.frag").text, HasSubstr("#line 1 1\n#line 2 1\nend\n"));
}

TEST(ShaderSource, AMissingFileNamesTheLineThatAsksForIt) {
  EXPECT_THAT(errorOf([] { shaderSource("core/kbufer.glsl"); }),
              AllOf(HasSubstr("'core/kbufer.glsl'"), HasSubstr("did you mean 'core/kbuffer.glsl'")));
  EXPECT_THAT(errorOf([] { shaderSourceFromText("mine", "\n#include \"no.glsl\"\n"); }), StartsWith("mine:2: "));
}

TEST(ShaderSource, LogsOfMesaAndNvidiaAreExplained) {
  const ShaderSource source = shaderSourceFromText("mine.frag", "first\n  second\n");
  EXPECT_EQ(explainLog("1:2(7): error: bad\n", source), "mine.frag:2: error: bad in 'second'");
  EXPECT_EQ(explainLog("1(1) : error C1008: undefined\n\n", source), "mine.frag:1: error C1008: undefined in 'first'");
  EXPECT_EQ(explainLog("99:2(7): error\nodd words\n", source), "99:2(7): error | odd words");
}

class Programs : public GlTest {};

TEST_P(Programs, ACompileErrorShowsFileAndLineOfTheIncludedFile) {
  const ShaderFolder folder;
  folder.write("core/broken.glsl", "float fine() { return 1.0; }\nfloat broken() { return nonsense; }\n");
  EXPECT_THAT(errorOf([] {
                makeProgram("void main() { gl_Position = vec4(0.0); }",
                            "#include \"core/broken.glsl\"\nout vec4 c;\nvoid main() { c = vec4(broken()); }");
              }),
              AllOf(HasSubstr("core/broken.glsl:2: "), HasSubstr("nonsense"), HasSubstr("'float broken() {")));
}

TEST_P(Programs, ALinkErrorIsReported) {
  EXPECT_THAT(errorOf([] {
                makeProgram("out vec2 a;\nvoid main() { a = vec2(0.0); gl_Position = vec4(0.0); }",
                            "in vec4 a;\nout vec4 c;\nvoid main() { c = a; }");
              }),
              HasSubstr("does not link"));
}

TEST_P(Programs, CacheCompilesEachVariantOnce) {
  const ShaderFolder folder;
  folder.write("a.vert", "void main() { gl_Position = vec4(0.0); }\n");
  folder.write("a.frag", "out vec4 c;\nvoid main() { c = vec4(VALUE); }\n");
  ProgramCache cache;
  const Program& one = cache.get("a.vert", "a.frag", {{{"VALUE", "1"}}, {}});
  const Program& two = cache.get("a.vert", "a.frag", {{{"VALUE", "2"}}, {}});
  EXPECT_NE(one.id(), two.id());
  EXPECT_EQ(&cache.get("a.vert", "a.frag", {{{"VALUE", "1"}}, {}}), &one);
  EXPECT_EQ(cache.size(), 2U);
}

HAVS_FOR_EVERY_DEVICE(Programs);

}  // namespace
}  // namespace havs
