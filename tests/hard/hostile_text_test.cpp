// Text that no writer writes: endless lines, deep nesting, bytes that are no text, other habits of writing numbers.
#include <fstream>

#include "hard/hostile.h"

namespace havs::test {
namespace {

class HostileText : public HostileTest {
 protected:
  /// Writes `count` times `piece` without holding it all.
  void repeat(std::ofstream& stream, const std::string& piece, std::size_t count) {
    std::string block;
    for (int i = 0; i < 1000; ++i) block += piece;
    for (; count >= 1000; count -= 1000) stream << block;
    for (; count > 0; --count) stream << piece;
  }
  std::string nested(const std::string& before, const std::string& open, const std::string& close,
                     const std::string& after, std::size_t depth = 1000000) {
    std::string text = before;
    for (std::size_t i = 0; i < depth; ++i) text += open;
    for (std::size_t i = 0; i < depth; ++i) text += close;
    return text + after;
  }
};

TEST_F(HostileText, LineOfAHundredMillionCharacters) {
  tell("readers that take a line into memory, or a word into a message, choke on a line without end",
       "the text is read once and walked through; messages quote 40 characters of a word");
  std::ofstream stream(folder / "words.node");
  stream << "8 3 1 0\n0 0 0 0 0\n1 1 0 0 ";
  repeat(stream, "9", 100000000);
  stream << "x\n";
  stream.close();
  folder.write("words.ele", kCubeEle);
  expectRefused({"info", "words.node"}, "words.node:3: '9999999999999999999999999999999999999999' is no number", 250);
  std::filesystem::resize_file(folder / "words.node", 20);
  std::ofstream comment(folder / "comment.node");
  comment << "# ";
  repeat(comment, "c", 100000000);
  comment << '\n' << kCubeNode;
  comment.close();
  folder.write("comment.ele", kCubeEle);
  expectRead({"info", "comment.node", "--quiet"}, 250);
}

TEST_F(HostileText, JsonAMillionDeep) {
  tell(
      "the JSON library copies and prints by recursion: a camera or a light nested a million deep needs a stack "
      "as deep",
      "text that opens more than 100 brackets is refused before it is parsed");
  folder.write("function.json", nested("", "[", "]", ""));
  folder.write("camera.json", nested("", R"({"eye":)", "}", ""));
  folder.write("camera-scene.json", nested(R"({"version":1,"mesh":"cube.node","camera":)", R"({"a":)", "}", "}"));
  folder.write("light-scene.json", nested(R"({"version":1,"mesh":"cube.node","light":)", "[", "]", "}"));
  const std::vector<std::string> picture{"-o", "a.png", "--size", "8x8"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), picture.begin(), picture.end());
    return arguments;
  };
  expectRefused(with({"render", "cube.node", "--tf", "function.json"}), "function.json");
  expectRefused(with({"render", "cube.node", "--camera", "camera.json"}), "camera");
  expectRefused(with({"render", "camera-scene.json"}), "more than 100 deep");
  expectRefused(with({"render", "light-scene.json"}), "more than 100 deep");
  folder.write("scene.json", R"({"version":1,"mesh":"cube.node"})");
  const std::string deep = nested("light=", "[", "]", "", 50000);
  expectRefused(with({"render", "scene.json", "--set", deep}), "light");
}

TEST_F(HostileText, StudyRecordsAMillionDeep) {
  tell("a study's runs.jsonl is read back by the same library; a line {} read the name behind an object's end",
       "each line is one object with one name, not nested deep, or the line is named as damaged");
  const std::string begun = R"({"study":{"version":1,"created":"x","identity":{}}})";
  std::filesystem::create_directories(folder / "deep");
  std::filesystem::create_directories(folder / "empty");
  folder.write("deep/runs.jsonl", nested("", "[", "]", "\n"));
  folder.write("empty/runs.jsonl", "{}\n" + begun + "\n");
  for (const char* name : {"deep", "empty"})
    expectRefused({"study", "cube.node", "--out", name, "--size", "8x8"}, "runs.jsonl:1: the line cannot be read", 200);
}

