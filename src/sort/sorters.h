#pragma once
// The sorters behind the table of face_order.cpp, one file each.
#include "sort/face_order.h"

namespace havs {

std::unique_ptr<FaceSorter> makeCentroidSorter(const SortInput& input);
std::unique_ptr<FaceSorter> makeTopologicalSorter(const SortInput& input);
std::unique_ptr<FaceSorter> makeExactSorter(const SortInput& input);
std::unique_ptr<FaceSorter> makeFileOrderSorter(const SortInput& input);

}  // namespace havs
