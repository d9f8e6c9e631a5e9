// Every kind of bad transfer-function file is refused with status 2 and a message that says what and where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "core/error.h"
#include "transfer/transfer_function.h"
#include "unit/transfer/temporary_file.h"

namespace havs {
namespace {

struct BadFile {
  std::string label;
  std::string name;
  std::string content;
  std::vector<std::string> told;  // parts of the message
};

void PrintTo(const BadFile& file, std::ostream* out) { *out << file.label; }

/// A transfer function with the given members before, and the given points after a valid first one at scalar 0.1.
std::string json(const std::string& members, const std::string& points) {
  return "{" + members + R"("points": [{"scalar": 0.1, "color": [1, 0, 0], "opacity": 0})" + points + "]}";
}
const std::string kVersion = R"("version": 1, )";
std::string point(const std::string& scalar, const std::string& color, const std::string& opacity) {
  return R"(, {"scalar": )" + scalar + R"(, "color": )" + color + R"(, "opacity": )" + opacity + "}";
}

std::string tableBytes(float replaced) {
  std::vector<float> values(65536 * 4, 0.5F);
  values[4 * 777 + 1] = replaced;
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

const std::vector<BadFile> kBadFiles{
    {"empty", "f.json", "", {"is empty"}},
    {"truncated", "f.json", R"({"version": 1,)", {"line 1", "no valid JSON"}},
    {"notJson", "f.txt", "hello", {"no valid JSON"}},
    {"list", "f.json", "[]", {"holds 0 colour maps"}},
    {"number", "f.json", "7", {"is a JSON object"}},
    {"noVersion", "f.json", json("", ""), {"'version' is missing"}},
    {"laterVersion", "f.json", json(R"("version": 2, )", ""), {"version 2"}},
    {"deeplyNested",
     "f.json",
     R"({"version": )" + std::string(300000, '[') + std::string(300000, ']') + "}",
     {"100 deep"}},
    {"deepList", "p.json", std::string(300000, '[') + std::string(300000, ']'), {"100 deep"}},
    {"unknownKey", "f.json", json(kVersion + R"("opacty": "per_unit", )", ""), {"'opacty'", "'opacity'"}},
    {"unknownPointKey", "f.json", json(kVersion, R"(, {"scaler": 1})"), {"'scaler'", "'scalar'", "point 2"}},
    {"unknownMeaning", "f.json", json(kVersion + R"("opacity": "per-unit", )", ""), {"'per-unit'", "'per_unit'"}},
    {"unknownScale", "f.json", json(kVersion + R"("scale": "normalized", )", ""), {"'normalised'"}},
    {"noPoints", "f.json", R"({"version": 1, "points": []})", {"at least one control point"}},
    {"missingOpacity",
     "f.json",
     json(kVersion, R"(, {"scalar": 1, "color": [0, 0, 0]})"),
     {"'opacity' is missing", "point 2"}},
    {"unsorted",
     "f.json",
     json(kVersion, point("0.6", "[0, 0, 0]", "0") + point("0.5", "[0, 0, 0]", "0")),
     {"0.5 comes after 0.6", "point 3"}},
    {"thrice",
     "f.json",
     json(kVersion, point("0.1", "[0, 0, 0]", "0") + point("0.1", "[0, 0, 0]", "0")),
     {"third time", "point 3"}},
    {"nan", "f.json", json(kVersion, point("NaN", "[0, 0, 0]", "0")), {"no valid JSON", "line 1"}},
    {"overflow", "f.json", json(kVersion, point("1e999", "[0, 0, 0]", "0")), {"1e999"}},
    {"text", "f.json", json(kVersion, point("\"half\"", "[0, 0, 0]", "0")), {"'scalar' is no number", "point 2"}},
    {"opacityAboveOne",
     "f.json",
     json(kVersion, point("1", "[0, 0, 0]", "1.5")),
     {"opacity 1.5", "point 2", "extinction"}},
    {"negativeOpacity",
     "f.json",
     json(kVersion + R"("opacity": "extinction", )", point("1", "[0, 0, 0]", "-1")),
     {"opacity -1", "point 2"}},
    {"colorRange", "f.json", json(kVersion, point("1", "[0, 255, 0]", "0")), {"colour 255", "point 2"}},
    {"colorLength", "f.json", json(kVersion, point("1", "[0, 0]", "0")), {"list of three numbers", "point 2"}},
    {"scalarRange",
     "f.json",
     json(kVersion, point("37.5", "[0, 0, 0]", "0")),
     {"37.5", "point 2", "\"scale\": \"data\""}},
    {"domainReversed", "f.json", json(kVersion + R"("domain": [2, 1], )", ""), {"domain [2, 1] is empty"}},
    {"domainLength", "f.json", json(kVersion + R"("domain": [2], )", ""), {"list of two numbers"}},
    {"unitLengthZero", "f.json", json(kVersion + R"("unit_length": 0, )", ""), {"unit_length 0 is not positive"}},
    {"tableSize", "TF.bin", std::string(1000, 'x'), {"1000 bytes", "1048576"}},
    {"tableNan", "TF.bin", tableBytes(std::numeric_limits<float>::quiet_NaN()), {"nan", "entry 777"}},
    {"tableRange", "table.raw", tableBytes(2), {"value 2", "entry 777"}},
    {"twoMaps", "p.json", R"([{"RGBPoints": []}, {"RGBPoints": []}])", {"holds 2 colour maps"}},
    {"colorSpace", "p.json", R"([{"ColorSpace": "Munsell", "RGBPoints": [0, 0, 0, 0]}])", {"'Munsell'", "Diverging"}},
    {"indexed", "p.json", R"([{"IndexedColors": [0, 0, 0]}])", {"no colours", "IndexedColors"}},
    {"rgbCount", "p.json", R"([{"RGBPoints": [0, 0, 0, 0, 1]}])", {"'RGBPoints'", "4 numbers"}},
    {"rgbText", "p.json", R"([{"RGBPoints": [0, 0, 0, 0, 1, "x", 0, 0]}])", {"no number", "point 2"}},
    {"midpoint", "p.json", R"([{"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "Points": [0, 0, 7, 0]}])", {"opacity point 1"}},
    {"oneScalar", "p.json", R"([{"RGBPoints": [0.3, 0, 0, 0]}])", {"one scalar"}},
    {"xmlBroken", "p.xml", "<ColorMaps><ColorMap>", {"no valid XML"}},
    {"xmlOther", "p.xml", "<svg/>", {"no <ColorMap>"}},
    {"xmlNumber",
     "p.xml",
     R"(<ColorMap space="RGB"><Point x="0" o="0" r="a" g="0" b="0"/></ColorMap>)",
     {"'r' is 'a'", "point 1"}},
    {"xmlMissing", "p.xml", R"(<ColorMap><Point x="0" r="0" b="0"/></ColorMap>)", {"'g' is ''"}},
};

std::string messageFor(const std::string& presetOrFile) {
  try {
    loadTransferFunction(presetOrFile);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitStatus(), 2);
    return error.what();
  }
  return "accepted";
}

class BadTransferFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadTransferFile, IsRefused) {
  const test::TemporaryFile file(GetParam().name, GetParam().content);
  const std::string message = messageFor(file.path());
  EXPECT_THAT(message, testing::HasSubstr(GetParam().name));
  for (const std::string& part : GetParam().told) EXPECT_THAT(message, testing::HasSubstr(part));
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(Kinds, BadTransferFile, testing::ValuesIn(kBadFiles),
                         [](const auto& test) { return test.param.label; });

TEST(BadTransferName, NamesTheNearestPreset) {
  EXPECT_THAT(messageFor("rainbw"), testing::AllOf(testing::HasSubstr("rainbw"), testing::HasSubstr("'rainbow'")));
  EXPECT_THAT(messageFor("no/such.json"), testing::HasSubstr("no such file"));
  EXPECT_THAT(messageFor(testing::TempDir()), testing::HasSubstr("is a directory"));
}

TEST(BadTransferFile, TruncatedAnywhereNeverCrashes) {
  const std::string whole = toJson(loadTransferFunction("three-peaks"));
  for (std::size_t length = 1; length + 2 < whole.size(); length += 7) {
    const test::TemporaryFile file("f.json", whole.substr(0, length));
    EXPECT_NE(messageFor(file.path()), "accepted");
  }
}

}  // namespace
}  // namespace havs
