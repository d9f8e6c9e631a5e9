#pragma once
// Lists of segments shaded by the native device, for tests.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "render/native/segment_shader.h"
#include "support/meshes.h"

namespace havs::test {

struct GivenSegment {
  float front = 0, back = 0, length = 0;
  std::array<float, 4> frontColor{}, backColor{};  ///< of Payload::color
};
using Color = std::array<float, 4>;

inline std::array<std::uint32_t, 4> bitsOf(const Color& c) { return std::bit_cast<std::array<std::uint32_t, 4>>(c); }

/// What a lookup is called with: a box with the scalar 0.5 everywhere, the scene's transfer function, the plan.
struct LookupScene {
  PreparedScene prepared;
  RenderPlan plan;

  explicit LookupScene(const Scene& scene) {
    TetMesh mesh = box(2);
    mesh.pointFields.push_back({"s", 1, constantField(mesh.points, 0.5)});
    StageTimes stages;
    Scene asked = scene;
    asked.domain = {0, 1};
    prepared = prepareScene(asked, std::move(mesh), stages);
    Capabilities native;
    native.native = true;
    plan = havs::plan(asked, prepared.facts(), native);
  }
  SegmentShader shader(const std::string& instructions) const {
    return SegmentShader(prepared, plan, instructionSet(instructions));
  }
};

/// The names of the instruction sets that this processor has.
inline std::vector<std::string> instructionSetsHere() {
  std::vector<std::string> names;
  for (const InstructionSet& row : instructionSets())
    if (row.available()) names.push_back(row.name);
  return names;
}

/// The colours, `batch` segments in the queue at a time.
inline std::vector<Color> shaded(const SegmentShader& shader, const std::vector<GivenSegment>& given,
                                 std::size_t batch = SegmentQueue::kCapacity) {
  const auto queue = std::make_unique<SegmentQueue>();
  std::vector<Color> colors;
  for (std::size_t first = 0; first < given.size(); first += batch) {
    queue->count = std::min(batch, given.size() - first);
    for (std::size_t i = 0; i < queue->count; ++i) {
      const GivenSegment& s = given[first + i];
      queue->scalarFront[i] = s.front;
      queue->scalarBack[i] = s.back;
      queue->length[i] = s.length;
      for (std::size_t c = 0; c < 4; ++c) {
        queue->front[c][i] = s.frontColor[c];
        queue->back[c][i] = s.backColor[c];
      }
    }
    shader.shade(*queue);
    for (std::size_t i = 0; i < queue->count; ++i) {
      const float* const c = &queue->rgba[4 * i];
      colors.push_back({c[0], c[1], c[2], c[3]});
    }
  }
  return colors;
}

/// A grid of scalars and lengths, then random segments, half of them short in the scalar, some thin, some longer than
/// the tables reach.
inline std::vector<GivenSegment> segmentsOfAllKinds(float longest, std::size_t count) {
  std::vector<GivenSegment> list;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(0, 1);
  const auto add = [&](float front, float back, float length) {
    GivenSegment s{front, back, length, {}, {}};
    for (float& c : s.frontColor) c = unit(random);
    for (float& c : s.backColor) c = unit(random);
    list.push_back(s);
  };
  for (int f = 0; f <= 10; ++f)
    for (int b = 0; b <= 10; ++b)
      for (float part : {0.0F, 1e-30F, 1e-4F, 0.1F, 1.0F, 3.0F})
        add(static_cast<float>(f) / 10, static_cast<float>(b) / 10, part * longest);
  for (float tiny : {1e-45F, 1e-40F, 1e-38F, 1e-20F})  // changes of the scalar too small to have a reciprocal
    for (float length : {0.1F, 1.0F}) add(0, tiny, length), add(tiny, 0, length);
  for (float length : {1e3F, 1e10F, 3e38F}) add(0.2F, 0.9F, length), add(0.7F, 0.1F, length);
  while (list.size() < count) {
    const float front = unit(random);
    const float span = random() % 2 ? 1.0F : 0.03F;
    const float part = random() % 2 ? 1.0F : 0.02F;
    add(front, std::clamp(front + span * (2 * unit(random) - 1), 0.0F, 1.0F), part * longest * unit(random));
  }
  std::shuffle(list.begin(), list.end(), random);
  return list;
}

}  // namespace havs::test
