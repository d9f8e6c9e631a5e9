#include "sort/face_order.h"

#include <array>

#include "core/find_row.h"
#include "sort/sorters.h"

namespace havs {
namespace {

/// The table of orders. A new one is a row here and a file beside this one.
const std::array<SortMethod, 4> kSortMethods{{
    {"topological", "depth-first order of the cells by which is in front of which; exact but for cycles and gaps",
     makeTopologicalSorter, true, true},
    {"centroid", "the paper's: radix sort by the distance of the faces' centroids", makeCentroidSorter},
    {"exact", "comparison sort by the distance of the faces' centroids in double: the oracle of centroid",
     makeExactSorter},
    {"none", "the faces as they are numbered; right only where all fragments of a pixel fit into the k-buffer",
     makeFileOrderSorter},
}};

}  // namespace

std::span<const SortMethod> sortMethods() { return kSortMethods; }

const SortMethod& sortMethod(const std::string& name) { return findRow(sortMethods(), name, "order of faces", "sort"); }

}  // namespace havs
