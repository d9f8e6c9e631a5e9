#pragma once
// The k-buffer of a tile on SIMD lanes. Faces come near first; each is cut into stamps of 4 x 4 pixels. A stamp's
// fragments go through the arithmetic of shaders/core/kbuffer.glsl, and what leaves as visible segments goes into a
// queue, full lanes of which are coloured later; compositing keeps the order of each pixel.
//
// Which pixels a face covers is exact: where the edge functions in float come too near to zero for their sign to be
// sure, the exact rule (raster/face_hit.h) decides.
#include <algorithm>
#include <bit>

#include "core/arithmetic.h"
#include "raster/face_hit.h"
#include "render/native/face_setup.h"
#include "render/native/simd.h"

namespace havs {
namespace {

constexpr unsigned kAllLanes = 0xFFFFu;

template <int kAttributes, class Lanes>
struct PayloadFor;
template <class Lanes>
struct PayloadFor<1, Lanes> {
  template <class L>
  using Type = ScalarPayload<L>;
};
template <class Lanes>
struct PayloadFor<4, Lanes> {
  template <class L>
  using Type = ColorPayload<L>;
};

template <class Lanes, int K, int kAttributes, bool kSpeculative>
class TileDrawer {
  using A = Arithmetic<Lanes, K, PayloadFor<kAttributes, Lanes>::template Type>;
  using Real = typename Lanes::Real;
  using Mask = typename Lanes::Mask;
  using Functions = FaceFunctions<kAttributes>;
  static constexpr int kLanes = static_cast<int>(Lanes::kLanes);
  static constexpr int kGroups = kStampPixels / kLanes;  ///< a stamp is drawn in so many groups of lanes
  static constexpr unsigned kGroupBits = kAllLanes >> (kStampPixels - kLanes);
  static constexpr int kStateNumbers = 2 + K * (2 + kAttributes);

 public:
  explicit TileDrawer(TileDraw& tile) : tile_(tile), queue_(*tile.queue) {}

  void draw() {
    begin();
    for (std::size_t i = 0; i < tile_.faceCount && tile_.activePixels > 0; ++i) drawFace(tile_.faces[i]);
    finish();
  }

 private:
  /// What a stamp's fragments carry, one number a lane.
  struct StampFragments {
    alignas(64) float distance[kStampPixels];
    alignas(64) float attribute[kAttributes][kStampPixels];
    alignas(64) float kind[kStampPixels];
  };

  float* stateOf(int stamp) const {
    return tile_.state + static_cast<std::size_t>(stamp) * kStateNumbers * kStampPixels;
  }
  int stamps() const { return tile_.stampsAcross * tile_.stampsDown; }

  // ------------------------------------------------------------------------------------------ the pixel's state
  static typename A::Fragment loadEntry(const float* at) {
    typename A::Fragment f;
    f.distance = Lanes::load(at);
    f.payload.kind = Lanes::load(at + kStampPixels);
    if constexpr (kAttributes == 1) {
      f.payload.scalar = Lanes::load(at + 2 * kStampPixels);
    } else {
      for (int i = 0; i < kAttributes; ++i) f.payload.color[i] = Lanes::load(at + (2 + i) * kStampPixels);
    }
    return f;
  }
  static void storeEntry(float* at, const typename A::Fragment& f) {
    Lanes::store(at, f.distance);
    Lanes::store(at + kStampPixels, f.payload.kind);
    if constexpr (kAttributes == 1) {
      Lanes::store(at + 2 * kStampPixels, f.payload.scalar);
    } else {
      for (int i = 0; i < kAttributes; ++i) Lanes::store(at + (2 + i) * kStampPixels, f.payload.color[i]);
    }
  }
  static constexpr int kEntryNumbers = (2 + kAttributes) * kStampPixels;
  static constexpr int kFirstEntry = 2 * kStampPixels;
  static typename A::KBuffer loadEntries(const float* state) {
    typename A::KBuffer kbuffer;
    for (int i = 0; i < K; ++i) kbuffer.entry[i] = loadEntry(state + kFirstEntry + i * kEntryNumbers);
    return kbuffer;
  }
  static typename A::PixelState loadPixel(const float* state) {
    typename A::PixelState pixel;
    pixel.inside = Lanes::load(state);
    pixel.started = Lanes::load(state + kStampPixels);
    return pixel;
  }
  static void storePixel(float* state, const typename A::PixelState& pixel) {
    Lanes::store(state, pixel.inside);
    Lanes::store(state + kStampPixels, pixel.started);
  }

