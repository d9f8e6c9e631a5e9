#pragma once
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

#include <vector>

#include "mesh/vtk/vtk_module.h"

namespace havs {

/// All values of the array in double, one tuple after another.
std::vector<double> valuesOf(vtkDataArray& array);

/// Every numeric array, in double, but not the ghost flags; `kind` ("point", "cell") serves the notes about arrays that
/// are left out. Throws std::runtime_error when an array has not `tuples` tuples.
std::vector<Field> fieldsOf(vtkDataSetAttributes& attributes, std::size_t tuples, const std::string& kind,
                            GridSink& sink);

}  // namespace havs
