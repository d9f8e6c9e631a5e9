#pragma once

namespace havs::test {

/// Whether this build runs under a sanitizer whose own memory is many times the program's.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace havs::test