  void begin() {
    const typename A::Fragment empty = A::emptyFragment();
    for (int stamp = 0; stamp < stamps(); ++stamp) {
      if (tile_.active[stamp] == 0) continue;
      for (int group = 0; group < kGroups; ++group) {
        float* state = stateOf(stamp) + group * kLanes;
        storePixel(state, {Real(0.0f), Real(0.0f)});
        for (int i = 0; i < K; ++i) storeEntry(state + kFirstEntry + i * kEntryNumbers, empty);
      }
    }
  }

  // ------------------------------------------------------------------------------------------ segments
  void queueSegment(const typename A::Segment& segment, Mask mask, unsigned bits, int firstPixel) {
    const std::size_t at = queue_.count;
    if constexpr (kAttributes == 1) {
      Lanes::compress(&queue_.scalarFront[at], segment.scalarFront, mask, bits);
      Lanes::compress(&queue_.scalarBack[at], segment.scalarBack, mask, bits);
    } else {
      for (int i = 0; i < 4; ++i) {
        Lanes::compress(&queue_.front[i][at], segment.front.color[i], mask, bits);
        Lanes::compress(&queue_.back[i][at], segment.back.color[i], mask, bits);
      }
    }
    Lanes::compress(&queue_.length[at], segment.length, mask, bits);
    std::int32_t* pixel = &queue_.pixel[at];
    for (unsigned left = bits; left != 0; left &= left - 1) *pixel++ = firstPixel + std::countr_zero(left);
    queue_.count = at + static_cast<std::size_t>(std::popcount(bits));
    if (queue_.count + kStampPixels > SegmentQueue::kCapacity || tile_.flushAlways) tile_.flush(tile_);
  }

  /// The visible ones of `bits`.
  void takeSegment(const typename A::Segment& segment, unsigned bits, int firstPixel) {
    bits &= Lanes::bitsOf(segment.visible);
    if (bits != 0) queueSegment(segment, Lanes::maskOf(bits), bits, firstPixel);
  }

  /// One fragment in each of the pixels of `bits`, a group of lanes of a stamp.
  void insert(int stamp, int group, unsigned bits, const typename A::Fragment& incoming) {
    float* state = stateOf(stamp) + group * kLanes;
    typename A::KBuffer kbuffer = loadEntries(state);
    typename A::PixelState pixel = loadPixel(state);
    if constexpr (kSpeculative) {
      const unsigned wrong = bits & Lanes::bitsOf(A::isLateBy(kbuffer, pixel, incoming, Real(0.0f)));
      if (wrong != 0) {
        giveUp(stamp, wrong << (group * kLanes));
        bits &= ~wrong;
      }
    } else {
      const unsigned late = bits & Lanes::bitsOf(A::isLate(kbuffer, pixel, incoming));
      if (late != 0) {
        countLate(stamp, group, late);
        if (!tile_.compositeLate) {
          pixel.inside = Lanes::select(Lanes::maskOf(late), pixel.inside + A::kindOf(incoming.payload), pixel.inside);
          Lanes::store(state, pixel.inside);
          bits &= ~late;
        }
      }
    }
    if (bits == 0) return;
    const Mask mask = Lanes::maskOf(bits);
    const typename A::KBuffer before = kbuffer;
    const typename A::PixelState pixelBefore = pixel;
    typename A::Fragment front;
    A::insertFragment(kbuffer, incoming, front);
    const typename A::Segment segment = A::leave(pixel, front, kbuffer.entry[0]);
    storePixel(state, {Lanes::select(mask, pixel.inside, pixelBefore.inside),
                       Lanes::select(mask, pixel.started, pixelBefore.started)});
    for (int i = 0; i < K; ++i)
      storeEntry(state + kFirstEntry + i * kEntryNumbers,
                 A::selectFragment(mask, kbuffer.entry[i], before.entry[i]));
    takeSegment(segment, bits, stamp * kStampPixels + group * kLanes);
  }

