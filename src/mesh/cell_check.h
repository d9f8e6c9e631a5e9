#pragma once
#include <string>

#include "mesh/cells.h"

namespace havs {

/// Throws Error{input} unless the arrays of `cells` fit each other, every type is one that can be cut or left out,
/// every cell has as many points as its type wants, and every point number exists. Names the first such cell.
void checkCells(const CellSoup& cells, const std::string& where);

/// Throws Error{input} unless each field has `wanted` tuples; `what` are "points" or "cells".
void checkFields(const std::vector<Field>& fields, std::size_t wanted, const char* what, const std::string& where);

}  // namespace havs
