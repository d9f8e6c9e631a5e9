// Scenes drawn in every way, against the reference.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <list>

#include "core/error.h"
#include "hard/hard_case.h"
#include "reference/edge_mask.h"
#include "render/devices.h"
#include "render/make_renderer.h"
#include "support/gl_test.h"
#include "support/pixel_trace.h"
#include "support/temporary_folder.h"

namespace havs::test {

double errorAt(const Image& a, const Image& b, std::size_t pixel) {
  double error = 0;
  for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c) {
    const double difference = std::abs(double{a.rgba[c]} - double{b.rgba[c]});
    if (!(difference <= error)) error = difference;
  }
  return error;
}

bool isLate(const havs::Drawing& drawing, std::size_t pixel) {
  return drawing.certificate && drawing.certificate->count[pixel] > 0;
}

namespace {

/// The current OpenGL context of the process: one is enough, and its programs are slow to make.
const Device& osmesa() {
  static const std::unique_ptr<Device> device = makeTestDevice("osmesa");
  return *device;
}

Scene drawnIn(const HardWay& way, Scene scene) {
  scene.device = way.device;
  scene.visibility = way.visibility;
  scene.sort = way.sort;
  scene.k = way.k;
  return scene;
}

/// Errors of the pixels that count, ascending.
std::vector<double> errorsOf(const havs::Drawing& drawing, const Image& truth, const std::vector<unsigned char>& mask) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.rgba.size() / 4; ++i)
    if ((mask.empty() || !mask[i]) && !isLate(drawing, i)) errors.push_back(errorAt(drawing.image, truth, i));
  std::sort(errors.begin(), errors.end());
  return errors;
}

double percentile999(const std::vector<double>& ascending) {
  if (ascending.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(0.999 * static_cast<double>(ascending.size())));
  return ascending[rank - 1];
}

}  // namespace

havs::Drawing drawIn(const HardWay& way, const Scene& asked, const PreparedScene& prepared, const View& view,
                     const std::function<void(RenderPlan&)>& change) {
  const Scene scene = drawnIn(way, asked);
  StageTimes stages;
  const bool native = way.device == kNativeDevice;
  const Capabilities can = native ? openRenderDevice(kNativeDevice).capabilities : capabilitiesOf(osmesa());
  RenderPlan chosen = plan(scene, prepared.facts(), can);
  if (change) change(chosen);
  return makeRenderer(prepared, chosen, stages)->draw(view, stages);
}

std::size_t untraced(const HardPicture& picture, const havs::Drawing& drawing, const std::vector<unsigned char>& mask,
                     double limit, std::string& first, std::size_t mostTraced) {
  std::size_t beyond = 0, without = 0;
  std::optional<PixelTracer> tracer;
  const auto width = static_cast<std::size_t>(picture.view.width);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] || isLate(drawing, i) || errorAt(drawing.image, picture.truth, i) <= limit) continue;
    if (++beyond > mostTraced) return beyond;
    if (!tracer) tracer.emplace(picture.prepared, picture.view);
    const PixelTrace trace =
        tracer->trace(static_cast<int>(i % width), static_cast<int>(i / width), drawing.image, picture.truth, 0);
    if (trace.cause == Cause::grid || trace.cause == Cause::rounding) continue;
    if (without++ == 0) first = summary(trace) + listOf(trace.exact) + " the rasteriser:\n" + listOf(trace.snapped);
  }
  return without;
}

const std::vector<HardWay>& hardWays() {
  static const std::vector<HardWay> ways = [] {
    std::vector<HardWay> rows;
    for (const auto& [group, device] :
         {std::pair<std::string, std::string>{"native", kNativeDevice}, {"k-buffer", "osmesa"}})
      for (const int k : {2, 6})
        for (const std::string sort : {"topological", "centroid"})
          rows.push_back({fmt::format("{} k {} {}", group, k, sort), group, device, "kbuffer", sort, k});
    rows.push_back({"a-buffer", "a-buffer", "osmesa", "abuffer", "topological", 6});
    return rows;
  }();
  return ways;
}

Scene hardScene(int size) {
  Scene scene;
  scene.lookup = "exact";
  scene.certificate = true;
  scene.width = scene.height = size;
  return scene;
}

const havs::Drawing& HardPicture::by(const std::string& way) const {
  for (const HardDrawing& d : drawings)
    if (d.way.name == way) return d.drawing;
  throw std::invalid_argument("no such way: " + way);
}

std::string notAPicture(const Image& image) {
  constexpr float kRounding = 1e-6f;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const float value = image.rgba[i];
    if (std::isfinite(value) && value >= 0 && value <= 1 + kRounding && value <= image.rgba[i | 3] + kRounding)
      continue;
    const std::size_t pixel = i / 4, width = static_cast<std::size_t>(image.width);
    return fmt::format("channel {} of {},{} is {} (opacity {})", i % 4, pixel % width, pixel / width, value,
                       image.rgba[i | 3]);
  }
  return "";
}

