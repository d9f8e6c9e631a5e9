#pragma once
#include <string>

namespace havs {

/// TetGen's command for a surface: `switches` ("pq1.4a0.01", with or without a dash before), with p (fill a surface)
/// where it lacks and without Q (quiet), as what TetGen prints is kept from the terminal and says what is wrong. TetGen
/// itself passes over what it does not know, and may run for ever on what makes no sense: throws Error{input} for an
/// unknown switch (naming the known ones), a number that is none or out of range, and switches that make anything but
/// linear tetrahedra of a surface.
std::string tetgenCommand(const std::string& switches);

}  // namespace havs
