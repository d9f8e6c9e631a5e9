// PNG pictures, and masks.
#include "fuzz/fuzz.h"
#include "image/mask.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const auto file = fuzz::asFile("picture.png", fuzz::textOf(data, size));
  fuzz::readOrRefuse([&] { fuzz::requireSound(readImage(file)); });
  fuzz::readOrRefuse([&] {
    int width = 0, height = 0;
    const auto mask = readMask(file, width, height);
    fuzz::require(mask.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "a mask is whole");
  });
  return 0;
}
