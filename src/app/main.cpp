#include <algorithm>
#include <cstdio>
#include <new>
#include <string>

#include "app/command_line.h"
#include "core/error.h"

namespace {

int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fprintf(stderr, "havs: %s\n", message.c_str());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    havs::runCommandLine(argc, argv);
    if (std::fflush(stdout) != 0) return fail("standard output cannot be written", 1);
    return 0;
  } catch (const havs::Error& error) {
    return fail(error.what(), error.exitStatus());
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}
