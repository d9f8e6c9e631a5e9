#pragma once
#include "core/sanitized.h"

namespace havs::test {

/// Whether this build runs under a sanitizer whose own memory is many times the program's.
#ifdef HAVS_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace havs::test
