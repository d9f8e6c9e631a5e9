// What the colour of one segment costs on the native device: every lookup by every instruction set, in turn in one run
// after a warm-up; CPU nanoseconds a segment, medians; prints JSON. The segments are like those of a mesh of a million
// tetrahedra on 1024 x 1024 pixels: face by face, neighbouring pixels alike.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.h"
#include "core/median.h"
#include "core/memory.h"
#include "render/native/segment_shader.h"
#include "support/meshes.h"

namespace havs {
namespace {

constexpr std::size_t kQueues = 192;
constexpr std::size_t kSegments = kQueues * SegmentQueue::kCapacity;

struct Segments {
  std::vector<float> front, back, length;
  std::array<std::vector<float>, 4> color;
};

/// Faces of about 33 pixels. From face to face of a tile, which come near first, the scalar goes slowly up and down.
Segments likeThoseOfAMesh() {
  Segments list;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  float base = 0.5F;
  while (list.front.size() < kSegments) {
    base += 0.04F * (unit(random) - 0.5F);
    if (base < 0.06F || base > 0.94F) base = 0.5F;
    const float front = base + 0.05F * (unit(random) - 0.5F);
    const float change = (random() % 2 ? 1.0F : -1.0F) * (0.01F + 0.04F * unit(random));
    const float length = 0.005F + 0.045F * unit(random);
    const int pixels = 1 + static_cast<int>(random() % 65);
    const float slope = 0.02F * (unit(random) - 0.5F);
    for (int i = 0; i < pixels; ++i) {
      const float along = static_cast<float>(i) / static_cast<float>(pixels) - 0.5F;
      const float from = std::clamp(front + slope * along, 0.0F, 1.0F);
      const float size = 1 - std::abs(2 * along);  // a face's pixels near its edges have short segments
      list.front.push_back(from);
      list.back.push_back(std::clamp(from + change * size, 0.0F, 1.0F));
      list.length.push_back(length * size);
      for (std::size_t c = 0; c < 4; ++c) list.color[c].push_back(0.1F * static_cast<float>(c) + 0.5F * from);
    }
  }
  return list;
}

void fill(SegmentQueue& queue, const Segments& list, std::size_t first, bool colors) {
  const auto copy = [&](const std::vector<float>& from, auto& to) {
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), SegmentQueue::kCapacity, to.begin());
  };
  queue.count = SegmentQueue::kCapacity;
  copy(list.front, queue.scalarFront);
  copy(list.back, queue.scalarBack);
  copy(list.length, queue.length);
  for (std::size_t c = 0; colors && c < 4; ++c) {
    copy(list.color[c], queue.front[c]);
    copy(list.color[c], queue.back[c]);
  }
}

struct Measured {
  std::string lookup, instructions;
  SegmentShader shader;
  bool colors;
  std::vector<double> times;
};

double secondsOf(const SegmentShader* shader, SegmentQueue& queue, const Segments& list, bool colors) {
  const double start = cpuSeconds();
  for (std::size_t first = 0; first < kSegments; first += SegmentQueue::kCapacity) {
    fill(queue, list, first, colors);
    if (shader) shader->shade(queue);
  }
  return cpuSeconds() - start;
}

nlohmann::ordered_json measure(const std::vector<std::string>& names, const std::vector<std::string>& instructions,
                               Scene scene, int repeat) {
  std::vector<Measured> all;
  for (const std::string& name : names) {
    scene.lookup = name;
    StageTimes stages;
    TetMesh mesh = test::box(32);
    mesh.pointFields.push_back({"x", 1, test::linearField(mesh.points, {0.5, 0, 0})});
    scene.domain = {0, 1};
    const PreparedScene prepared = prepareScene(scene, std::move(mesh), stages);
    Capabilities native;
    native.native = true;
    const RenderPlan chosen = plan(scene, prepared.facts(), native);
    for (const InstructionSet& set : instructionSets()) {
      if (!set.available()) continue;
      if (!instructions.empty() && std::count(instructions.begin(), instructions.end(), set.name) == 0) continue;
      all.push_back(
          {name, set.name, SegmentShader(prepared, chosen, set), chosen.lookup.carries == Payload::color, {}});
    }
  }
  const Segments list = likeThoseOfAMesh();
  const auto queue = std::make_unique<SegmentQueue>();
  std::vector<double> filling;
  for (int i = 0; i <= repeat; ++i) {
    const double idle = secondsOf(nullptr, *queue, list, false);
    if (i > 0) filling.push_back(idle);
    for (Measured& one : all) {
      const double seconds = secondsOf(&one.shader, *queue, list, one.colors);
      if (i > 0) one.times.push_back(seconds);
    }
  }
  constexpr double kNanoseconds = 1e9 / static_cast<double>(kSegments);
  nlohmann::ordered_json json;
  json["transfer_function"] = scene.transferFunction;
  json["queue_filled_ns"] = kNanoseconds * medianOf(filling);
  for (const Measured& one : all)
    json["ns"][one.lookup][one.instructions] = kNanoseconds * (medianOf(one.times) - medianOf(filling));
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  CLI::App app("CPU time of a segment's colour on the native device.");
  std::vector<std::string> transfers{"viridis"}, instructions,
      names{"3d", "3d-normalised", "exact", "post", "integral", "2d", "riemann:4", "pre"};
  havs::Scene scene;
  int repeat = 7;
  app.add_option("--tf", transfers, "transfer functions");
  app.add_option("--lookup", names, "lookups");
  app.add_option("--simd", instructions, "instruction sets; all that this processor has");
  app.add_option("--table", scene.tableSize, "entries along an axis");
  app.add_option("--table-format", scene.tableFormat, "of tables");
  app.add_option("--repeat", repeat, "timed runs of each");
  CLI11_PARSE(app, argc, argv);
  try {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const std::string& transfer : transfers) {
      scene.transferFunction = transfer;
      json.push_back(havs::measure(names, instructions, scene, repeat));
    }
    std::cout << json.dump(2) << "\n";
  } catch (const havs::Error& error) {
    std::cerr << "bench_segments: " << error.what() << "\n";
    return error.exitStatus();
  }
}
