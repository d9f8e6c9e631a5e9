#pragma once
// Both senses of a stretch at once: premultiplied colour and opacity with its low scalar in front, then with its high
// scalar in front. Eight doubles that the compiler keeps in the vector registers of the processor.
#include <array>
#include <cstring>

namespace havs {

/// As they lie in memory: r g b a, r g b a.
struct alignas(64) Lanes {
  std::array<double, 8> value;
};

/// As they are calculated with. Only inside of functions: how it is handed over differs between processors.
using LaneVector = double __attribute__((vector_size(64)));

inline __attribute__((always_inline)) void load(const Lanes& from, LaneVector& to) {
  std::memcpy(&to, from.value.data(), sizeof to);
}
inline __attribute__((always_inline)) void store(const LaneVector& from, Lanes& to) {
  std::memcpy(to.value.data(), &from, sizeof from);
}

// Functions that work on LaneVector are compiled for each of these and chosen when the program starts. Products and
// sums are not joined (-ffp-contract=off), so that all give the same bits.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HAVS_FOR_WIDEST_LANES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HAVS_FOR_WIDEST_LANES
#endif

}  // namespace havs
