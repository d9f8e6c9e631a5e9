#include "gl/shared_library.h"

#include <dlfcn.h>

#include "core/error.h"
#include "core/library_advice.h"

namespace havs {

SharedLibrary::SharedLibrary(std::span<const char* const> names, const std::string& tryThis) {
  std::string reason;
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_) {
      name_ = name;
      return;
    }
    if (reason.empty()) reason = dlerror();
  }
  failRunning("cannot open " + std::string(names.front()) + " (" + reason + ")", "", libraryAdvice(reason, tryThis));
}

void* SharedLibrary::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (!address)
    failRunning(name_ + " has no function " + name, "",
                "it may be too old; try another --device (native needs no library)");
  return address;
}

}  // namespace havs
