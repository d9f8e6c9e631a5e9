// AVS UCD, ASCII.
#include "fuzz/fuzz.h"
#include "mesh/formats.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const auto file = fuzz::asFile("mesh.inp", fuzz::textOf(data, size));
  fuzz::readOrRefuse([&] { fuzz::requireSound(readUcd(file, {})); });
  return 0;
}
