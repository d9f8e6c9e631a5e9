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
    for (std::size_t i = 0; i < tile_.faceCount && tile_.activePixels > 0; ++i) {
      fetchAhead(i);
      drawFace(tile_.faces[i]);
    }
    finish();
  }

 private:
  /// What a stamp's fragments carry, one number a lane.
  struct StampFragments {
    alignas(64) float distance[kStampPixels];
    alignas(64) float attribute[kAttributes][kStampPixels];
    alignas(64) float kind[kStampPixels];
  };

  /// Faces and their corners lie anywhere in memory.
  void fetchAhead(std::size_t i) const {
    constexpr std::size_t kFaces = 16, kCorners = 6;
    if (i + kFaces >= tile_.faceCount) return;
    __builtin_prefetch(tile_.mesh.faces[tile_.faces[i + kFaces] & ~kBoundaryBit]);
    const std::uint32_t* corners = tile_.mesh.faces[tile_.faces[i + kCorners] & ~kBoundaryBit];
    for (int j = 0; j < 3; ++j) __builtin_prefetch(tile_.mesh.points + corners[j]);
  }

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

    const int stampX = box.left / kStampSide * kStampSide, stampY = box.top / kStampSide * kStampSide;
    const double x0 = tile_.left + stampX + 0.5, y0 = tile_.top + stampY + 0.5;
    Homogeneous h[3];
    for (int i = 0; i < 3; ++i)
      h[i] = {corners.p[i]->x - x0 * corners.p[i]->w, corners.p[i]->y - y0 * corners.p[i]->w, corners.p[i]->w};
    const Linear edge[3] = {edgeOf(h[1], h[2]), edgeOf(h[2], h[0]), edgeOf(h[0], h[1])};  // opposite to corner 0, 1, 2
    const double determinant = h[0].w * edge[0].atOrigin + h[0].x * edge[0].perX + h[0].y * edge[0].perY;
    const double extent = kStampSide + std::max(box.right - box.left, box.bottom - box.top);
    if (isThin(h, edge, determinant, extent)) return drawPixelByPixel(corners, face, boundary, box);

    const bool entersMesh = (determinant < 0) != corners.reversed;
    Functions functions;
    setUp(functions, h, edge, determinant > 0 ? 1.0 : -1.0, extent, corners, face, entersMesh);
    drawStamps(functions, corners, box, boundary ? (entersMesh ? 1.0f : -1.0f) : 0.0f);
  }

  bool boxInTile(const FaceCorners& corners, Box& box) const {
    const RasterPoint &a = *corners.p[0], &b = *corners.p[1], &c = *corners.p[2];
    const int lastX = kStampSide * tile_.stampsAcross - 1, lastY = kStampSide * tile_.stampsDown - 1;
    if (!(a.w > 0 && b.w > 0 && c.w > 0)) {
      box = {0, 0, lastX, lastY};
      return true;
    }
    constexpr double kMargin = 1e-6;  // for the rounding of the divisions
    const double x0 = tile_.left + 0.5, y0 = tile_.top + 0.5;
    // From -1 on: of a value below 0, truncation would not give the next larger number.
    auto first = [](double low) { return static_cast<int>(std::max(low, -1.0) + 2.0) - 1; };
    auto last = [](double high, int most) { return static_cast<int>(std::min(high, most + 0.5) + 1.0) - 1; };
    box.left = first(std::min(std::min(a.column, b.column), c.column) - x0 - kMargin);
    box.top = first(std::min(std::min(a.row, b.row), c.row) - y0 - kMargin);
    const double right = std::max(std::max(a.column, b.column), c.column) - x0 + kMargin;
    const double bottom = std::max(std::max(a.row, b.row), c.row) - y0 + kMargin;
    if (!(right >= 0 && bottom >= 0)) return false;
    box.right = last(right, lastX);
    box.bottom = last(bottom, lastY);
    return box.left <= box.right && box.top <= box.bottom;
  }

  /// Whether the face is too thin in the picture for float, or not wholly before the eye.
  static bool isThin(const Homogeneous* h, const Linear* edge, double determinant, double extent) {
    const double size = std::abs(determinant);
    bool thin = false;
    for (int i = 0; i < 3; ++i) {
      const double run = std::abs(edge[i].perX) + std::abs(edge[i].perY);  // at least the edge's length times w w
      thin = thin || !(h[i].w > 0) || !(size > kLeastHeight * extent * h[i].w * run);
    }
    return thin;
  }

  void setUp(Functions& f, const Homogeneous* h, const Linear* edge, double sign, double extent,
             const FaceCorners& corners, std::uint32_t face, bool entersMesh) const {
    // A sign is sure where the value exceeds its error; edges are scaled so that this is 1.
    const int ends[3][2] = {{1, 2}, {2, 0}, {0, 1}};
    Linear sum{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      const double error = kFloatError * extent * (std::abs(edge[i].perX) + std::abs(edge[i].perY)) +
                           doubleError(h[ends[i][0]], h[ends[i][1]], extent);
      put(f, i, edge[i], sign / error);
      sum = {sum.atOrigin + edge[i].atOrigin, sum.perX + edge[i].perX, sum.perY + edge[i].perY};
    }
    put(f, Functions::kSum, sum, sign);
    const double depth[3] = {corners.p[0]->depth, corners.p[1]->depth, corners.p[2]->depth};
    f.depth0 = putNumerator(f, Functions::kDepth, edge, depth, sign);
    for (int a = 0; a < kAttributes; ++a) {
      double value[3];
      attributesOf(corners, face, entersMesh, a, value);
      f.attribute0[a] = putNumerator(f, Functions::kFirstAttribute + a, edge, value, sign);
    }
  }

  static void put(Functions& f, int which, const Linear& linear, double scale) {
    f.atOrigin[which] = static_cast<float>(scale * linear.atOrigin);
    f.perX[which] = static_cast<float>(scale * linear.perX);
    f.perY[which] = static_cast<float>(scale * linear.perY);
  }

  /// Of what has these values at the corners, relative to the first, which is returned.
  static float putNumerator(Functions& f, int which, const Linear* edge, const double* value, double sign) {
    const double b = value[1] - value[0], c = value[2] - value[0];
    put(f, which,
        {b * edge[1].atOrigin + c * edge[2].atOrigin, b * edge[1].perX + c * edge[2].perX,
         b * edge[1].perY + c * edge[2].perY},
        sign);
    return static_cast<float>(value[0]);
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
  void drawStamps(const Functions& f, const FaceCorners& corners, const Box& box, float kind) {
    const int firstColumn = box.left / kStampSide, lastColumn = box.right / kStampSide;
    const int firstRow = box.top / kStampSide, lastRow = box.bottom / kStampSide;
    alignas(64) static constexpr float kX[kStampPixels] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr float kY[kStampPixels] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    Real edge[3][kGroups];  // at the pixels of the first stamp
    for (int i = 0; i < 3; ++i)
      for (int group = 0; group < kGroups; ++group)
        edge[i][group] = (Real(f.perX[i]) * Lanes::load(kX + group * kLanes) +
                          Real(f.perY[i]) * Lanes::load(kY + group * kLanes)) +
                         Real(f.atOrigin[i]);
    for (int row = firstRow; row <= lastRow; ++row) {
      const float y = static_cast<float>((row - firstRow) * kStampSide);
      for (int column = firstColumn; column <= lastColumn; ++column) {
        const int stamp = row * tile_.stampsAcross + column;
        const unsigned active = tile_.active[stamp];
        if (active == 0) continue;
        const float x = static_cast<float>((column - firstColumn) * kStampSide);
        for (int group = 0; group < kGroups; ++group) {
          auto value = [&](int i) { return edge[i][group] + Real(f.perX[i] * x + f.perY[i] * y); };
          auto least = [](Real a, Real b) { return Lanes::select(a < b, a, b); };
          const Real inside = least(least(value(0), value(1)), value(2));
          const unsigned bits = groupBits(active, group);
          const unsigned sure = Lanes::bitsOf(inside > Real(1.0f)) & bits;
          const unsigned unsure = Lanes::bitsOf(inside >= Real(-1.0f)) & bits & ~sure;
          if ((sure | unsure) == 0) continue;
          const unsigned covered = unsure == 0 ? sure : sure | decide(corners, stamp, group, unsure);
          if (covered != 0)
            drawGroup(f, Real(x) + Lanes::load(kX + group * kLanes), Real(y) + Lanes::load(kY + group * kLanes), stamp,
                      group, covered, kind);
        }
      }
    }
  }

  /// (x, y): of the pixels, from the face's first stamp.
  void drawGroup(const Functions& f, Real x, Real y, int stamp, int group, unsigned covered, float kind) {
    auto function = [&](int i) { return Real(f.perX[i]) * x + Real(f.perY[i]) * y + Real(f.atOrigin[i]); };
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
