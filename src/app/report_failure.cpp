#include "app/report_failure.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "core/error.h"

namespace havs {
namespace {

int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fprintf(stderr, "havs: %s\n", message.c_str());
  return status;
}

/// Exceptions that others throw are short of words.
int failUnexpected(const std::string& text) {
  if (std::ferror(stdout) != 0) return reportFailedPrinting();  // fmt's
  if (text.find("pthread_create") != std::string::npos)         // oneTBB's
    return fail("no more threads can be started (" + text + "); raise the limits (ulimit -u, -v), or try --threads 1",
                1);
  return fail(text, 1);
}

}  // namespace

int reportFailedPrinting() {
  return fail(std::string("standard output cannot be written: ") + std::strerror(errno), 1);
}

int reportFailure() {
  try {
    throw;
  } catch (const Error& error) {
    return fail(error.what(), error.exitStatus());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; raise its limit (ulimit -v), or try a smaller --size, --table or mesh", 1);
  } catch (const std::exception& error) {
    return failUnexpected(error.what());
  } catch (...) {
    return fail("an exception of unknown type", 1);
  }
}

}  // namespace havs
