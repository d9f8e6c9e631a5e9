#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/error.h"
#include "transfer/transfer_files.h"

namespace havs {
namespace {

static_assert(std::endian::native == std::endian::little, "TF.bin holds little-endian floats");

using Entry = std::array<float, 4>;
constexpr double kTolerance = 1e-6;

std::vector<Entry> readEntries(std::string_view bytes, const std::string& file) {
  if (bytes.size() != kTableBytes) {
    failInput(fmt::format("has {} bytes, not the {} of 65,536 RGBA floats", bytes.size(), kTableBytes), file);
  }
  std::vector<Entry> entries(kTableEntries);
  std::memcpy(entries.data(), bytes.data(), kTableBytes);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (float channel : entries[i]) {
      if (!(channel >= 0 && channel <= 1))
        failInput(fmt::format("value {} is outside [0, 1]", channel), fmt::format("{}, entry {}", file, i));
    }
  }
  return entries;
}

/// The slopes of all lines from one entry that pass later ones within the tolerance in every channel.
class Funnel {
 public:
  explicit Funnel(const Entry& apex) : apex_(apex) {}

  bool holds(const Entry& entry, double steps) const {
    for (std::size_t c = 0; c < 4; ++c) {
      const double slope = (double{entry[c]} - apex_[c]) / steps;
      if (slope < lowest_[c] || slope > highest_[c]) return false;
    }
    return true;
  }
  void narrow(const Entry& entry, double steps) {
    for (std::size_t c = 0; c < 4; ++c) {
      const double rise = double{entry[c]} - apex_[c];
      lowest_[c] = std::max(lowest_[c], (rise - kTolerance) / steps);
      highest_[c] = std::min(highest_[c], (rise + kTolerance) / steps);
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Entry apex_;
  std::array<double, 4> lowest_{-kInfinity, -kInfinity, -kInfinity, -kInfinity};
  std::array<double, 4> highest_{kInfinity, kInfinity, kInfinity, kInfinity};
};

ControlPoint controlPoint(const Entry& e, std::size_t index) {
  return {static_cast<double>(index) / (kTableEntries - 1), {e[0], e[1], e[2]}, e[3]};
}

}  // namespace

TransferFunction readTransferTable(std::string_view bytes, const std::string& file) {
  const std::vector<Entry> entries = readEntries(bytes, file);
  TransferFunction function;
  function.points.push_back(controlPoint(entries[0], 0));
  std::size_t apex = 0;
  Funnel funnel(entries[0]);
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (!funnel.holds(entries[i], static_cast<double>(i - apex))) {
      apex = i - 1;
      function.points.push_back(controlPoint(entries[apex], apex));
      funnel = Funnel(entries[apex]);
    }
    funnel.narrow(entries[i], static_cast<double>(i - apex));
  }
  function.points.push_back(controlPoint(entries.back(), entries.size() - 1));
  return function;
}

}  // namespace havs
