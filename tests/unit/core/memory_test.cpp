#include "core/memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace havs {
namespace {

TEST(PeakMemory, GrowsByWhatIsTouched) {
  const std::size_t before = peakMemoryBytes();
  constexpr std::size_t kBytes = 256u << 20;  // far more than the process holds so far
  const std::vector<char> block(kBytes, 1);
  EXPECT_GE(peakMemoryBytes(), before + kBytes / 2 + static_cast<std::size_t>(block[kBytes / 2]));
}

TEST(CpuSeconds, GrowsWithWork) {
  const double before = cpuSeconds();
  volatile double sum = 0;
  while (cpuSeconds() - before < 0.01) sum = sum + 1;
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace havs
