#include "hard/random_check.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "core/error.h"
#include "hard/random_rays.h"
#include "image/native_scene.h"
#include "reference/edge_mask.h"
#include "reference/reference_renderer.h"
#include "render/make_renderer.h"
#include "render/modes.h"
#include "scene/eye_cut.h"

namespace havs::test {
namespace {

/// Distances and scalars are of order 1 and go through some roundings to float, 2^-24 each. The k-buffer lets two
/// fragments change places that are 1e-6 apart or less (docs/02-method.md, Late fragments).
constexpr double kRounding = 4 * 0x1p-24, kTogether = 1e-6 + kRounding;
/// Places are relative to the first pixel of a block of 64 x 64 or nearer, and rounded to float some times.
constexpr double kPlace = 64 * kRounding;
/// Pixels: less than float tells, more than double's rounding in views of up to 1e6 pixels; and of it a part, as the
/// fill rule shifts a ray first along x.
constexpr double kHair = 1e-7, kAside = 1e-2;
/// Of errors: what lies beyond is another kind of failure.
constexpr double kFar = 1e-2;

bool composites(const Scene& scene) { return mode(scene.mode).gathering == Gathering::composite; }

/// Whether what is drawn has no error but rounding. Modes without an order have more on the native device, which knows
/// a cell by its planes in float: at the silhouette of one so thin that float takes a ray's way through it for none,
/// nothing is shown of what the truth has (up to 1 in `average`, 0.009 seen in `emission`), or the other way round.
bool isExact(const Scene& scene) {
  return (scene.lookup == "exact" || !usesLookup(mode(scene.mode))) && composites(scene);
}

/// "" or the first number that is none of [0, 1]; of composites, a colour above the opacity. The lookup `integral`
/// leaves out that a segment attenuates its own light, so its light is bounded by 1 alone (docs/02-method.md).
std::string notInRange(const Image& image, const Scene& scene) {
  if (composites(scene) && scene.lookup != "integral") return notAPicture(image);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (!(image.rgba[i] >= 0 && image.rgba[i] <= 1 + 1e-6f))
      return fmt::format("channel {} of pixel {} is {}", i % 4, i / 4, image.rgba[i]);
  return "";
}

/// The same view through places of the picture that lie a little aside, in pixels.
View shifted(View view, double x, double y) {
  const Vec3 by = 2 * x / view.width * view.halfWidth * view.right - 2 * y / view.height * view.halfHeight * view.up;
  if (view.orthographic || view.center != view.eye) {  // rays of a far eye are known by where they are at the center
    const Vec3 there = (view.orthographic ? 1.0 : view.depth(view.center) - view.depth(view.eye)) * by;
    view.center += there;
    view.eye += there;
    return view;
  }
  view.forward = normalize(view.forward + by);
  view.right = normalize(view.right - dot(view.right, view.forward) * view.forward);
  view.up = cross(view.right, view.forward);
  return view;
}

using Rays = std::function<void(std::size_t pixel, double scale, std::span<const CellSegment> segments)>;

void visitPixels(const PreparedScene& prepared, const View& view, const std::vector<char>& pixels, const Rays& visit) {
  visitRays(prepared, view, [&](int x, int y, std::span<const CellSegment> segments) {
    const auto pixel = static_cast<std::size_t>(x + y * view.width);
    if (pixels[pixel]) visit(pixel, view.rayScale(x + 0.5, y + 0.5), segments);
  });
}

/// By how much each pixel of `hard` may be off: what float may do to its fragments, and what the truth does where the
/// picture's places are rounded, which faces seen nearly edge on magnify.
std::vector<double> effectsAt(const HardPicture& picture, const std::vector<char>& hard) {
  std::vector<double> effects(hard.size());
  const PreparedScene& p = picture.prepared;
  const RayScene scene{p.curve, p.isosurfaces};
  const RayFunction function = mode(picture.scene.mode).reference;
  const bool cut = eyeIsNear(picture.view, kEyeCutInDouble);
  const double cutDepth = picture.view.depth(picture.view.eye) + planeDistance(picture.view, kEyeCutInDouble);
  const auto effectOf = [&](double scale, std::span<const CellSegment> segments) {
    const FragmentErrors errors{kRounding, scale * (cut ? kEyeCutInDouble.distance + kRounding : kRounding),
                                scale * kTogether};
    return floatEffect(scene, function, segments, p.field.centering == Centering::cell, errors);
  };
  visitPixels(p, picture.view, hard, [&](std::size_t pixel, double scale, std::span<const CellSegment> segments) {
    effects[pixel] = effectOf(scale, segments);
    if (cut) effects[pixel] += cutEffect(scene, function, segments, scale * cutDepth);
  });
  // A ray through an edge or a corner meets cells there on no length, which are not in its segments. Devices draw their
  // faces, and float does not tell the order of these. A hair beside the ray some of them have a length.
  std::vector<double> touching(hard.size());
  for (const double x : {-1.0, -kAside, kAside, 1.0})
    for (const double y : {-1.0, -kAside, kAside, 1.0})
      visitPixels(p, shifted(picture.view, kHair * x, kHair * y), hard,
                  [&](std::size_t pixel, double scale, std::span<const CellSegment> segments) {
                    touching[pixel] = std::max(touching[pixel], effectOf(scale, segments));
                  });
  for (std::size_t i = 0; i < effects.size(); ++i) effects[i] = std::max(effects[i], touching[i]);
  for (const auto& [x, y] : std::array<std::array<double, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
    const View view = shifted(picture.view, kPlace * x, kPlace * y);
    visitPixels(p, view, hard, [&](std::size_t pixel, double, std::span<const CellSegment> segments) {
      const RayColor color = function(scene, segments);
      double most = 0;
      for (std::size_t c = 0; c < 4; ++c)
        most = std::max(most, std::abs(color[c] - double{picture.truth.rgba[4 * pixel + c]}));
      effects[pixel] += most;
    });
  }
  return effects;
}

/// Adds to `mask` the pixels of `scene` seen in `view` that are not the truth's.
void addChanged(const HardPicture& picture, const View& view, const RayScene& scene, std::vector<unsigned char>& mask) {
  const std::vector<char> all(mask.size(), 1);
  visitPixels(picture.prepared, view, all, [&](std::size_t pixel, double, std::span<const CellSegment> segments) {
    const RayColor color = mode(picture.scene.mode).reference(scene, segments);
    for (std::size_t c = 0; c < 4; ++c)
      if (std::abs(color[c] - double{picture.truth.rgba[4 * pixel + c]}) > HardBounds{}.traced) mask[pixel] = 1;
  });
}

/// Adds to `mask` the pixels where OpenGL may have met other surfaces than the truth, which PixelTracer does not
/// look for: float does not tell on which side of a surface a scalar lies that is nearer to it, nor which of two faces
/// is first, and the rasteriser's grid moves places by up to 1/256 pixel.
void addBesideSurfaces(const HardPicture& picture, std::vector<unsigned char>& mask) {
  constexpr double kGlLowered = 0x1p-22;  // lookup_resources.cpp
  constexpr double kGrid = 1.0 / 256;
  const PreparedScene& p = picture.prepared;
  const std::vector<double> effects = effectsAt(picture, std::vector<char>(mask.size(), 1));
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (effects[i] > HardBounds{}.traced) mask[i] = 1;
  for (const double by : {-kGlLowered - kRounding, kRounding}) {
    auto surfaces = p.isosurfaces;
    for (auto& surface : surfaces) surface.scalar += by;
    addChanged(picture, picture.view, {p.curve, surfaces}, mask);
  }
  for (const double x : {-kGrid, kGrid})
    for (const double y : {-kGrid, kGrid})
      addChanged(picture, shifted(picture.view, x, y), {p.curve, p.isosurfaces}, mask);
}

std::string placeOf(std::size_t pixel, const Image& image) {
  const auto width = static_cast<std::size_t>(image.width);
  return fmt::format("{},{}", pixel % width, pixel / width);
}

std::string colorsAt(std::size_t pixel, const Image& a, const Image& b) {
  std::string text;
  for (const Image* image : {&a, &b})
    text += fmt::format(" ({:.7f} {:.7f} {:.7f} {:.7f})", image->rgba[4 * pixel], image->rgba[4 * pixel + 1],
                        image->rgba[4 * pixel + 2], image->rgba[4 * pixel + 3]);
  return text;
}

std::string withoutNumbers(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isdigit(c) != 0 || c == '.' || c == '-'; });
  return text;
}

