#include "mesh/vtk/module/fields.h"

#include <vtkAbstractArray.h>
#include <vtkSetGet.h>

#include <algorithm>
#include <stdexcept>

namespace havs {

std::vector<double> valuesOf(vtkDataArray& array) {
  std::vector<double> values(static_cast<std::size_t>(array.GetNumberOfValues()));
  const auto components = static_cast<std::size_t>(array.GetNumberOfComponents());
  switch (array.GetDataType()) {
    vtkTemplateMacro(std::copy_n(static_cast<const VTK_TT*>(array.GetVoidPointer(0)), values.size(), values.begin()));
    default:  // packed bits
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = array.GetComponent(static_cast<vtkIdType>(i / components), static_cast<int>(i % components));
  }
  return values;
}

std::vector<Field> fieldsOf(vtkDataSetAttributes& attributes, std::size_t tuples, const std::string& kind,
                            GridSink& sink) {
  std::vector<Field> fields;
  for (int i = 0; i < attributes.GetNumberOfArrays(); ++i) {
    vtkAbstractArray* any = attributes.GetAbstractArray(i);
    const std::string name = any->GetName() ? any->GetName() : kind + std::to_string(i);
    vtkDataArray* array = vtkDataArray::SafeDownCast(any);
    if (name == vtkDataSetAttributes::GhostArrayName()) continue;
    if (!array || array->GetNumberOfComponents() < 1) {
      sink.note("left out the " + kind + " array '" + name + "', which is not numeric");
      continue;
    }
    if (static_cast<std::size_t>(array->GetNumberOfTuples()) != tuples)
      throw std::runtime_error("the " + kind + " array '" + name + "' has " +
                               std::to_string(array->GetNumberOfTuples()) + " tuples for " + std::to_string(tuples) +
                               " " + kind + "s");
    fields.push_back({name, array->GetNumberOfComponents(), valuesOf(*array)});
  }
  return fields;
}

}  // namespace havs
