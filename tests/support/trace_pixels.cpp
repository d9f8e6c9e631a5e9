// Lists the pixels where the picture that havs draws of a mesh differs from the reference, and what explains each.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "core/error.h"
#include "gl/device.h"
#include "image/compare.h"
#include "mesh/read.h"
#include "reference/edge_mask.h"
#include "reference/reference_renderer.h"
#include "render/make_renderer.h"
#include "support/pixel_trace.h"

namespace havs::test {
namespace {

struct TraceOptions {
  std::string mesh, camera = "30,20";
  Scene scene;
  int size = 512;
  double limit = 1e-3;
  std::size_t most = 200;
  bool fragments = false;
};

double errorAt(const Image& a, const Image& b, std::size_t pixel) {
  double error = 0;
  for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c)
    error = std::max<double>(error, std::abs(a.rgba[c] - b.rgba[c]));
  return error;
}

/// Worst first.
std::vector<std::size_t> pixelsBeyond(double limit, const Image& a, const Image& b,
                                      const std::vector<unsigned char>& mask) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (!mask[i] && !(errorAt(a, b, i) <= limit)) pixels.push_back(i);
  std::stable_sort(pixels.begin(), pixels.end(),
                   [&](std::size_t i, std::size_t j) { return errorAt(a, b, i) > errorAt(a, b, j); });
  return pixels;
}

void tracePixels(const TraceOptions& options) {
  Scene scene = options.scene;
  scene.width = scene.height = options.size;
  scene.camera = parseCamera(options.camera, Projection::perspective);
  scene.certificate = true;
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, readMesh(options.mesh), stages);
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  const auto device = makeDevice(scene.device);
  const RenderPlan chosen = plan(scene, prepared.facts(), capabilitiesOf(*device));
  const Drawing picture = makeRenderer(prepared, chosen, stages)->draw(view, stages);
  const Drawing reference = makeReferenceRenderer(prepared)->draw(view, stages);
  const auto mask = boundaryEdgeMask(prepared.points, prepared.faces, view);

  const ErrorMeasures measures = compareImages(picture.image, reference.image, mask).rgba;
  const auto pixels = pixelsBeyond(options.limit, picture.image, reference.image, mask);
  fmt::print("{}: rmse {:.3g}, p999 {:.3g}, max {:.3g}; {} of {} pixels beyond {:g}\n", options.mesh, measures.rmse,
             measures.p999, measures.max, pixels.size(), mask.size(), options.limit);
  const PixelTracer tracer(prepared, view);
  std::map<Cause, std::size_t> causes;
  for (std::size_t i = 0; i < std::min(pixels.size(), options.most); ++i) {
    const auto width = static_cast<std::size_t>(view.width);
    const std::size_t late = picture.certificate ? picture.certificate->count[pixels[i]] : 0;
    const PixelTrace trace = tracer.trace(static_cast<int>(pixels[i] % width), static_cast<int>(pixels[i] / width),
                                          picture.image, reference.image, late);
    ++causes[trace.cause];
    fmt::print("{}", summary(trace));
    if (options.fragments) fmt::print("{} the rasteriser:\n{}", listOf(trace.exact), listOf(trace.snapped));
  }
  for (const auto& [cause, count] : causes) fmt::print("{:6} {}\n", count, nameOf(cause));
  if (pixels.size() > options.most) fmt::print("{:6} not traced (--most)\n", pixels.size() - options.most);
}

}  // namespace
}  // namespace havs::test

int main(int argc, char** argv) {
  havs::test::TraceOptions options;
  CLI::App program("Pixels that differ from the reference, and why", "trace_pixels");
  program.add_option("MESH", options.mesh)->required();
  program.add_option("--size", options.size, "Pixels a side");
  program.add_option("--limit", options.limit, "Errors above it are traced, outside the edge mask");
  program.add_option("--most", options.most, "Pixels traced at most, the worst first");
  program.add_option("--field", options.scene.field);
  program.add_option("--tf", options.scene.transferFunction);
  program.add_option("--lookup", options.scene.lookup);
  program.add_option("--sort", options.scene.sort);
  program.add_option("--k", options.scene.k);
  program.add_option("--device", options.scene.device);
  program.add_option("--camera", options.camera, "azimuth,elevation,zoom, or JSON");
  program.add_flag("--fragments", options.fragments, "List the ray's fragments, too");
  CLI11_PARSE(program, argc, argv);
  try {
    havs::test::tracePixels(options);
  } catch (const havs::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.exitStatus();
  }
}
