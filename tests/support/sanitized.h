#pragma once

// Defined by the run-time library of the address sanitizer, in programs linked with it.
extern "C" void __asan_init() __attribute__((weak));

namespace viewcover::testing {

/// True iff this program is linked to the sanitized twin of the library, where a part of the
/// slowest tests is enough: the same objects of tests are linked to both (tests/CMakeLists.txt).
inline bool sanitized() { return __asan_init != nullptr; }

}  // namespace viewcover::testing
