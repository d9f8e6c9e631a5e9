#pragma once
// What a tile kernel keeps of its pixels between two faces: the k-buffer, or, where the order is believed, the last
// fragment alone. The arithmetic is that of shaders/core/kbuffer.glsl. Included by tile_kernel.h.
#include "core/arithmetic.h"
#include "render/native/simd.h"
#include "render/native/tile_draw.h"

namespace havs {
namespace {

/// What a stamp's pixels keep of a fragment, in floats of kStampPixels lanes each.
template <class A, class Lanes>
struct StoredFragment {
  static constexpr int kOfPayload = A::Payload::kNumbers;
  static constexpr int kNumbers = 2 + kOfPayload;

  static typename A::Fragment load(const float* at) {
    typename A::Fragment f;
    f.distance = Lanes::load(at);
    f.payload.kind = Lanes::load(at + kStampPixels);
    for (int i = 0; i < kOfPayload; ++i) f.payload.number(i) = Lanes::load(at + (2 + i) * kStampPixels);
    return f;
  }
  static void store(float* at, typename A::Fragment f) {
    Lanes::store(at, f.distance);
    Lanes::store(at + kStampPixels, f.payload.kind);
    for (int i = 0; i < kOfPayload; ++i) Lanes::store(at + (2 + i) * kStampPixels, f.payload.number(i));
  }
};

/// What comes of a fragment in each pixel of a group: the segment that has left; pixels where the fragment is `wrong`,
/// as it should have come earlier; and those where it was taken.
template <class Segment>
struct Inserted {
  Segment segment;
  unsigned wrong, taken;
};

/// The k-buffer of a group's pixels.
template <class Lanes, int K, template <class> class PayloadOf>
class EntriesOfPixels {
 public:
  using A = Arithmetic<Lanes, K, PayloadOf>;
  using Stored = StoredFragment<A, Lanes>;
  static constexpr bool kFlagsWrong = false;  ///< wrong fragments are late: counted
  static constexpr int kNumbers = 2 + K * Stored::kNumbers;

  explicit EntriesOfPixels(float* state) : state_(state) {}

  void begin() {
    storePixel({Real(0.0f), Real(0.0f)});
    for (int i = 0; i < K; ++i) Stored::store(entryAt(i), A::emptyFragment());
  }

  Inserted<typename A::Segment> insert(const typename A::Fragment& incoming, unsigned bits, const TileDraw& tile) {
    typename A::KBuffer kbuffer = entries();
    typename A::PixelState pixel = loadPixel();
    Inserted<typename A::Segment> done;
    done.wrong = bits & Lanes::bitsOf(A::isLate(kbuffer, pixel, incoming));
    done.taken = bits;
    if (done.wrong != 0 && !tile.compositeLate) {
      pixel.inside = Lanes::select(Lanes::maskOf(done.wrong), pixel.inside + A::kindOf(incoming.payload), pixel.inside);
      Lanes::store(state_, pixel.inside);
      done.taken &= ~done.wrong;
      if (done.taken == 0) return done;
    }
    const Mask mask = Lanes::maskOf(done.taken);
    const typename A::KBuffer before = kbuffer;
    const typename A::PixelState pixelBefore = pixel;
    typename A::Fragment front;
    A::insertFragment(kbuffer, incoming, Real(tile.sameDistance), front);
    done.segment = A::leaveBefore(pixel, front, kbuffer);
    storePixel({Lanes::select(mask, pixel.inside, pixelBefore.inside),
                Lanes::select(mask, pixel.started, pixelBefore.started)});
    for (int i = 0; i < K; ++i) Stored::store(entryAt(i), A::selectFragment(mask, kbuffer.entry[i], before.entry[i]));
    return done;
  }

  /// What is left leaves in order.
  template <class Take>
  void finish(const Take& take) {
    typename A::KBuffer kbuffer = entries();
    typename A::PixelState pixel = loadPixel();
    for (int i = 0; i + 1 < K; ++i) {
      const typename A::Fragment nearest = A::takeNearest(kbuffer);
      take(A::leaveBefore(pixel, nearest, kbuffer));
    }
  }

 private:
  using Real = typename Lanes::Real;
  using Mask = typename Lanes::Mask;

  float* entryAt(int i) const { return state_ + (2 + i * Stored::kNumbers) * kStampPixels; }
  typename A::KBuffer entries() const {
    typename A::KBuffer kbuffer;
    for (int i = 0; i < K; ++i) kbuffer.entry[i] = Stored::load(entryAt(i));
    return kbuffer;
  }
  typename A::PixelState loadPixel() const {
    typename A::PixelState pixel;
    pixel.inside = Lanes::load(state_);
    pixel.started = Lanes::load(state_ + kStampPixels);
    return pixel;
  }
  void storePixel(const typename A::PixelState& pixel) {
    Lanes::store(state_, pixel.inside);
    Lanes::store(state_ + kStampPixels, pixel.started);
  }

  float* state_;
};

/// Pixels whose fragments come in order: only the last one is kept. One that comes nearer is wrong, or leaves a part of
/// the mesh where another has been entered, or one that has not been, and its pixel flagged; in all others every k
/// gives the same segments, to the last bit.
template <class Lanes, template <class> class PayloadOf>
class LastOfPixels {
 public:
  using A = Arithmetic<Lanes, 1, PayloadOf>;
  using Stored = StoredFragment<A, Lanes>;
  static constexpr bool kFlagsWrong = true;
  static constexpr int kNumbers = Stored::kNumbers;

  explicit LastOfPixels(float* state) : state_(state) {}

  void begin() { Stored::store(state_, A::emptyFragment()); }

  Inserted<typename A::Segment> insert(typename A::Fragment incoming, unsigned bits, const TileDraw& tile) {
    // Kept with a fragment is not its kind but the inside-count behind it, which leave() then gives back.
    const typename A::Fragment last = Stored::load(state_);
    Inserted<typename A::Segment> done;
    // Of orderBoundaries (core/kbuffer.glsl): an exit that may have to go before an entry at its place, or behind it.
    const Mask within = (last.payload.kind > Real(1.5f)) && (incoming.payload.kind < Real(-0.5f));
    const Mask outside = (last.payload.kind < Real(-0.5f)) && (incoming.payload.kind > Real(0.5f));
    const Mask touches = (within || outside) && (incoming.distance - last.distance < Real(A::kLateTolerance));
    done.wrong =
        bits & (Lanes::bitsOf(incoming.distance < last.distance - Real(tile.sameDistance)) | Lanes::bitsOf(touches));
    incoming.distance = Lanes::most(incoming.distance, last.distance);
    done.taken = bits & ~done.wrong;
    incoming.payload.kind = last.payload.kind + incoming.payload.kind;
    typename A::PixelState nowhere{Real(0.0f), Real(0.0f)};
    done.segment = A::leave(nowhere, last, incoming);
    Stored::store(state_, A::selectFragment(Lanes::maskOf(done.taken), incoming, last));
    return done;
  }

  template <class Take>
  void finish(const Take&) {}

 private:
  using Real = typename Lanes::Real;
  using Mask = typename Lanes::Mask;
  float* state_;
};

}  // namespace
}  // namespace havs
