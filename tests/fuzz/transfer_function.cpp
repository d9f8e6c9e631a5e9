// Transfer functions as text: our JSON, ParaView's JSON and XML, told apart by content as loadTransferFunction does.
#include "fuzz/transfer_functions.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  return fuzz::readTransferFunction(fuzz::asFile("function.json", fuzz::textOf(data, size)));
}
