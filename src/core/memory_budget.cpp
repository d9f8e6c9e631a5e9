#include "core/memory_budget.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <string_view>

#include "core/error.h"

namespace havs {
namespace {

std::atomic<std::size_t> limit = 0;  // 0: the machine's

std::size_t machineBytes() {
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// What the process has in memory now: the second number of its statm, in pages.
double residentBytes() {
  std::size_t pages = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%*u %zu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Of a unit, as "M", "MB" or "MiB" in either case; 0: it is none.
double unitBytes(std::string_view unit) {
  constexpr std::string_view kLetters = "BKMGT";
  if (unit.empty()) return 1;
  const std::size_t power = kLetters.find(static_cast<char>(std::toupper(static_cast<unsigned char>(unit[0]))));
  const std::string_view rest = unit.substr(1);
  const bool known = rest.empty() || (power > 0 && (rest == "B" || rest == "b" || rest == "iB" || rest == "ib"));
  return power == std::string_view::npos || !known ? 0 : static_cast<double>(std::size_t{1} << (10 * power));
}

/// "24.0 GB", in the units that parseMemorySize reads.
std::string shown(double bytes) {
  const char* unit = "bytes";
  for (const char* larger : {"KB", "MB", "GB", "TB"}) {
    if (bytes < 1024) break;
    bytes /= 1024;
    unit = larger;
  }
  return fmt::format("{:.{}f} {}", bytes, bytes < 10 ? 1 : 0, unit);
}

}  // namespace

std::size_t parseMemorySize(const std::string& text, const std::string& option) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const double bytes = error == std::errc{} ? number * unitBytes({rest, static_cast<std::size_t>(end - rest)}) : 0;
  constexpr double kMost = 0x1p62;
  if (!(bytes >= 1 && bytes <= kMost))
    failInput(fmt::format("'{}' is no amount of memory", text), option, "write 500M or 8G");
  return static_cast<std::size_t>(bytes);
}

std::size_t memoryLimit() { return limit > 0 ? limit.load() : machineBytes(); }
void limitMemory(std::size_t bytes) { limit = bytes; }

void needMemory(double bytes, const std::string& what, const std::string& where, const std::string& tryThis) {
  constexpr double kNotWorthAsking = 1 << 20;
  if (bytes < kNotWorthAsking) return;
  const auto most = static_cast<double>(memoryLimit());
  const double taken = residentBytes();
  if (bytes + taken <= most) return;
  const std::string have = limit > 0 ? "--max-memory is " + shown(most) : "this machine has " + shown(most);
  const std::string advice = tryThis.empty() ? "" : tryThis + ", or ";
  failInput(fmt::format("{} needs {} of memory, but {}, of which {} are taken", what, shown(bytes), have, shown(taken)),
            where, advice + (limit > 0 ? "raise --max-memory" : "use a machine with more"));
}

}  // namespace havs
