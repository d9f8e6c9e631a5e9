#pragma once

namespace havs {

/// Reads the command line and runs the command that it names. Throws Error{input} when it is wrong (an unknown option
/// names the nearest), and whatever the command throws.
void runCommandLine(int argc, char** argv);

}  // namespace havs
