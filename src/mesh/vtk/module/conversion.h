#pragma once
#include <vtkDataObject.h>

#include "mesh/vtk/vtk_module.h"

namespace havs {

/// Hands the grids in `data` (a data set, or blocks of them) to the sink: three-dimensional cells that are not ghosts,
/// and every numeric array at points and cells. What is left out is noted. Throws std::runtime_error, one phrase, when
/// there is no volume in it.
void convert(vtkDataObject& data, GridSink& sink);

}  // namespace havs
