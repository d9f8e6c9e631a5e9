#pragma once
// What the hard cases share: a case's row in docs/05-stability.md, and a scene drawn in every way against the truth.
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/compare.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"
#include "scene/renderer.h"

namespace havs::test {

/// What docs/05-stability.md says of a case beside its measures.
struct CaseStory {
  std::string group;    ///< heading of the issue: "Segments", "Cells", ...
  std::string trouble;  ///< what goes wrong: here before it was mended, or in other codes, and why
  std::string remedy;   ///< what is done about it
};

/// A number that a case measures, and what it must not exceed.
struct CaseMeasure {
  std::string what;
  double value = 0;
  double bound = 0;
};

/// A named hard case. Its story and measures become a row of the table of docs/05-stability.md: a test that tells no
/// story or measures nothing fails. Rows are written to hard-cases/ in the build folder.
class HardTest : public testing::Test {
 protected:
  void tell(CaseStory story) { story_ = std::move(story); }
  /// Expects value <= bound (not of a NaN), and makes it a measure of the row; of one `what` the worst stays.
  void expectAtMost(const std::string& what, double value, double bound);
  void TearDown() override;

 private:
  CaseStory story_;
  std::vector<CaseMeasure> measures_;
};

/// How a scene is drawn: a device, a visibility method, k and the order of the faces. Rows of hardWays().
struct HardWay {
  std::string name;   ///< "native k 2 centroid"
  std::string group;  ///< measures are of a group: "native", "k-buffer", "a-buffer"
  std::string device, visibility, sort;
  int k = 6;
};
/// Native and OpenGL's k-buffer, each with k = 2 and 6 and both orders, and the a-buffer.
const std::vector<HardWay>& hardWays();

/// Draws `scene` in one way. `change`: of its plan.
havs::Drawing drawIn(const HardWay& way, const Scene& scene, const PreparedScene& prepared, const View& view,
                     const std::function<void(RenderPlan&)>& change = {});

/// What a picture may differ by from the truth. OpenGL's measures are outside the edge mask, all measures outside the
/// pixels with late fragments, which the certificate counts.
struct HardBounds {
  double native = 1e-5;  ///< maximum: some tens of segments, each off by some 2^-24 of numbers of order 1
  double p999 = 2e-5;    ///< OpenGL: as the project promises (tests/image/accuracy_test.cpp)
  double traced = 2e-4;  ///< OpenGL: pixels beyond it must be the rasteriser's grid or float on faces seen edge on
  /// Of the ways that know distances only (centroid order, a-buffer), their maximum in place of the three above: where
  /// faces lie nearer to each other than floats tell and the scalar jumps between them, either may come first.
  std::optional<double> byDistance;
  bool trace = true;                            ///< false where PixelTracer cannot trace (eye in the mesh, light)
  std::size_t late = 0;                         ///< pixels with late fragments: of k 6, topological
  std::size_t lateElsewhere = ~std::size_t{0};  ///< of the other k-buffers
};

/// One drawing of drawEveryWay.
struct HardDrawing {
  HardWay way;
  havs::Drawing drawing;
};

/// Scenes with lookup `exact` and a certificate, 64 x 64: what is left is the method's own error.
Scene hardScene(int size = 64);

/// A scene in memory, what it was made into, and its truth by the reference.
struct HardPicture {
  HardPicture(const Scene& scene, const TetMesh& mesh);

  Scene scene;
  PreparedScene prepared;
  View view;
  Image truth;
  std::vector<HardDrawing> drawings;  ///< so far

  /// One of them; by name.
  const havs::Drawing& by(const std::string& way) const;
};

/// The worst channel's difference at a pixel; NaN where one is.
double errorAt(const Image& a, const Image& b, std::size_t pixel);
/// Whether the certificate counts late fragments at a pixel.
bool isLate(const havs::Drawing& drawing, std::size_t pixel);
/// How many pixels beyond `limit`, outside the mask and not late, have no cause in the rasteriser (PixelTracer), and
/// what the first of them is. More than `mostTraced` beyond it: their number.
std::size_t untraced(const HardPicture& picture, const havs::Drawing& drawing, const std::vector<unsigned char>& mask,
                     double limit, std::string& first, std::size_t mostTraced = 64);

/// Tests that draw.
class HardPictureTest : public HardTest {
 protected:
  /// Draws in every way and by the reference. Expects of every picture, the truth's too: finite, channels in [0, 1],
  /// no colour above the opacity by more than rounding; and the bounds, as measures of the row.
  HardPicture expectEveryWay(const Scene& scene, const TetMesh& mesh, const HardBounds& bounds = {});
  /// The same in some ways, of what has been made ready already.
  void expectWays(HardPicture& picture, const std::vector<HardWay>& ways, const HardBounds& bounds = {});
  /// Expects that the scene is refused with Error{input} whose text holds `says`.
  void expectRefused(const Scene& scene, const TetMesh& mesh, const std::string& says);
  /// Expects that two pictures differ by at most `bound`, leaving out the pixels of `mask`.
  void expectSame(const std::string& what, const Image& a, const Image& b, double bound,
                  const std::vector<unsigned char>& mask = {});
};

/// Writes a transfer function's JSON to a file that lives as long as the process, and gives its path.
std::string transferFile(const std::string& json);
/// {"version": 1, "opacity": `meaning`, "points": [...]} of rows {scalar, r, g, b, opacity}. `unitLength` 0: default.
std::string transferOf(const std::vector<std::array<double, 5>>& points, const std::string& meaning = "extinction",
                       double unitLength = 1, std::optional<std::array<double, 2>> domain = std::array{0.0, 1.0});

/// Where and how numbers of a picture are no colours: "" or the first place.
std::string notAPicture(const Image& image);

}  // namespace havs::test
