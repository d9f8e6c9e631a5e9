#pragma once
// HAVS_SANITIZED: the build is under the address or thread sanitizer. Their shadow memory is larger than any machine,
// so that memory cannot be limited, and they tell of crashes themselves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAVS_SANITIZED 1
#endif