HardPicture::HardPicture(const Scene& asked, const TetMesh& mesh) : scene(asked) {
  StageTimes stages;
  prepared = prepareScene(scene, mesh, stages);
  view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  truth = makeReference(scene, prepared)->draw(view, stages).image;
}

HardPicture HardPictureTest::expectEveryWay(const Scene& scene, const TetMesh& mesh, const HardBounds& bounds) {
  HardPicture picture(scene, mesh);
  expectWays(picture, hardWays(), bounds);
  return picture;
}

void HardPictureTest::expectWays(HardPicture& picture, const std::vector<HardWay>& ways, const HardBounds& bounds) {
  EXPECT_EQ(notAPicture(picture.truth), "") << "the reference";
  const auto mask = boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view);
  for (const HardWay& way : ways) {
    SCOPED_TRACE(way.name);
    picture.drawings.push_back({way, drawIn(way, picture.scene, picture.prepared, picture.view)});
    const havs::Drawing& drawing = picture.drawings.back().drawing;
    EXPECT_EQ(notAPicture(drawing.image), "");
    const bool native = way.device == kNativeDevice;
    const auto errors = errorsOf(drawing, picture.truth, native ? std::vector<unsigned char>{} : mask);
    const double most = errors.empty() ? 0 : errors.back();
    if (bounds.byDistance && (way.sort == "centroid" || way.visibility == "abuffer")) {
      expectAtMost("max of ways by distance only", most, *bounds.byDistance);
    } else if (native) {
      expectAtMost(way.group + " max", most, bounds.native);
    } else {
      expectAtMost(way.group + " p999", percentile999(errors), bounds.p999);
      std::string first;
      if (!bounds.trace) {
        expectAtMost(way.group + " max", most, bounds.traced);
      } else {
        const std::size_t causeless = untraced(picture, drawing, mask, bounds.traced, first);
        expectAtMost(way.group + " pixels off without a cause", static_cast<double>(causeless), 0);
        EXPECT_EQ(causeless, 0u) << first;
      }
    }
    if (!drawing.certificate) continue;
    const bool best = way.k == 6 && way.sort == "topological";
    const std::size_t limit = best ? bounds.late : bounds.lateElsewhere;
    if (limit != ~std::size_t{0})
      expectAtMost("late pixels, " + way.name, static_cast<double>(drawing.certificate->pixels),
                   static_cast<double>(limit));
  }
}

void HardPictureTest::expectRefused(const Scene& scene, const TetMesh& mesh, const std::string& says) {
  std::size_t drawn = 0;
  for (const HardWay& way : hardWays()) {
    SCOPED_TRACE(way.name);
    try {
      StageTimes stages;
      const Scene asked = drawnIn(way, scene);
      checkScene(asked);
      const PreparedScene prepared = prepareScene(asked, mesh, stages);
      drawIn(way, asked, prepared, makeView(asked.camera, prepared.frame, asked.width, asked.height));
      ++drawn;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
  expectAtMost("ways that draw what must be refused", static_cast<double>(drawn), 0);
}

void HardPictureTest::expectSame(const std::string& what, const Image& a, const Image& b, double bound,
                                 const std::vector<unsigned char>& mask) {
  ASSERT_EQ(a.rgba.size(), b.rgba.size());
  double most = 0;
  for (std::size_t i = 0; i < a.rgba.size() / 4; ++i)
    if (mask.empty() || !mask[i]) most = std::max(most, errorAt(a, b, i));
  expectAtMost(what, most, bound);
}

std::string transferFile(const std::string& json) {
  static const TemporaryFolder folder;
  static int count = 0;
  return folder.write(fmt::format("{}.json", count++), json).string();
}

std::string transferOf(const std::vector<std::array<double, 5>>& points, const std::string& meaning, double unitLength,
                       std::optional<std::array<double, 2>> domain) {
  std::string text = fmt::format(R"({{"version": 1, "opacity": "{}")", meaning);
  if (unitLength > 0) text += fmt::format(R"(, "unit_length": {})", unitLength);
  if (domain) text += fmt::format(R"(, "domain": [{}, {}])", (*domain)[0], (*domain)[1]);
  text += R"(, "points": [)";
  for (const auto& [scalar, r, g, b, opacity] : points)
    text += fmt::format(R"({}{{"scalar": {}, "color": [{}, {}, {}], "opacity": {}}})", text.back() == '[' ? "" : ", ",
                        scalar, r, g, b, opacity);
  return text + "]}";
}

}  // namespace havs::test
