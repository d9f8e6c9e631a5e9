// Stanford's PLY: the surface that TetGen fills.
#include "fuzz/surfaces.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  return fuzz::readSurface("surface.ply", fuzz::textOf(data, size), readPlySurface);
}
