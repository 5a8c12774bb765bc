#pragma once

namespace tractus::detail {

[[noreturn]] void check_failed(char const* expression, char const* file, int line);

} // namespace tractus::detail

// CHECK guards against programming errors, in every build: if the condition is false it prints the
// condition and its source position, then aborts. Errors that a device, a file or a user can cause
// are reported by a Result instead.
#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) [[unlikely]]                                                             \
            ::tractus::detail::check_failed(#condition, __FILE__, __LINE__);                       \
    } while (false)
