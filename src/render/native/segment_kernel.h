// The colours of a queue's segments: shaders/segment_color.glsl, with one file of shaders/lookup, as C++ over SIMD
// lanes. CMake compiles it once for each lookup (HAVS_LOOKUP_NAME; its file is "lookup.glsl") and instruction set.
// The words of the shaders are spelled as in shaders/core/language.glsl; uniforms are members of the class that they
// are included into, set by their names.
#include "render/native/equal_work.h"
#include "render/native/segment_kernels.h"

#define FUNCTION static inline
#define INOUT(T) T&
#define OUT(T) T&
#define CONSTANT static constexpr
#define PRECISE
#define TABLE_FUNCTION
#define TABLES
#define WITH_TABLES
#define TABLE(fetch) fetch
#define WHERE_ANY(mask) if (anyLane(mask))
#define UNIFORM(T, name) const T name = uniform<T>(data, nameKey(#name))
#define UNIFORM_NUMBERS(name, count) const float* const name = uniform<Texels>(data, nameKey(#name)).values
#define HAVS_OPAQUE_SURFACES
#define HAVS_ISOSURFACES
#define HAVS_LIT

namespace havs {

static_assert(sizeof(SegmentQueue::front) == 4 * SegmentQueue::kRoom * sizeof(float));

namespace {

template <class T>
T uniform(const LookupData& data, std::uint64_t key) {
  for (int i = 0; i < data.count; ++i)
    if (data.uniforms[i].key == key) {
      if constexpr (std::is_arithmetic_v<T>) {
        return static_cast<T>(data.uniforms[i].number);
      } else {
        return T{data.uniforms[i]};
      }
    }
  return T{};
}

struct Shading {
  using Real = Lanes::Real;
  using Mask = Lanes::Mask;
  using Int = Lanes::Int;
  using Scalar = float;
  using Rgba = LaneColor;
  static constexpr bool kDouble = false;
  static Real select(Mask condition, Real yes, Real no) { return Lanes::select(condition, yes, no); }
  static Real exp2Integral(Real n) { return Lanes::exp2Integral(n); }
  static Real roundToIntegral(Real x) { return Lanes::roundToIntegral(x); }
  static Real squareRoot(Real x) { return Lanes::squareRoot(x); }
  static Real absolute(Real x) { return Lanes::absolute(x); }
  static bool anyLane(Mask mask) { return Lanes::anyLane(mask); }
  static Int toInt(Real x) { return Lanes::toInt(x); }

  /// The first of a segment end's channels in the queue, read only by what asks for it; or, within a segment, the light
  /// and density there.
  struct Payload {
    const float* channels;
    Real light, density;
  };
  static Payload makeLight(Real light, Real density) { return {nullptr, light, density}; }
  static Real lightOf(const Payload& p) { return p.channels != nullptr ? Lanes::load(p.channels) : p.light; }
  static Real densityOf(const Payload& p) {
    return p.channels != nullptr ? Lanes::load(p.channels + SegmentQueue::kRoom) : p.density;
  }
  static Rgba colorOf(Payload payload) {
    const auto channel = [&](std::size_t c) { return Lanes::load(payload.channels + c * SegmentQueue::kRoom); };
    return {channel(0), channel(1), channel(2), channel(3)};
  }

  const LookupData& data;
  const int lookupNumber = data.lookupNumber;
  const bool cellData = data.cellData;
  const bool opaqueSurfaces = data.opaqueSurfaces;
  const bool isosurfaces = data.isosurfaces;
  const bool lit = data.lit;

#include "core/segment.glsl"
// what uses it
#include "segment_color.glsl"
};

Shading::Segment segmentAt(const QueuedSegments& segments, std::size_t i) {
  Shading::Segment segment;
  segment.front.channels = segments.front + i;
  segment.back.channels = segments.back + i;
  segment.scalarFront = Lanes::load(segments.scalarFront + i);
  segment.scalarBack = Lanes::load(segments.scalarBack + i);
  segment.length = Lanes::load(segments.length + i);
  segment.visible = segment.length >= Shading::Real(0.0f);
  return segment;
}

/// Lanes behind the last segment are segments, too: of no length.
void fillLastLanes(SegmentQueue& queue) {
  for (std::size_t i = queue.count; i < queue.count + Lanes::kLanes - 1; ++i) {
    queue.scalarFront[i] = queue.scalarBack[i] = queue.length[i] = 0;
    for (std::size_t c = 0; c < 4; ++c) queue.front[c][i] = queue.back[c][i] = 0;
  }
}

/// Shades them by equal work where the lookup knows it and that pays; false: it does not.
template <class AnyShading>
[[gnu::flatten]] bool shadedByWork(AnyShading& shading, SegmentQueue& queue) {
  if constexpr (requires(Shading::Segment segment) { shading.workOf(segment); }) {
    const auto work = [&](std::size_t first, std::int32_t* turns) {
      Lanes::storeInts(turns, Lanes::toInt(shading.workOf(segmentAt(QueuedSegments(queue), first))));
    };
    if (shading.lit) return false;  // what segments carry besides scalars is not put in order
    if (!manyIdle(queue.count, work)) return false;
    const EqualWork sorted(queue, work);
    const QueuedSegments segments = sorted.segments(queue);
    for (std::size_t i = 0; i < queue.count; i += Lanes::kLanes)
      sorted.store(queue.rgba.data(), i, shading.segmentColor(segmentAt(segments, i)));
    return true;
  }
  return false;
}

}  // namespace

[[gnu::flatten]] void HAVS_SEGMENT_KERNEL(HAVS_LOOKUP_NAME)(const LookupData& data, SegmentQueue& queue) {
  Shading shading{data};
  fillLastLanes(queue);
  if (shadedByWork(shading, queue)) return;
  const QueuedSegments segments(queue);
  for (std::size_t i = 0; i < queue.count; i += Lanes::kLanes)
    storeColor(queue.rgba.data() + 4 * i, shading.segmentColor(segmentAt(segments, i)));
}

}  // namespace havs
