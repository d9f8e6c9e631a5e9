// Portable float maps.
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const auto file = fuzz::asFile("picture.pfm", fuzz::textOf(data, size));
  fuzz::readOrRefuse([&] { fuzz::requireSound(readImage(file)); });
  return 0;
}
