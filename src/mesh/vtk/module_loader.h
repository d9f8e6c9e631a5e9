#pragma once
#include "mesh/vtk/vtk_module.h"

namespace havs {

/// Address of a symbol of the VTK module, which is opened now: from the folder $HAVS_MODULES, else from lib/havs beside
/// the program's bin, else from where it was built. For use in a child process (isolated.h). Throws Error{running} when
/// it cannot be opened.
void* vtkModuleSymbol(const char* name);

}  // namespace havs
