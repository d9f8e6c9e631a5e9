#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "app/command_line.h"
#include "app/signals.h"
#include "core/error.h"

namespace {

int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fprintf(stderr, "havs: %s\n", message.c_str());
  return status;
}

int failPrinting() { return fail(std::string("standard output cannot be written: ") + std::strerror(errno), 1); }

/// Exceptions that others throw are short of words.
int failUnexpected(const std::exception& error) {
  if (std::ferror(stdout) != 0) return failPrinting();  // fmt's
  const std::string text = error.what();
  if (text.find("pthread_create") != std::string::npos)  // oneTBB's
    return fail("no more threads can be started (" + text + "); raise the limits (ulimit -u, -v), or try --threads 1",
                1);
  return fail(text, 1);
}

}  // namespace

int main(int argc, char** argv) {
  havs::keepStandardStreams();
  havs::tellOfCrashes();
  havs::stopOnSignals();
  try {
    havs::runCommandLine(argc, argv);
    return std::fflush(stdout) == 0 ? 0 : failPrinting();
  } catch (const havs::Error& error) {
    return fail(error.what(), error.exitStatus());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; raise its limit (ulimit -v), or try a smaller --size, --table or mesh", 1);
  } catch (const std::exception& error) {
    return failUnexpected(error);
  }
}
