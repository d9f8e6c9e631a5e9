// What a frame costs, stage by stage, on a mesh of about one million tetrahedra: the k-buffer against plain additive
// blending of the same faces, in turn in one run; order and upload as a part of the frame; the table's build; peak
// memory of the whole process up to the first picture (TetGen runs in a process of its own). Medians after a warm-up;
// prints JSON.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/error.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "render/gl/lookup_textures.h"
#include "render/gl/mesh_buffers.h"
#include "render/gl/tile.h"
#include "render/make_renderer.h"

namespace havs {
namespace {

struct Options {
  std::string mesh = HAVS_MESHES "/cube.poly";
  std::string switches = "pqa1.9e-6";
  std::string field;
  std::string transferFunction = "viridis";
  std::string lookup = Scene{}.lookup;
  std::optional<int> tableSize;
  std::string tableFormat = Scene{}.tableFormat;
  int size = 1024;
  int k = 6;
  int repeat = 7;
};

/// Wall and processor milliseconds of one call, kept for the median.
class Stopwatch {
 public:
  template <class Work>
  void time(const Work& work) {
    const double cpu = cpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    work();
    wall_.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    cpu_.push_back(1e3 * (cpuSeconds() - cpu));
  }
  double wall() const { return median(wall_); }
  double cpu() const { return median(cpu_); }

 private:
  static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
  }
  std::vector<double> wall_, cpu_;
};

nlohmann::ordered_json asJson(const Stopwatch& watch) { return {{"wall_ms", watch.wall()}, {"cpu_ms", watch.cpu()}}; }

/// The same faces in the same order by plain additive blending.
class AdditiveDrawing {
 public:
  AdditiveDrawing(const PreparedScene& prepared, const View& view, const FaceOrder& order)
      : program_("additive", {{GL_VERTEX_SHADER, shaderSource("faces.vert")},
                              {GL_FRAGMENT_SHADER, shaderSourceFromText("additive.frag", fragmentText())}}),
        mesh_(prepared),
        target_(Texture::image2D("sum", GL_RGBA32F, view.width, view.height)),
        framebuffer_("sum", {std::cref(target_)}) {
    mesh_.setOrder(order);
    program_.set("toClip", glm::mat4(clipMatrix(view, {0, 0, view.width, view.height})));
    program_.set("forward", glm::vec3(view.forward));
    program_.set("firstBoundaryVertex", mesh_.firstBoundaryVertex());
  }

  void draw() const {
    framebuffer_.bind();
    framebuffer_.clear(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    program_.use();
    mesh_.drawInBatches([](std::size_t) {});
    glFinish();
    glDisable(GL_BLEND);
  }

  double fragments() const {
    double sum = 0;
    const auto pixels = framebuffer_.readFloats(0);
    for (std::size_t i = 3; i < pixels.size(); i += 4) sum += pixels[i];
    return sum;
  }

 private:
  static std::string fragmentText() {
    std::ifstream file(HAVS_BENCH "/additive.frag");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  Program program_;
  MeshBuffers mesh_;
  Texture target_;
  Framebuffer framebuffer_;
};

Scene sceneOf(const Options& options) {
  Scene scene;
  scene.transferFunction = options.transferFunction;
  scene.field = options.field;
  scene.lookup = options.lookup;
  scene.tableSize = options.tableSize;
  scene.tableFormat = options.tableFormat;
  scene.width = scene.height = options.size;
  scene.k = options.k;
  return scene;
}

TetMesh meshOf(const Options& options) {
  ReadOptions reading;
  reading.tetgenSwitches = options.switches;
  TetMesh mesh = readMesh(options.mesh, reading);
  if (options.field.empty()) {
    mesh.pointFields = {fieldFromExpression(mesh, "s", "0.5+0.25*sin(7*x)*cos(5*y)+0.2*sin(6*z+3*x*y)")};
    mesh.cellFields.clear();
  }
  return mesh;
}

nlohmann::ordered_json measure(const Options& options) {
  const Scene scene = sceneOf(options);
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, meshOf(options), stages);
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  const auto device = makeDevice(scene.device);
  const RenderPlan chosen = plan(scene, prepared.facts(), capabilitiesOf(*device));

  Stopwatch table;
  for (int i = 0; i <= options.repeat; ++i) table.time([&] { LookupTextures(prepared, chosen, {}); });

  const auto renderer = makeRenderer(prepared, chosen, stages);
  const auto sorter = sortMethod(scene.sort).make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces});
  FaceOrder order;
  sorter->sort(viewPointOf(view), order);
  renderer->draw(view, stages);
  const std::size_t peak = peakMemoryBytes();
  const AdditiveDrawing additive(prepared, view, order);
  additive.draw();

  Stopwatch ordering, blending, drawing;
  StageTimes frames;
  for (int i = 0; i < options.repeat; ++i) {
    ordering.time([&] { sorter->sort(viewPointOf(view), order); });
    blending.time([&] { additive.draw(); });
    drawing.time([&] { renderer->draw(view, frames); });
  }
  const double orderAndUpload = ordering.wall() + frames.median("upload");
  const double frame = orderAndUpload + frames.median("draw") + frames.median("flush");
  nlohmann::ordered_json json;
  json["tetrahedra"] = prepared.mesh.tetrahedra.size();
  json["faces"] = prepared.faces.size();
  json["fragments"] = additive.fragments();
  json["size"] = options.size;
  json["k"] = options.k;
  json["lookup"] = options.lookup;
  json["table_size"] = chosen.tableSize;
  json["table_format"] = options.tableFormat;
  json["repeat"] = options.repeat;
  json["renderer"] = device->renderer();
  json["threads"] = threadCount();
  json["additive_draw"] = asJson(blending);
  json["kbuffer_draw"] = asJson(drawing);
  json["kbuffer_draw_stage_ms"] = frames.median("draw");
  json["order"] = asJson(ordering);
  json["upload_ms"] = frames.median("upload");
  json["flush_ms"] = frames.median("flush");
  json["frame_ms"] = frame;
  json["table"] = asJson(table);
  const std::size_t pixels = static_cast<std::size_t>(options.size) * static_cast<std::size_t>(options.size);
  const std::size_t targets = pixels * static_cast<std::size_t>(chosen.bytesPerPixel), picture = pixels * 16;
  json["memory"] = {
      {"peak_bytes", peak},
      {"target_bytes", targets},
      {"picture_bytes", picture},
      {"bytes_a_tetrahedron_beyond_targets_and_picture",
       static_cast<double>(peak - targets - picture) / static_cast<double>(prepared.mesh.tetrahedra.size())}};
  json["ratios"] = {{"kbuffer_draw_to_additive", frames.median("draw") / blending.wall()},
                    {"order_and_upload_to_frame", orderAndUpload / frame},
                    {"table_to_frame", table.wall() / frame}};
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What a frame costs; prints JSON");
  app.add_option("--mesh", options.mesh, "a mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--field", options.field, "a field of the mesh; default an expression");
  app.add_option("--tf", options.transferFunction, "transfer function")->capture_default_str();
  app.add_option("--lookup", options.lookup, "how a segment's colour is found")->capture_default_str();
  app.add_option("--table", options.tableSize, "size of the table; default the lookup's own");
  app.add_option("--table-format", options.tableFormat, "numbers of the table")->capture_default_str();
  app.add_option("--size", options.size, "pixels along each side")->capture_default_str();
  app.add_option("--k", options.k, "entries of the k-buffer")->capture_default_str();
  app.add_option("--repeat", options.repeat, "counted frames")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_frame: " << error.what() << '\n';
    return error.exitStatus();
  }
}
