// TetGen's .poly and .smesh, each input read as both; what stands behind a line %% is the .node beside.
#include "fuzz/surfaces.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const std::string_view text = fuzz::textOf(data, size);
  const std::size_t cut = text.find("%%\n");
  fuzz::asFile("surface.node", cut == std::string_view::npos ? "" : text.substr(cut + 3));
  fuzz::readSurface("surface.poly", text.substr(0, cut), readPolySurface);
  return fuzz::readSurface("surface.smesh", text.substr(0, cut), readPolySurface);
}
