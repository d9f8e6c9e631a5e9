// Pictures that cannot be compared, and options of havs compare that are wrong.
#include <limits>

#include "cli/refused.h"
#include "image/image.h"

namespace havs::test {
namespace {

class BadCompare : public RefusedRun {
 protected:
  BadCompare() {
    Image image{4, 4, std::vector<float>(4 * 16, 0.25f)};
    std::fill_n(image.pixel(0, 0), 4, 0.0f);
    for (const char* name : {"a.exr", "a.pfm", "a.png"}) writeImage(image, folder / name);
    image.pixel(1, 2)[1] = std::numeric_limits<float>::quiet_NaN();
    writeImage(image, folder / "nan.exr");
    writeImage(Image{4, 4, std::vector<float>(4 * 16, 1.0f)}, folder / "full.exr");
    writeImage(Image{3, 4, std::vector<float>(4 * 12, 0.25f)}, folder / "narrow.exr");
    folder.write("broken.exr", "no picture");
  }
};

/// havs compare a.exr a.exr and these.
std::vector<std::string> comparing(std::vector<std::string> options) {
  options.insert(options.begin(), {"compare", "a.exr", "a.exr"});
  return options;
}

TEST_P(BadCompare, IsRefused) { expectRefused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Pictures, BadCompare,
    testing::Values(Refused{"One", {"compare", "a.exr"}, "B is required"},
                    Refused{"Missing", {"compare", "a.exr", "b.exr"}, "b.exr: no such file"},
                    Refused{"Broken", {"compare", "a.exr", "broken.exr"}, "broken.exr"},
                    Refused{"Format", {"compare", "a.exr", "cube.node"}, "use .png, .exr or .pfm"},
                    Refused{"Size", {"compare", "a.exr", "narrow.exr"}, "4 x 4 against 3 x 4"},
                    Refused{"PngAgainstExr", {"compare", "a.png", "a.exr"}, "a.png: holds colours over a background"},
                    Refused{"ExrAgainstPfm", {"compare", "a.exr", "a.pfm"}, "a.pfm: holds colours over a background"},
                    Refused{"OpaqueAgainstEmpty", {"compare", "full.exr", "a.exr"}, "opaque in every pixel"},
                    Refused{"NaN", {"compare", "nan.exr", "a.exr"}, "nan.exr: pixel 1,2 has the value nan in green"},
                    Refused{"NaNInTheTruth", {"compare", "a.exr", "nan.exr"}, "nan.exr: pixel 1,2"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Options, BadCompare,
    testing::Values(Refused{"MaskSize", comparing({"--mask", "narrow.exr"}), "3 x 4"},
                    Refused{"MaskOfAll", comparing({"--mask", "full.exr"}), "leaves no pixel"},
                    Refused{"MaskMissing", comparing({"--mask", "b.png"}), "b.png"},
                    Refused{"DifferenceFormat", comparing({"--difference", "d.gif"}), ".png"},
                    Refused{"DifferenceFolder", comparing({"--difference", "no/d.png"}), "folder does not exist"},
                    Refused{"Scale", comparing({"--scale", "logarithm"}), "use log or linear"},
                    Refused{"MaxZero", comparing({"--max", "0"}), "--max"},
                    Refused{"MaxNaN", comparing({"--max", "nan"}), "--max"},
                    Refused{"MaxText", comparing({"--max", "big"}), "--max"},
                    Refused{"Channel", comparing({"--channel", "alpha"}), "opacity"},
                    Refused{"NoSuchChannel",
                            {"compare", "a.pfm", "a.pfm", "--channel", "opacity", "--difference", "d.png"},
                            "no opacity"},
                    Refused{"LimitName", comparing({"--limit", "rsme=1"}), "'rmse'"},
                    Refused{"LimitValue", comparing({"--limit", "rmse=small"}), "not a number"},
                    Refused{"LimitAlone", comparing({"--limit", "rmse"}), "MEASURE=VALUE"},
                    Refused{"UnknownOption", comparing({"--maks", "a.exr"}), "--mask"}),
    nameOfCase);

}  // namespace
}  // namespace havs::test