  void giveUp(int stamp, unsigned bits) {
    tile_.flagged[stamp] = static_cast<std::uint16_t>(tile_.flagged[stamp] | bits);
    tile_.active[stamp] = static_cast<std::uint16_t>(tile_.active[stamp] & ~bits);
    tile_.activePixels -= static_cast<std::size_t>(std::popcount(bits));
  }

  void countLate(int stamp, int group, unsigned bits) {
    if (tile_.late == nullptr) return;
    std::uint32_t* late = tile_.late + stamp * kStampPixels + group * kLanes;
    for (; bits != 0; bits &= bits - 1) ++late[std::countr_zero(bits)];
  }

  /// What is left in the k-buffers leaves in order.
  void finish() {
    for (int stamp = 0; stamp < stamps(); ++stamp)
      for (int group = 0; group < kGroups; ++group) {
        const unsigned bits = groupBits(tile_.active[stamp], group);
        if (bits == 0) continue;
        const float* state = stateOf(stamp) + group * kLanes;
        typename A::KBuffer kbuffer = loadEntries(state);
        typename A::PixelState pixel = loadPixel(state);
        for (int i = 0; i + 1 < K; ++i)
          takeSegment(A::leave(pixel, kbuffer.entry[i], kbuffer.entry[i + 1]), bits,
                      stamp * kStampPixels + group * kLanes);
      }
    tile_.flush(tile_);
  }

  static unsigned groupBits(unsigned stampBits, int group) { return stampBits >> (group * kLanes) & kGroupBits; }

  // ------------------------------------------------------------------------------------------ faces
  /// Pixels of the tile, both ends included.
  struct Box {
    int left, top, right, bottom;
  };

  void drawFace(std::uint32_t listed) {
    const bool boundary = (listed & kBoundaryBit) != 0;
    const std::uint32_t face = listed & ~kBoundaryBit;
    const FaceCorners corners = cornersOf(tile_.mesh, face);
    Box box;
    if (!boxInTile(corners, box)) return;

    const double x0 = tile_.left + 0.5, y0 = tile_.top + 0.5;
    Homogeneous h[3];
    for (int i = 0; i < 3; ++i)
      h[i] = {corners.p[i]->x - x0 * corners.p[i]->w, corners.p[i]->y - y0 * corners.p[i]->w, corners.p[i]->w};
    const Linear edge[3] = {edgeOf(h[1], h[2]), edgeOf(h[2], h[0]), edgeOf(h[0], h[1])};  // opposite to corner 0, 1, 2
    const double determinant = h[0].w * edge[0].atOrigin + h[0].x * edge[0].perX + h[0].y * edge[0].perY;
    if (isThin(h, edge, determinant)) return drawPixelByPixel(corners, face, boundary, box);

    const double sign = determinant > 0 ? 1.0 : -1.0;
    const bool entersMesh = (determinant < 0) != corners.reversed;
    Functions functions;
    float limit[3];
    setUp(functions, h, edge, sign, corners, face, entersMesh, limit);
    drawStamps(functions, limit, corners, box, boundary ? (entersMesh ? 1.0f : -1.0f) : 0.0f);
  }

  bool boxInTile(const FaceCorners& corners, Box& box) const {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    bool before = true;
    for (const RasterPoint* p : corners.p) {
      before = before && p->w > 0;
      const double x = p->x / p->w, y = p->y / p->w;
      low[0] = std::min(low[0], x);
      high[0] = std::max(high[0], x);
      low[1] = std::min(low[1], y);
      high[1] = std::max(high[1], y);
    }
    const int lastX = kStampSide * tile_.stampsAcross - 1, lastY = kStampSide * tile_.stampsDown - 1;
    if (!before) {
      box = {0, 0, lastX, lastY};
      return true;
    }
    constexpr double kMargin = 1e-6;  // for the rounding of the divisions
    const double x0 = tile_.left + 0.5, y0 = tile_.top + 0.5;
    const double left = std::max(std::ceil(low[0] - x0 - kMargin), 0.0);
    const double right = std::min(std::floor(high[0] - x0 + kMargin), static_cast<double>(lastX));
    const double top = std::max(std::ceil(low[1] - y0 - kMargin), 0.0);
    const double bottom = std::min(std::floor(high[1] - y0 + kMargin), static_cast<double>(lastY));
    if (!(left <= right && top <= bottom)) return false;
    box = {static_cast<int>(left), static_cast<int>(top), static_cast<int>(right), static_cast<int>(bottom)};
    return true;
  }

