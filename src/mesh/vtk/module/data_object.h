#pragma once
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include "mesh/vtk/vtk_module.h"

namespace havs {

/// The data that VTK's reader of this format makes of the file, with all its arrays, at the last time step (the note
/// says which). Null when the reader makes none. Throws std::runtime_error for an extension it does not know.
vtkSmartPointer<vtkDataObject> readDataObject(const GridRequest& request, GridSink& sink);

}  // namespace havs
