#pragma once
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// Merges points whose coordinates are bit-identical (-0 equals 0) and whose data in `pointFields` are too: the first
/// of them stays, the order is kept. Returns for each old point its new number; empty when no two points were alike.
std::vector<Index> mergeIdenticalPoints(std::vector<Vec3>& points, std::vector<Field>& pointFields);

/// Keeps the points with keep[i] != 0, in their order, with their data. Returns for each old point its new number,
/// kNoIndex for one that went.
std::vector<Index> keepPoints(const std::vector<char>& keep, std::vector<Vec3>& points,
                              std::vector<Field>& pointFields);

/// Keeps the tuples with keep[i] != 0, in their order.
void keepTuples(const std::vector<char>& keep, Field& field);

}  // namespace havs