/// Without the middle one of the cells.
TetMesh withoutOneCell(TetMesh mesh) {
  const std::size_t cell = mesh.tetrahedra.size() / 2;
  mesh.tetrahedra.erase(mesh.tetrahedra.begin() + static_cast<std::ptrdiff_t>(cell));
  for (Field& field : mesh.cellFields) field.values.erase(field.values.begin() + static_cast<std::ptrdiff_t>(cell));
  return mesh;
}

/// Whether what is left of a mesh is drawn as it was.
bool sameSettings(const PreparedScene& a, const PreparedScene& b) {
  return a.frame.center == b.frame.center && a.frame.radius == b.frame.radius && a.frame.diagonal == b.frame.diagonal &&
         a.field.minimum == b.field.minimum && a.field.maximum == b.field.maximum;
}

/// With it, fragments of a pixel that is done are not looked at, also where it is done too soon: the certificate of
/// this is of all.
havs::Drawing withoutEarlyTermination(const HardWay& way, const HardPicture& picture) {
  Scene scene = picture.scene;
  scene.earlyTermination = 0;
  return drawIn(way, scene, picture.prepared, picture.view);
}

}  // namespace

std::string kindOf(const std::string& failure) { return failure.substr(0, failure.find(':')); }

/// How far the colour of an opaque surface may be off, as it is taken a little inside of its interval, clear of a step
/// at its end (shaders/opaque_surfaces.glsl).
double colorBesideSteps(const ExtinctionCurve& curve) {
  constexpr double kInside = 0x1p-22;
  double steepest = 0;
  for (std::size_t i = 1; i < curve.knots.size() && !curve.opaque.empty(); ++i) {
    const auto &a = curve.knots[i - 1], &b = curve.knots[i];
    for (std::size_t c = 0; c < 3 && a.s < b.s; ++c)
      steepest = std::max(steepest, std::abs(b.color[c] - a.color[c]) / (b.s - a.s));
  }
  return std::min(1.0, kInside * steepest);
}