  /// Whether the face is too thin in the picture for float, or not wholly before the eye.
  static bool isThin(const Homogeneous* h, const Linear* edge, double determinant) {
    const double size = std::abs(determinant);
    bool thin = false;
    for (int i = 0; i < 3; ++i) {
      const double run = std::abs(edge[i].perX) + std::abs(edge[i].perY);  // at least the edge's length times w w
      thin = thin || !(h[i].w > 0) || !(size > kLeastHeight * h[i].w * run);
    }
    return thin;
  }

  void setUp(Functions& f, const Homogeneous* h, const Linear* edge, double sign, const FaceCorners& corners,
             std::uint32_t face, bool entersMesh, float* limit) const {
    // A sign is sure above the limit; edges are scaled so that the limit is 1.
    constexpr double kFloatError = 0x1p-20;  // of a stamp's three steps in each direction, added up in float
    const double reach = kStampSide * std::max(tile_.stampsAcross, tile_.stampsDown);
    const int ends[3][2] = {{1, 2}, {2, 0}, {0, 1}};
    double sum[3] = {0, 0, 0}, depth[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      const double most = kFloatError * (std::abs(edge[i].perX) + std::abs(edge[i].perY)) +
                          doubleError(h[ends[i][0]], h[ends[i][1]], reach);
      const double scale = sign / most;
      f.atOrigin[i] = scale * edge[i].atOrigin;
      f.perX[i] = scale * edge[i].perX;
      f.perY[i] = scale * edge[i].perY;
      limit[i] = 1.0f;
    }
    const double depth0 = corners.p[0]->depth;
    const double depthStep[3] = {0, corners.p[1]->depth - depth0, corners.p[2]->depth - depth0};
    for (int i = 0; i < 3; ++i) {
      const double e[3] = {sign * edge[i].atOrigin, sign * edge[i].perX, sign * edge[i].perY};
      for (int j = 0; j < 3; ++j) {
        sum[j] += e[j];
        depth[j] += depthStep[i] * e[j];
      }
    }
    put(f, Functions::kSum, sum);
    put(f, Functions::kDepth, depth);
    f.depth0 = static_cast<float>(depth0);
    for (int a = 0; a < kAttributes; ++a) {
      double value[3], numerator[3] = {0, 0, 0};
      attributesOf(corners, face, entersMesh, a, value);
      for (int i = 1; i < 3; ++i) {
        const double step = sign * (value[i] - value[0]);
        numerator[0] += step * edge[i].atOrigin;
        numerator[1] += step * edge[i].perX;
        numerator[2] += step * edge[i].perY;
      }
      put(f, Functions::kFirstAttribute + a, numerator);
      f.attribute0[a] = static_cast<float>(value[0]);
    }
    for (int i = Functions::kCount; i < Functions::kPadded; ++i) f.atOrigin[i] = f.perX[i] = f.perY[i] = 0;
  }

  static void put(Functions& f, int which, const double* value) {
    f.atOrigin[which] = value[0];
    f.perX[which] = value[1];
    f.perY[which] = value[2];
  }

  /// Attribute `a` at the three corners.
  void attributesOf(const FaceCorners& corners, std::uint32_t face, bool entersMesh, int a, double* value) const {
    const RasterMesh& mesh = tile_.mesh;
    for (int i = 0; i < 3; ++i) {
      if constexpr (kAttributes == 1) {
        value[i] = mesh.cellData ? static_cast<double>(mesh.behind[face][entersMesh ? 0 : 1])
                                          : corners.p[i]->scalar;
      } else {
        const std::size_t at = mesh.cellData ? 2 * std::size_t{face} + (entersMesh ? 0 : 1) : corners.index[i];
        value[i] = static_cast<double>(mesh.colors[at][a]);
      }
    }
  }

