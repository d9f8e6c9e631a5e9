#pragma once

namespace havs {

/// Tells on standard error, in one line, what the exception says that is being handled. Returns the exit status.
int reportFailure();
/// The same of standard output that could not be written.
int reportFailedPrinting();

}  // namespace havs
