#pragma once
// HAVS_SANITIZED: the build is under the address or thread sanitizer. Their shadow memory is larger than any machine,
// so that memory cannot be limited, and they tell of crashes themselves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAVS_SANITIZED 1
#elif defined(__clang__)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAVS_SANITIZED 1
#endif
#endif