  // ------------------------------------------------------------------------------------------ by stamps
  void drawStamps(const Functions& f, const float*, const FaceCorners& corners, const Box& box, float kind) {
    alignas(64) float step[Functions::kPadded][kStampPixels];  // from the stamp's first pixel
    float most[3];                                             // the edges' largest step
    for (int i = 0; i < Functions::kCount; ++i) {
      const float x = static_cast<float>(f.perX[i]), y = static_cast<float>(f.perY[i]);
      for (int lane = 0; lane < kStampPixels; ++lane)
        step[i][lane] = x * static_cast<float>(lane % kStampSide) + y * static_cast<float>(lane / kStampSide);
      if (i < 3) most[i] = std::max(x * 3.0f, 0.0f) + std::max(y * 3.0f, 0.0f);
    }
    for (int row = box.top / kStampSide; row <= box.bottom / kStampSide; ++row) {
      alignas(64) double atRow[Functions::kPadded];
      for (int i = 0; i < Functions::kPadded; ++i) atRow[i] = f.atOrigin[i] + f.perY[i] * (row * kStampSide);
      for (int column = box.left / kStampSide; column <= box.right / kStampSide; ++column) {
        alignas(64) float base[Functions::kPadded];
        for (int i = 0; i < Functions::kPadded; ++i)
          base[i] = static_cast<float>(atRow[i] + f.perX[i] * (column * kStampSide));
        // Wholly outside of an edge? 2: for the rounding of this sum, the limit being 1 above the edges' own.
        if (base[0] + most[0] < -2.0f || base[1] + most[1] < -2.0f || base[2] + most[2] < -2.0f) continue;
        const int stamp = row * tile_.stampsAcross + column;
        const unsigned active = tile_.active[stamp];
        if (active == 0) continue;
        for (int group = 0; group < kGroups; ++group)
          drawGroup(f, base, step, corners, stamp, group, groupBits(active, group), kind);
      }
    }
  }

  void drawGroup(const Functions& f, const float* base, const float (*step)[kStampPixels], const FaceCorners& corners,
                 int stamp, int group, unsigned bits, float kind) {
    auto function = [&](int i) { return Real(base[i]) + Lanes::load(step[i] + group * kLanes); };
    auto least = [](Real a, Real b) { return Lanes::select(a < b, a, b); };
    const Real inside = least(least(function(0), function(1)), function(2));
    const unsigned sure = Lanes::bitsOf(inside > Real(1.0f));
    const unsigned possible = Lanes::bitsOf(inside >= Real(-1.0f));
    unsigned covered = bits & sure;
    if (const unsigned unsure = bits & possible & ~sure; unsure != 0) covered |= decide(corners, stamp, group, unsure);
    if (covered == 0) return;
    tile_.fragments += static_cast<unsigned>(std::popcount(covered));

    const Real perSum = Real(1.0f) / function(Functions::kSum);
    const Real scale = Lanes::load(tile_.rayScale + stamp * kStampPixels + group * kLanes);
    typename A::Fragment fragment;
    fragment.distance = (Real(f.depth0) + function(Functions::kDepth) * perSum) * scale;
    fragment.payload.kind = Real(kind);
    auto attribute = [&](int i) {
      return clamped(Real(f.attribute0[i]) + function(Functions::kFirstAttribute + i) * perSum);
    };
    if constexpr (kAttributes == 1) {
      fragment.payload.scalar = attribute(0);
    } else {
      for (int i = 0; i < kAttributes; ++i) fragment.payload.color[i] = attribute(i);
    }
    insert(stamp, group, covered, fragment);
  }

  /// To [0, 1].
  static Real clamped(Real value) {
    const Real low = Lanes::select(value > Real(0.0f), value, Real(0.0f));
    return Lanes::select(low < Real(1.0f), low, Real(1.0f));
  }

  /// The pixels of `bits` that the face covers by the exact rule.
  unsigned decide(const FaceCorners& corners, int stamp, int group, unsigned bits) const {
    unsigned covered = 0;
    for (; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      const int pixel = group * kLanes + lane;
      const int x = stamp % tile_.stampsAcross * kStampSide + pixel % kStampSide;
      const int y = stamp / tile_.stampsAcross * kStampSide + pixel / kStampSide;
      if (hitAt(corners, x, y).sign != 0) covered |= 1u << lane;
    }
    return covered;
  }

  /// At a pixel of the tile.
  FaceHit hitAt(const FaceCorners& corners, int x, int y) const {
    return hitFace(*corners.p[0], *corners.p[1], *corners.p[2], tile_.left + x + 0.5, tile_.top + y + 0.5,
                   tile_.mesh.width, tile_.mesh.height);
  }

