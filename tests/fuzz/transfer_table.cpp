// TF.bin: the input is repeated until it has the table's size, unless it begins with a bang, which is taken off.
#include <string>

#include "fuzz/transfer_functions.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  std::string bytes(fuzz::textOf(data, size));
  if (bytes.starts_with('!')) {
    bytes.erase(0, 1);
  } else if (!bytes.empty()) {
    while (bytes.size() < kTableBytes) bytes += bytes.substr(0, kTableBytes - bytes.size());
  }
  return fuzz::readTransferFunction(fuzz::asFile("TF.bin", bytes));
}
