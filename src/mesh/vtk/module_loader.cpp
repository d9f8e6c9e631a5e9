#include "mesh/vtk/module_loader.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/error.h"
#include "core/library_advice.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> candidates() {
  constexpr const char* kName = "libhavs_vtk.so";
  if (const char* folder = std::getenv("HAVS_MODULES")) return {fs::path(folder) / kName};
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  return {program.parent_path().parent_path() / HAVS_MODULE_FOLDER / kName, HAVS_BUILT_MODULE};
}

void* openModule() {
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);  // the pool of threads is the parent's
  std::string problems;
  // Lazy: of a hundred libraries one reader is used, and binding all their symbols costs a third of the loading.
  for (const fs::path& file : candidates()) {
    if (void* module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL)) return module;
    problems += (problems.empty() ? "" : "; ") + std::string(dlerror());
  }
  failRunning("the module that reads VTK's formats cannot be opened (" + problems + ")", "",
              libraryAdvice(problems, "set HAVS_MODULES to the folder of libhavs_vtk.so"));
}

}  // namespace

void* vtkModuleSymbol(const char* name) {
  static void* const module = openModule();
  void* symbol = dlsym(module, name);
  if (!symbol) failRunning("the VTK module is of another version of havs: it has no " + std::string(name));
  return symbol;
}

}  // namespace havs
