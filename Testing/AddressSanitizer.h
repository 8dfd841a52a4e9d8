// Whether AddressSanitizer is compiled in. It reserves terabytes of addresses, and keeps memory
// that was freed, so that limits of memory do not hold.
#ifndef AddressSanitizer_h
#define AddressSanitizer_h

#ifdef __SANITIZE_ADDRESS__ // GCC
constexpr bool hasAddressSanitizer = true;
#elif defined(__has_feature) // clang
constexpr bool hasAddressSanitizer = __has_feature(address_sanitizer);
#else
constexpr bool hasAddressSanitizer = false;
#endif

#endif