  // ------------------------------------------------------------------------------------------ pixel by pixel
  void drawPixelByPixel(const FaceCorners& corners, std::uint32_t face, bool boundary, const Box& box) {
    for (int y = box.top; y <= box.bottom; ++y) {
      int first = box.left, last = box.right;
      for (int sense = 1; sense >= -1; sense -= 2) {
        int from = first, to = last;
        if (!spanOf(corners, y, sense, from, to)) continue;
        for (int x = from; x <= to; ++x) drawPixel(corners, face, boundary, x, y, sense);
      }
    }
  }

  /// Narrows [from, to] to the pixels of the row where the products may all have the sign of `sense`.
  bool spanOf(const FaceCorners& corners, int row, int sense, int& from, int& to) const {
    const double x0 = tile_.left + 0.5, y = tile_.top + row + 0.5;
    double low = from, high = to;
    for (int i = 0; i < 3; ++i) {
      const RasterPoint &a = *corners.p[(i + 1) % 3], &b = *corners.p[(i + 2) % 3];
      const double ay = a.y - y * a.w, by = b.y - y * b.w;
      const double ax = a.x - x0 * a.w, bx = b.x - x0 * b.w;
      const double at0 = sense * (ax * by - ay * bx), perX = sense * (ay * b.w - a.w * by);
      const double rounding = 64 * 0x1p-53 *
                              ((std::abs(ax) + tile_.mesh.width * std::abs(a.w)) * (std::abs(by) + std::abs(y * b.w)) +
                               (std::abs(bx) + tile_.mesh.width * std::abs(b.w)) * (std::abs(ay) + std::abs(y * a.w)));
      if (perX > 0) {
        low = std::max(low, (-at0 - rounding) / perX - 1e-6);
      } else if (perX < 0) {
        high = std::min(high, (at0 + rounding) / -perX + 1e-6);
      } else if (at0 < -rounding) {
        return false;
      }
    }
    if (!(low <= high)) return false;
    from = static_cast<int>(std::ceil(low));
    to = static_cast<int>(std::floor(high));
    return from <= to;
  }

  void drawPixel(const FaceCorners& corners, std::uint32_t face, bool boundary, int x, int y, int sense) {
    const int stamp = y / kStampSide * tile_.stampsAcross + x / kStampSide;
    const int pixel = y % kStampSide * kStampSide + x % kStampSide;
    if ((tile_.active[stamp] >> pixel & 1) == 0) return;
    const FaceHit hit = hitAt(corners, x, y);
    if (hit.sign != sense) return;
    const RasterPoint* const* p = corners.p;
    const double sum = hit.a + hit.b + hit.c;
    auto mean = [&](double a, double b, double c) { return (hit.a * a + hit.b * b + hit.c * c) / sum; };
    if (!(mean(p[0]->w, p[1]->w, p[2]->w) > 0)) return;  // behind the eye
    const bool entersMesh = (hit.sign < 0) != corners.reversed;
    const double depth = mean(p[0]->depth, p[1]->depth, p[2]->depth);
    if (!std::isfinite(depth)) return;  // the eye in the plane of the face
    ++tile_.fragments;

    const int group = pixel / kLanes, lane = pixel % kLanes;
    const float scale = tile_.rayScale[stamp * kStampPixels + pixel];
    typename A::Fragment fragment;
    fragment.distance = Real(static_cast<float>(depth) * scale);
    fragment.payload.kind = Real(boundary ? (entersMesh ? 1.0f : -1.0f) : 0.0f);
    for (int a = 0; a < kAttributes; ++a) {
      double value[3];
      attributesOf(corners, face, entersMesh, a, value);
      const Real number = clamped(Real(static_cast<float>(mean(value[0], value[1], value[2]))));
      if constexpr (kAttributes == 1) {
        fragment.payload.scalar = number;
      } else {
        fragment.payload.color[a] = number;
      }
    }
    insert(stamp, group, 1u << lane, fragment);
  }

  TileDraw& tile_;
  SegmentQueue& queue_;
};

template <class Lanes, int K, int kAttributes, bool kSpeculative>
void drawTileKernel(TileDraw& tile) {
  TileDrawer<Lanes, K, kAttributes, kSpeculative>(tile).draw();
}

}  // namespace
}  // namespace havs
