// The fast reader of .vtu; what it declines goes to VTK, in a process of its own, and is not fuzzed here.
#include "fuzz/fuzz.h"
#include "mesh/vtu/vtu_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const auto file = fuzz::asFile("mesh.vtu", fuzz::textOf(data, size));
  fuzz::readOrRefuse([&] {
    if (const auto mesh = readPlainVtu(file)) fuzz::requireSound(*mesh);
  });
  return 0;
}
