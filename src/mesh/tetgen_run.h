#pragma once
#include <string>

#include "mesh/tetgen_surface.h"

namespace havs {

/// Fills the surface by TetGen's library, in a child process: TetGen prints, and on some input aborts or crashes.
/// `command` is from tetgenCommand. Throws Error{input} that says what TetGen holds against the surface (`where`),
/// Error{running} when out of memory.
TetMesh runTetgen(const Surface& surface, const std::string& command, const std::string& where);

}  // namespace havs