std::string CaseChecker::judgeNative(const HardPicture& picture, const HardWay& way, const havs::Drawing& drawing,
                                     bool overlaps) {
  if (const std::string wrong = notInRange(drawing.image, picture.scene); !wrong.empty())
    return "native out of range: " + wrong;
  if (overlaps || !isExact(picture.scene)) return "";
  const double besideSteps = colorBesideSteps(picture.prepared.curve);
  double bound = HardBounds{}.native + besideSteps;
  std::optional<havs::Drawing> whole;
  if (picture.scene.earlyTermination > 0) {
    bound += 1 - picture.scene.earlyTermination;
    whole = withoutEarlyTermination(way, picture);
  }
  std::vector<char> hard(picture.truth.rgba.size() / 4);
  bool any = false;
  for (std::size_t i = 0; i < hard.size(); ++i) {
    if (isLate(whole ? *whole : drawing, i)) {
      ++tally_.late;
      continue;
    }
    ++tally_.pixels;
    const double error = errorAt(drawing.image, picture.truth, i);
    hard[i] = !(error <= bound);
    any = any || hard[i];
    if (!hard[i] && picture.scene.earlyTermination == 0) tally_.native = std::max(tally_.native, error - besideSteps);
  }
  if (!any) return "";
  constexpr double kRoundings =
      4;  // of a fragment's place in two directions, its depth and its scalar; effects are of one
  const std::vector<double> effects = effectsAt(picture, hard);
  for (std::size_t i = 0; i < hard.size(); ++i) {
    if (!hard[i]) continue;
    ++tally_.hard;
    const double error = errorAt(drawing.image, picture.truth, i);
    if (!(error <= bound + kRoundings * effects[i]))
      return fmt::format("native {} the truth: pixel {} is off by {:.3g}, float may move it by {:.3g};{}",
                         error > kFar ? "far from" : "beside", placeOf(i, picture.truth), error, effects[i],
                         colorsAt(i, drawing.image, picture.truth));
  }
  return "";
}

