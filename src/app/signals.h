#pragma once

namespace havs {

/// Gives a standard stream that is closed the file /dev/null, opened so that writing fails: else a file that is opened
/// next would take its number, and what is printed would land there.
void keepStandardStreams();

/// From here on the process ends with 128 + the signal (129, 130, 143) when the terminal goes (SIGHUP), at Ctrl-C
/// (SIGINT) and when it is asked to (SIGTERM), with no half file, after one line that says what is written so far; a
/// signal that is ignored at the start stays so. A file beyond the limit of sizes (SIGXFSZ) becomes an error of
/// writing. Called before other threads start, as they inherit it.
void stopOnSignals();

/// From here on an exception that nobody catches is told as any other, and a crash in one line. Where memory is limited
/// it is memory that a library (OpenGL's driver) asked for in vain: exit status 1. Else the process ends by the signal,
/// for a debugger. Needs no memory by then.
void tellOfCrashes();

}  // namespace havs