TEST_F(HostileText, XmlAMillionDeep) {
  tell("parsers of XML that call themselves for each element run out of stack",
       "the colour map's parser keeps its own stack; a .vtu is walked tag by tag, and VTK's parser runs in a child "
       "process");
  folder.write("map.xml", nested("", "<a>", "</a>", ""));
  expectRefused({"render", "cube.node", "--tf", "map.xml", "-o", "a.png"}, "map.xml", 250);
#if HAVS_WITH_VTK
  folder.write("mesh.vtu", nested("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">", "<a>", "</a>", "</VTKFile>"));
  expectRefused({"info", "mesh.vtu", "--max-memory", "300M"}, "mesh.vtu", 400);
#endif
}

TEST_F(HostileText, NulBytesAndControlCharacters) {
  tell("NUL ended an error's text early, and escape sequences that it quoted of a file reached the terminal",
       "an error's text has no control characters, whatever it quotes");
  const auto with = [](const std::string& word) {
    std::string text = kCubeNode;
    return text.replace(text.find("1 1 0 0 1"), 9, "1 1 0 0 " + word);
  };
  writeTetgenMesh(folder, "nul", with(std::string("1\0 2", 4)), kCubeEle);
  writeTetgenMesh(folder, "far", "#" + std::string(5000, ' ') + "\n" + with(std::string("1\0", 2)), kCubeEle);
  writeTetgenMesh(folder, "escape", with("\x1b[2J\x1b[31m"), kCubeEle);
  expectRefused({"info", "nul.node"}, "binary");
  expectRefused({"info", "far.node"}, "'1?' is no number, an attribute is expected; correct it");
  expectRefused({"info", "escape.node"}, "'?[2J?[31m' is no number");
}

TEST_F(HostileText, DecimalCommas) {
  tell(
      "commas separate numbers in these files; a writer with a German locale wrote 0,5 for 0.5, and x, y, z became 0, "
      "5, "
      "0 without a word",
      "a line with more numbers than its header has columns, some joined by commas and some by blanks, is refused");
  writeTetgenMesh(folder, "german", "4 3 0 0\n0 0,0 0,0 0,0\n1 1,5 0,0 0,0\n2 0,0 1,5 0,0\n3 0,0 0,0 1,5\n",
                  "1 4 0\n0 0 1 2 3\n");
  folder.write("german.inp",
               "4 1 0 0 0\n1 0,0 0,0 0,0\n2 1,5 0,0 0,0\n3 0,0 1,5 0,0\n4 0,0 0,0 1,5\n1 0 tet 1 2 3 4\n");
  writeTetgenMesh(folder, "commas", "4,3,0,0\n0,0,0,0\n1,1,0,0\n2, 0, 1, 0\n3, 0, 0, 1\n", "1,4,0\n0,0,1,2,3\n");
  expectRefused({"info", "german.node"},
                "german.node:2: the line holds more than its numbers, some of them joined by commas");
  expectRefused({"info", "german.inp"}, "german.inp:2");
  expectAtMost("status of a file with commas between all", havs({"info", "commas.node"}).status, 0);
}

TEST_F(HostileText, LineEndsAndByteOrderMarksOfOtherSystems) {
  tell("a byte order mark made the first count no number",
       "the mark is passed over and carriage returns separate: the same mesh, to the last digit of its report");
  const auto windows = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    return "\xef\xbb\xbf" + text;
  };
  TemporaryFolder other;
  writeTetgenMesh(folder, "windows", windows(kCubeNode), windows(kCubeEle));
  const HostileRun plain = havs({"info", "cube.node", "--json"});
  HostileRun marked = havs({"info", "windows.node", "--json"});
  EXPECT_EQ(marked.status, 0) << marked.error;
  for (std::size_t at; (at = marked.output.find("windows.")) != std::string::npos;)
    marked.output.replace(at, 8, "cube.");
  EXPECT_EQ(marked.output, plain.output);
  expectAtMost("reports that differ", marked.output == plain.output ? 0 : 1, 0);
}

TEST_F(HostileText, FilesThatAreNone) {
  tell("a scene file of a device or of gigabytes was read to its end, which it may not have",
       "scenes, cameras and transfer functions are regular files of 64 MiB at most");
  std::filesystem::create_symlink("/dev/zero", folder / "endless.json");
  folder.write("large.json", "");
  std::filesystem::resize_file(folder / "large.json", std::uintmax_t{1} << 40);
  for (const char* name : {"endless.json", "large.json"}) {
    expectRefused({"render", name, "-o", "a.png"}, name);
    expectRefused({"render", "cube.node", "--tf", name, "-o", "a.png"}, name);
  }
  expectRefused({"render", "cube.node", "--camera", "large.json", "-o", "a.png"}, "large.json");
}

}  // namespace
}  // namespace havs::test
