#include <cstdio>

#include "app/command_line.h"
#include "app/report_failure.h"
#include "app/signals.h"

int main(int argc, char** argv) {
  havs::keepStandardStreams();
  havs::tellOfCrashes();
  havs::stopOnSignals();
  try {
    havs::runCommandLine(argc, argv);
    return std::fflush(stdout) == 0 ? 0 : havs::reportFailedPrinting();
  } catch (...) {
    return havs::reportFailure();
  }
}
