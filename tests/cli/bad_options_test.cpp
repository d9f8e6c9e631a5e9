// Command lines that are wrong whatever the mesh.
#include "cli/refused.h"

namespace havs::test {
namespace {

class BadOption : public RefusedRun {
 protected:
  BadOption() { std::filesystem::create_directory(folder / "folder.png"); }
};

/// havs render cube.node -o a.png, and these.
std::vector<std::string> rendering(std::vector<std::string> options) {
  options.insert(options.begin(), {"render", "cube.node", "-o", "a.png"});
  return options;
}

TEST_P(BadOption, IsRefused) { expectRefused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(CommandLine, BadOption,
                         testing::Values(Refused{"NoCommand", {}, "--help"},
                                         Refused{"UnknownCommand", {"rendr", "cube.node"}, "'render'"},
                                         Refused{"NoInput", {"render"}, "INPUT"},
                                         Refused{"UnknownOption", rendering({"--siez", "64x64"}), "'--size'"},
                                         Refused{"UnknownOptionWithoutInput", {"render", "--siez=64x64"}, "'--size'"},
                                         Refused{"TwoInputs", {"render", "cube.node", "cube.ele"}, "cube.ele"},
                                         Refused{"OptionWithoutValue", {"render", "cube.node", "--k"}, "--k"},
                                         Refused{"MeshWithoutOutput", {"mesh", "cube.node"}, "--output"}),
                         nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Output, BadOption,
    testing::Values(Refused{"MissingFolder", {"render", "cube.node", "-o", "no/a.png"}, "folder does not exist"},
                    Refused{"Unwritable", {"render", "cube.node", "-o", "/proc/a.png"}, "/proc/a.png"},
                    Refused{"IsADirectory", {"render", "cube.node", "-o", "folder.png"}, "directory"},
                    Refused{"UnknownExtension", {"render", "cube.node", "-o", "a.gif"}, ".exr"},
                    Refused{"SecondOfTwo", {"render", "cube.node", "-o", "a.png", "-o", "a.gif"}, "a.gif"},
                    Refused{"CertificateMaskExtension", rendering({"--certificate-mask", "m.gif"}), "m.gif"},
                    Refused{"MeshExtension", {"mesh", "cube.node", "-o", "a.stl"}, ".vtu"},
                    Refused{"MeshFolder", {"mesh", "cube.node", "-o", "no/a.node"}, "folder does not exist"},
                    Refused{"MaskExtension", {"reference", "cube.node", "--edge-mask", "m.exr"}, ".png"},
                    Refused{
                        "MaskFolder", {"reference", "cube.node", "--edge-mask", "no/m.png"}, "folder does not exist"},
                    Refused{"MethodOfTheReference", {"reference", "cube.node", "--lookup", "4d"}, "'3d'"},
                    Refused{"PngBits", rendering({"--png-bits", "12"}), "8 or 16"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Picture, BadOption,
    testing::Values(Refused{"SizeZero", rendering({"--size", "0x64"}), "width"},
                    Refused{"SizeNegative", rendering({"--size", "-64x64"}), "width"},
                    Refused{"SizeOfAMillion", rendering({"--size", "1000000x1000000"}), "width"},
                    Refused{"SizeBeyondAnyInteger", rendering({"--size", "99999999999x1"}), "--size"},
                    Refused{"SizeWithoutHeight", rendering({"--size", "64"}), "WIDTHxHEIGHT"},
                    Refused{"SizeWithMore", rendering({"--size", "64x64x64"}), "WIDTHxHEIGHT"},
                    Refused{"CameraNaN", rendering({"--camera", "nan,20"}), "camera"},
                    Refused{"CameraBrokenJson", rendering({"--camera", R"({"azimuth": })"}), "camera"},
                    Refused{"CameraUnknownKey", rendering({"--camera", R"({"azimut": 1})"}), "azimuth"},
                    Refused{"CameraZoomZero", rendering({"--camera", "0,0,0"}), "zoom"},
                    Refused{"CameraText", rendering({"--camera", "left"}), "left"},
                    Refused{"Projection", rendering({"--projection", "orthografic"}), "'orthographic'"},
                    Refused{"Background", rendering({"--background", "whte"}), "whte"},
                    Refused{"BackgroundOfHalfAGradient", rendering({"--background", "white.."}), "BOTTOM..TOP"},
                    Refused{"BackgroundOfNothingBelow", rendering({"--background", "none..red"}), "BOTTOM..TOP"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Shape, BadOption,
    testing::Values(Refused{"OutlineColor", rendering({"--outline", "color=rde"}), "magenta"},
                    Refused{"OutlineSetting", rendering({"--outline", "with=2"}), "'width'"},
                    Refused{"OutlineWithoutValue", rendering({"--outline", "width"}), "width=VALUE"},
                    Refused{"OutlineEmpty", rendering({"--outline", ""}), "--outline"},
                    Refused{"OutlineWidthZero", rendering({"--outline", "width=0"}), "pixels wide"},
                    Refused{"OutlineWidthNaN", rendering({"--outline", "width=nan"}), "pixels wide"},
                    Refused{"OutlineTooWide", rendering({"--outline", "width=65"}), "64"},
                    Refused{"SurfaceOpacityZero", rendering({"--surface", "opacity=0"}), "opacity"},
                    Refused{"SurfaceOpacityText", rendering({"--surface", "opacity=half"}), "'half'"},
                    Refused{"SurfaceColorBeyondOne", rendering({"--surface", "color=0,0,2"}), "0,0,2"},
                    Refused{"SurfaceShading", rendering({"--surface", "shading=flt"}), "'flat'"},
                    Refused{"WireFrameOpacity", rendering({"--wireframe", "opacity=1.5"}), "opacity"},
                    Refused{"WireFrameAngle", rendering({"--wireframe", "feature_angle=181"}), "180"},
                    Refused{"WireFrameAngleNaN", rendering({"--wireframe", "feature_angle=nan"}), "180"},
                    Refused{"SurfaceInAnUnorderedMode", rendering({"--mode", "maximum", "--surface", "default"}),
                            "volume or isosurfaces"},
                    Refused{"WireFrameInAnUnorderedMode", rendering({"--mode", "xray", "--wireframe", "default"}),
                            "volume or isosurfaces"},
                    Refused{"SurfaceOfCells", rendering({"--visibility", "cells", "--surface", "default"}),
                            "kbuffer or abuffer"},
                    Refused{"OfTheReference", {"reference", "cube.node", "--surface", "opacity=2"}, "opacity"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Light, BadOption,
    testing::Values(
        Refused{"UnknownSetting", rendering({"--lighting", "ambiant=1"}), "'ambient'"},
        Refused{"NoValue", rendering({"--lighting", "ambient"}), "ambient=VALUE"},
        Refused{"NoNumber", rendering({"--lighting", "ambient=much"}), "'much' is no number"},
        Refused{"Negative", rendering({"--lighting", "diffuse=-1"}), "diffuse"},
        Refused{"Shininess", rendering({"--lighting", "shininess=2.5"}), "whole number"},
        Refused{"ShininessTooLarge", rendering({"--lighting", "shininess=2000"}), "shininess"},
        Refused{"LightKind", rendering({"--light", "sun:1,1,1", "--lighting", "default"}), "sun"},
        Refused{"LightPlace", rendering({"--light", "point:1,2", "--lighting", "default"}), "three numbers"},
        Refused{"LightDirection", rendering({"--light", "directional:0,0,0", "--lighting", "default"}), "no direction"},
        Refused{
            "TooManyLights",
            rendering({"--light", "head", "--light", "head", "--light", "head", "--light", "head", "--light", "head"}),
            "at most 4"},
        Refused{"OcclusionRadius", rendering({"--occlusion", "radius=0"}), "radius"},
        Refused{"Albedo", rendering({"--scattering", "albedo=1"}), "albedo"},
        Refused{"ModulationBeyondOne", rendering({"--modulation", "2"}), "modulation"},
        Refused{"LitXray", rendering({"--mode", "xray", "--lighting", "default"}), "knows no light"},
        Refused{"LitColours", rendering({"--lookup", "pre", "--lighting", "default"}), "cannot be lit"},
        Refused{"LitCells", rendering({"--visibility", "cells", "--lighting", "default"}), "kbuffer"},
        Refused{"Mode", rendering({"--mode", "maximun"}), "'maximum'"},
        Refused{"EarlyXray", rendering({"--mode", "xray", "--early-termination", "0.9"}), "end pixels early"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Clipping, BadOption,
    testing::Values(Refused{"PlaneOfFive", rendering({"--clip-plane", "0,0,0,1,0"}), "X,Y,Z,NX,NY,NZ"},
                    Refused{"PlaneOfSeven", rendering({"--clip-plane", "0,0,0,1,0,0,0"}), "X,Y,Z,NX,NY,NZ"},
                    Refused{"PlaneOfText", rendering({"--clip-plane", "x"}), "X,Y,Z,NX,NY,NZ"},
                    Refused{"PlaneWithoutNormal", rendering({"--clip-plane", "0,0,0,0,0,0"}), "normal has no length"},
                    Refused{"PlaneNaN", rendering({"--clip-plane", "nan,0,0,1,0,0"}), "not finite"},
                    Refused{"PlaneInfinite", rendering({"--clip-plane", "0,0,0,inf,0,0"}), "not finite"},
                    Refused{"SecondOfTwoPlanes",
                            rendering({"--clip-plane", "0,0,0,1,0,0", "--clip-plane", "0,0,0,0,0,0"}),
                            "normal has no length"},
                    Refused{"BoxOfFive", rendering({"--clip-box", "0,1,0,1,0"}), "X0,X1,Y0,Y1,Z0,Z1"},
                    Refused{"BoxTurnedOver", rendering({"--clip-box", "1,0,0,1,0,1"}), "lower end"},
                    Refused{"BoxWithoutInside", rendering({"--cut-box", "0,1,0.5,0.5,0,1"}), "--cut-box"},
                    Refused{"ThresholdOfOne", rendering({"--threshold", "1"}), "LOW,HIGH"},
                    Refused{"ThresholdOfText", rendering({"--threshold", "low,high"}), "LOW,HIGH"},
                    Refused{"ThresholdTurnedOver", rendering({"--threshold", "2,1"}), "lower value first"},
                    Refused{"ThresholdNaN", rendering({"--threshold", "0,nan"}), "not finite"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Isosurfaces, BadOption,
    testing::Values(Refused{"ValueIsText", rendering({"--isosurface", "high"}), "VALUE[,COLOR[,OPACITY]]"},
                    Refused{"ValueMissing", rendering({"--isosurface", ",red"}), "VALUE[,COLOR[,OPACITY]]"},
                    Refused{"ValueNaN", rendering({"--isosurface", "nan"}), "no value"},
                    Refused{"ValueOutside", rendering({"--isosurface", "3.5"}), "0 to 3"},
                    Refused{"Color", rendering({"--isosurface", "1,rde"}), "magenta"},
                    Refused{"ColorBeyondOne", rendering({"--isosurface", "1,0,0,2"}), "0,0,2"},
                    Refused{"OpacityWithoutComma", rendering({"--isosurface", "1,0.3"}), "'0.3'"},
                    Refused{"OpacityZero", rendering({"--isosurface", "1,red,0"}), "opacity"},
                    Refused{"OpacityAboveOne", rendering({"--isosurface", "1,,1.5"}), "opacity"},
                    Refused{"OpacityText", rendering({"--isosurface", "1,red,half"}), "'half'"},
                    Refused{"OpacityMissing", rendering({"--isosurface", "1,red,"}), "last comma"},
                    Refused{"TooMany", rendering({"--isosurface", "1,0,0,0,1,1"}), "VALUE[,COLOR[,OPACITY]]"},
                    Refused{"AloneWithout", rendering({"--mode", "isosurfaces"}), "--isosurface VALUE"},
                    Refused{"InAnUnorderedMode", rendering({"--mode", "maximum", "--isosurface", "1"}),
                            "volume or isosurfaces"},
                    Refused{"OfColours", rendering({"--lookup", "pre", "--isosurface", "1"}), "another --lookup"},
                    Refused{"OfCells", rendering({"--field", "cell:region", "--isosurface", "1"}), "--field"},
                    Refused{"OfTheReference", {"reference", "cube.node", "--isosurface", "4"}, "0 to 3"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Method, BadOption,
    testing::Values(Refused{"Device", rendering({"--device", "osmsa"}), "'osmesa'"},
                    Refused{"Sort", rendering({"--sort", "centriod"}), "'centroid'"},
                    Refused{"Lookup", rendering({"--lookup", "pst"}), "'post'"},
                    Refused{"LookupNumberMissing", rendering({"--lookup", "riemann"}), "riemann:8"},
                    Refused{"LookupNumberText", rendering({"--lookup", "riemann:n"}), "riemann:8"},
                    Refused{"LookupNumberZero", rendering({"--lookup", "riemann:0"}), "1 to 256"},
                    Refused{"LookupNumberLarge", rendering({"--lookup", "riemann-linear:257"}), "1 to 256"},
                    Refused{"LookupNumberHuge", rendering({"--lookup", "riemann:99999999999"}), "1 to 256"},
                    Refused{"LookupNumberNegative", rendering({"--lookup", "riemann:-3"}), "1 to 256"},
                    Refused{"LookupNumberWithMore", rendering({"--lookup", "riemann:8x"}), "riemann:8"},
                    Refused{"LookupNumberUnasked", rendering({"--lookup", "post:3"}), "takes no number"},
                    Refused{"LookupWithNumber", rendering({"--lookup", "rieman:3"}), "'riemann:n'"},
                    Refused{"Table2dTooLarge", rendering({"--lookup", "2d", "--table", "2049"}), "between 2 and 2048"},
                    Refused{"Visibility", rendering({"--visibility", "kbufer"}), "'kbuffer'"},
                    Refused{"TableFormat", rendering({"--table-format", "rgba9"}), "'rgba8'"},
                    Refused{"KZero", rendering({"--k", "0"}), "between 1 and 14"},
                    Refused{"KFifteen", rendering({"--k", "15"}), "between 1 and 14"},
                    Refused{"KEightOfColours", rendering({"--lookup", "pre", "--k", "8"}), "between 1 and 7"},
                    Refused{"KText", rendering({"--k", "six"}), "--k"},
                    Refused{"KNearlyAuto", rendering({"--k", "automatic"}), "auto"},
                    Refused{"KWithMore", rendering({"--k", "6x"}), "--k"},
                    Refused{"TargetFormat", rendering({"--target-format", "16"}), "'16f'"},
                    Refused{"TableOne", rendering({"--table", "1"}), "between 2 and 512"},
                    Refused{"TableOfAMillion", rendering({"--table", "1000000"}), "between 2 and 512"},
                    Refused{"CellsEarlyTermination", rendering({"--visibility", "cells", "--early-termination", "0.9"}),
                            "kbuffer or abuffer"},
                    Refused{"CellsCompositeLate", rendering({"--visibility", "cells", "--composite-late"}), "kbuffer"},
                    Refused{"ABufferCompositeLate", rendering({"--visibility", "abuffer", "--composite-late"}),
                            "kbuffer"},
                    Refused{"EarlyTermination", rendering({"--early-termination", "1.5"}), "between 0 and 1"},
                    Refused{"EarlyTerminationNaN", rendering({"--early-termination", "nan"}), "between 0 and 1"},
                    Refused{"Threads", rendering({"--threads", "-1"}), "--threads"},
                    Refused{"Repeat", rendering({"--repeat", "0"}), "repeat"},
                    Refused{"UnitLengthZero", rendering({"--unit-length", "0"}), "unit length"},
                    Refused{"UnitLengthNaN", rendering({"--unit-length", "nan"}), "unit length"},
                    Refused{"DomainReversed", rendering({"--domain", "2,1"}), "domain"},
                    Refused{"DomainInfinite", rendering({"--domain", "0,inf"}), "finite"},
                    Refused{"DomainOneNumber", rendering({"--domain", "2"}), "LOW,HIGH"}),
    nameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Native, BadOption,
    testing::Values(Refused{"ABuffer", rendering({"--device", "native", "--visibility", "abuffer"}), "kbuffer"},
                    Refused{"Cells", rendering({"--device", "native", "--visibility", "cells"}), "kbuffer"},
                    Refused{"HalfTargets", rendering({"--device", "native", "--target-format", "16f"}), "32-bit"},
                    Refused{"UnknownInstructionSet", rendering({"--device", "native", "--simd", "nonsense"}),
                            "nonsense"},
                    Refused{"NearInstructionSet", rendering({"--device", "native", "--simd", "avx22"}), "'avx2'"},
                    Refused{"KTooLarge", rendering({"--device", "native", "--k", "15"}), "14"}),
    nameOfCase);

}  // namespace
}  // namespace havs::test
