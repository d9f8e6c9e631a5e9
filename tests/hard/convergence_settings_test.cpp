// What converges besides the mesh: tables, samples, the resampled extinction, modes, a domain's ends.
#include <map>

#include "hard/orders.h"
#include "reference/reference_renderer.h"
#include "render/lookups.h"
#include "transfer/preintegration.h"

namespace havs::test {
namespace {

using ConvergenceOfSettings = Convergence;

TEST_F(ConvergenceOfSettings, TableSize) {
  tell({"Convergence",
        "on one mesh, what a table costs: entries are interpolated linearly, over scalars and over length",
        "by second derivatives times N^-2: order -2 in the entries along an axis, for each lookup that reads a table"});
  const HardPicture picture(smoothScene(16), withSmooth(box(3)));
  const std::vector<double> sizes{8, 16, 32, 64};
  for (const Lookup& row : lookups()) {
    if (tableOf(row) == nullptr) continue;
    const auto drawn = [&](int size) {
      Scene asked = picture.scene;
      asked.lookup = row.name;
      asked.tableSize = size;
      return drawIn(kNative, asked, picture.prepared, picture.view).image;
    };
    // A 2D table is of one length, which is another error: it is compared with itself, very large.
    const auto truth = pixelsOf(tableOf(row)->axes == 2 ? drawn(1024) : picture.truth);
    std::vector<Norms> norms;
    for (const double size : sizes) norms.push_back(normsOf(drawn(static_cast<int>(size)), truth));
    expectOrders({row.name, -2, false, true, false}, sizes, norms);
  }
}

TEST_F(ConvergenceOfSettings, SamplesOfASegment) {
  tell({"Convergence", "a scalar that crosses the transfer function within one cell is sampled n times",
        "order -2 in n with opacity 1 - exp(-kappa h), -1 where opacity is kappa h"});
  const HardPicture picture(smoothScene(16), withSmooth(box(2)));
  const std::vector<double> samples{2, 4, 8, 16};
  for (const auto& [name, order] : {std::pair{"riemann", -2}, {"riemann-linear", -1}}) {
    std::vector<Norms> norms;
    for (const double n : samples) {
      Scene asked = picture.scene;
      asked.lookup = fmt::format("{}:{:g}", name, n);
      norms.push_back(normsOf(drawIn(kNative, asked, picture.prepared, picture.view).image, pixelsOf(picture.truth)));
    }
    expectOrders({name, static_cast<double>(order)}, samples, norms);
  }
}

TEST_F(ConvergenceOfSettings, ResampledExtinction) {
  tell({"Convergence",
        "opacity per unit length makes extinction a logarithm, not a line: it is resampled within a tolerance",
        "pictures are off by the tolerance times depth exp(-depth), at most tolerance / e, and fall with it: order 1"});
  Scene scene = hardScene(16);
  const double unit = 0.7;
  scene.transferFunction =
      transferFile(transferOf({{0, 0.9, 0.5, 0.2, 0.05}, {1, 0.9, 0.5, 0.2, 0.95}}, "per_unit", unit));
  const auto scalar = [](const Vec3& p) { return 0.5 + 0.1 * p.x + 0.2 * p.y - 0.15 * p.z; };
  TetMesh mesh = box(1);
  mesh.pointFields = {Field{"s", 1, pointValues(mesh.points, scalar)}};
  HardPicture picture(scene, mesh);
  const auto truth = seen(picture, boxRay, [&](const BodyRay& ray) {
    return quadrature(
        [&](double t) {
          return std::array{0.9, 0.5, 0.2, -std::log1p(-(0.05 + 0.9 * scalar(ray.at(t)))) / unit};
        },
        ray.first, ray.last);
  });
  const TransferFunction function = loadTransferFunction(scene.transferFunction);
  const std::vector<double> tolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5};
  std::vector<Norms> norms;
  for (const double tolerance : tolerances) {
    picture.prepared.curve = makeCurve(function, {.radius = picture.prepared.frame.radius, .tolerance = tolerance});
    norms.push_back(normsOf(referencePixels(picture.prepared, picture.view), truth));
    expectAtMost("most error over tolerance", norms.back().most / tolerance, std::exp(-1.0));
  }
  expectOrders({"tolerance", 1}, tolerances, norms);
}

TEST_F(ConvergenceOfSettings, LinearFieldOnAnyMesh) {
  tell({"Convergence",
        "a field that is linear in space is exact on every mesh: an error that grows as cells shrink is the method's "
        "own",
        "against one integral over the whole chord: no more than float's rounding, however many segments a ray is cut "
        "into"});
  Scene scene = hardScene(16);
  scene.transferFunction = transferFile(transferOf(
      {{0, 0.2, 0.4, 0.8, 0.3}, {0.4, 0.9, 0.2, 0.1, 1.5}, {0.4, 0.1, 0.6, 0.9, 0.2}, {1, 0.9, 0.5, 0.1, 0.9}}));
  const auto scalar = [](const Vec3& p) { return 0.5 + 0.1 * p.x + 0.2 * p.y - 0.15 * p.z; };
  for (const int n : {1, 2, 4, 8, 16}) {
    TetMesh mesh = box(n, Cut::six, n > 1 ? 0.2 : 0.0, 3);
    mesh.pointFields = {Field{"s", 1, pointValues(mesh.points, scalar)}};
    const HardPicture picture(scene, mesh);
    const double radius = picture.prepared.frame.radius;
    const auto truth = seen(picture, boxRay, [&](const BodyRay& ray) {
      if (!(ray.first < ray.last)) return RayColor{0, 0, 0, 0};
      const SegmentColor c = integrateSegment(picture.prepared.curve, scalar(ray.at(ray.first)),
                                              scalar(ray.at(ray.last)), (ray.last - ray.first) / radius);
      return RayColor{c.color[0], c.color[1], c.color[2], c.alpha};
    });
    expectAtMost("reference max", normsOf(picture.truth, truth).most, 1e-7);  // rounded to float
    // Up to 100 segments a ray; a scalar that is off by 2^-24 next to the step shifts it by as much of its slope.
    expectAtMost("native max", normsOf(drawIn(kNative, scene, picture.prepared, picture.view).image, truth).most, 1e-5);
  }
}

/// What rays see in the modes that need no order, of the smooth field.
struct SeenInMode {
  std::string mode;
  SeenBy by;
};
RayColor colorAt(double s) {
  const auto color = smoothTransfer(s);
  return {color[0], color[1], color[2], 1};
}
/// Of the extreme scalar on the ray: the best of many places, and of the parabola through its neighbours.
RayColor extreme(const BodyRay& ray, double sign) {
  constexpr int kPlaces = 400;
  if (!(ray.first < ray.last)) return {0, 0, 0, 0};
  const auto at = [&](int i) { return sign * smoothScalar(ray.at(ray.first + (ray.last - ray.first) * i / kPlaces)); };
  int best = 0;
  for (int i = 1; i <= kPlaces; ++i)
    if (at(i) > at(best)) best = i;
  double most = at(best);
  if (best > 0 && best < kPlaces) {
    const double slope = (at(best + 1) - at(best - 1)) / 2, bend = at(best + 1) - 2 * most + at(best - 1);
    most -= bend < 0 ? slope * slope / (2 * bend) : 0;
  }
  return colorAt(sign * most);
}
std::vector<SeenInMode> seenInModes(double unitLength) {
  const auto sumAlong = [](const BodyRay& ray, const std::function<double(double t)>& f) {
    long double sum = 0;
    for (int p = 0; p < 4 && ray.first < ray.last; ++p)
      sum +=
          kronrod15([&](long double t) -> long double { return f(static_cast<double>(t)); },
                    ray.first + (ray.last - ray.first) * p / 4.0L, ray.first + (ray.last - ray.first) * (p + 1) / 4.0L);
    return static_cast<double>(sum);
  };
  const auto along = [](const BodyRay& ray, double t) { return smoothTransfer(smoothScalar(ray.at(t))); };
  return {{"xray",
           [=](const BodyRay& ray) {
             const double depth = sumAlong(ray, [&](double t) { return along(ray, t)[3]; });
             return RayColor{0, 0, 0, -std::expm1(-depth / unitLength)};
           }},
          {"emission",
           [=](const BodyRay& ray) {
             RayColor light{0, 0, 0, 0};
             for (std::size_t c = 0; c < 3; ++c)
               light[c] = sumAlong(ray, [&](double t) { return along(ray, t)[c] * along(ray, t)[3]; }) / unitLength;
             return light;
           }},
          {"maximum", [](const BodyRay& ray) { return extreme(ray, 1); }},
          {"minimum", [](const BodyRay& ray) { return extreme(ray, -1); }},
          {"average", [=](const BodyRay& ray) {
             if (!(ray.first < ray.last)) return RayColor{0, 0, 0, 0};
             const double sum = sumAlong(ray, [&](double t) { return smoothScalar(ray.at(t)); });
             return colorAt(sum / (ray.last - ray.first));
           }}};
}

TEST_F(ConvergenceOfSettings, Modes) {
  tell({"Convergence", "modes that sum, average or take an extreme see the field that is linear in cells, too",
        "sums and means are of order 2; so are extremes, which a smooth field takes within h^2 of a corner's value"});
  constexpr double kUnitLength = 8;  // light sums up to less than 1: nothing is cut off
  const std::vector<int> meshes{4, 8, 16, 32};
  Scene scene = smoothScene(16);
  scene.certificate = false;
  scene.unitLength = kUnitLength;
  std::map<std::string, std::vector<Norms>> norms;
  const auto modes = seenInModes(kUnitLength);
  for (const int n : meshes) {
    HardPicture picture(scene, withSmooth(box(n)));
    for (const SeenInMode& m : modes) {
      Scene asked = scene;
      asked.mode = m.mode;
      norms[m.mode].push_back(
          normsOf(drawIn(kNative, asked, picture.prepared, picture.view).image, seen(picture, boxRay, m.by)));
    }
  }
  for (const SeenInMode& m : modes) expectOrders({m.mode, 2, false, true, false}, widths(meshes), norms[m.mode]);
}

TEST_F(ConvergenceOfSettings, DomainThatEndsWithinTheData) {
  tell({"Convergence",
        "scalars are cut off at the domain's ends at the points, so that cells across an end are not what the field is "
        "there",
        "off by order h in a layer of thickness h: order 2 in the RMS, as the field itself; a function in the data's "
        "unit has no such layer"});
  const std::vector<int> meshes{4, 8, 16, 32};
  constexpr double kLow = 0.4, kHigh = 0.6;
  Scene scene = smoothScene(16);
  scene.domain = {{kLow, kHigh}};
  const SeenBy cut = [&](const BodyRay& ray) {
    return quadrature(
        [&](double t) {
          return smoothTransfer(std::clamp((smoothScalar(ray.at(t)) - kLow) / (kHigh - kLow), 0.0, 1.0));
        },
        ray.first, ray.last, 32);  // kinks where the field crosses an end
  };
  const auto draw = [](const HardPicture& picture, int) {
    return drawIn(kNative, picture.scene, picture.prepared, picture.view).image;
  };
  expectOrders({"domain of a fifth", 2, false, true, false}, widths(meshes),
               errorsOn(
                   meshes, [](int n) { return withSmooth(box(n)); }, scene, boxRay, cut, draw));
}

}  // namespace
}  // namespace havs::test
