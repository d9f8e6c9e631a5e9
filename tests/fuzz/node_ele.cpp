// TetGen's .node and .ele: the two files stand in the input one behind the other, a line %% between them.
#include "fuzz/fuzz.h"
#include "mesh/formats.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  const std::string_view text = fuzz::textOf(data, size);
  const std::size_t cut = text.find("%%\n");
  const auto node = fuzz::asFile("mesh.node", text.substr(0, cut));
  fuzz::asFile("mesh.ele", cut == std::string_view::npos ? "" : text.substr(cut + 3));
  fuzz::readOrRefuse([&] { fuzz::requireSound(readNodeEle(node, {})); });
  return 0;
}