std::string CaseChecker::judgeOpenGl(const HardPicture& picture, const HardWay& way, bool overlaps) {
  const havs::Drawing drawing = drawIn(way, picture.scene, picture.prepared, picture.view);
  ++tally_.openGl;
  if (const std::string wrong = notInRange(drawing.image, picture.scene); !wrong.empty())
    return way.name + " out of range: " + wrong;
  if (way.visibility == "abuffer" && drawing.certificate && drawing.certificate->misordered > 0)
    return "a-buffer misorders: its certificate is not 0";
  const bool traceable = picture.scene.mode == "volume" && picture.scene.lookup == "exact" &&
                         picture.scene.earlyTermination == 0 && !eyeIsNear(picture.view, kEyeCutInFloat);
  if (overlaps || !traceable) return "";
  auto mask = boundaryEdgeMask(picture.prepared.points, picture.prepared.faces, picture.view);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] || isLate(drawing, i)) continue;
    const double error = errorAt(drawing.image, picture.truth, i);
    ++tally_.glPixels;
    tally_.glCoarse += error > HardBounds{}.p999 ? 1 : 0;
    tally_.glTraced += error > HardBounds{}.traced ? 1 : 0;
  }
  std::string first;
  std::size_t without = untraced(picture, drawing, mask, HardBounds{}.traced, first, mask.size());
  if (without > 0 && !(picture.prepared.isosurfaces.empty() && picture.prepared.curve.opaque.empty())) {
    addBesideSurfaces(picture, mask);
    without = untraced(picture, drawing, mask, HardBounds{}.traced, first, mask.size());
  }
  return without == 0 ? ""
                      : fmt::format("{} against the truth: {} pixels without a cause; {}", way.name, without, first);
}

/// What is left of a mesh covers no more than all of it.
std::string CaseChecker::judgeFewerCells(const RandomCase& c, const HardPicture& picture) {
  if (c.mesh.tetrahedra.size() < 2 || picture.scene.mode != "volume") return "";
  StageTimes stages;
  std::optional<PreparedScene> fewer;
  try {
    fewer = prepareScene(picture.scene, withoutOneCell(c.mesh), stages);
  } catch (const Error&) {
    return "";  // the cell was all that there is
  }
  if (!sameSettings(*fewer, picture.prepared)) return "";
  ++tally_.monotone;
  const Image image = makeReference(picture.scene, *fewer)->draw(picture.view, stages).image;
  constexpr float kRounded = 0x1p-22f;  // opacities of double, rounded to float
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] > picture.truth.rgba[i] + kRounded)
      return fmt::format("fewer cells, more opacity: pixel {}:{}", placeOf(i / 4, image),
                         colorsAt(i / 4, image, picture.truth));
  return "";
}

std::string CaseChecker::drawn(const RandomCase& c, const HardWay* openGl) {
  Scene scene = sceneOf(c, folder_.path());
  scene.certificate = composites(scene);
  const HardPicture picture(scene, c.mesh);
  const HardWay native{"native", "native", "native", "kbuffer", scene.sort, scene.k};
  const havs::Drawing drawing = drawIn(native, scene, picture.prepared, picture.view);
  if (const std::string wrong = notInRange(picture.truth, scene); !wrong.empty())
    return "reference out of range: " + wrong;
  std::string failure = judgeNative(picture, native, drawing, c.overlaps);
  if (failure.empty()) {
    scene.instructionSet = "scalar";
    const std::string bits = differenceInBits(drawIn(native, scene, picture.prepared, picture.view), drawing);
    if (!bits.empty()) failure = "lanes: other bits on one lane than on many: " + bits;
  }
  if (failure.empty() && !c.overlaps) failure = judgeFewerCells(c, picture);
  if (failure.empty() && openGl != nullptr) failure = judgeOpenGl(picture, *openGl, c.overlaps);
  return failure;
}

std::string CaseChecker::failureOf(const RandomCase& c, const HardWay* openGl) {
  ++tally_.cases;
  try {
    return drawn(c, openGl);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) return std::string("an error while running: ") + error.what();
    ++tally_.refused;
    ++tally_.refusals[withoutNumbers(error.what())];
  } catch (const std::exception& error) {
    return std::string("an exception: ") + error.what();
  }
  return "";
}

}  // namespace havs::test
