// Which of its two runs this is: gcc defines __SANITIZE_ADDRESS__, clang says it otherwise.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif
