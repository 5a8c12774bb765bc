#pragma once

namespace tractus::detail {

[[noreturn]] void check_failed(char const* expression, char const* file, int line);

} // namespace tractus::detail

// CHECK is for our own mistakes, in every build: prints the condition and its place, then aborts.
// It is never for what a device, a file or a user can do: that is a Result.
#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) [[unlikely]]                                                             \
            ::tractus::detail::check_failed(#condition, __FILE__, __LINE__);                       \
    } while (false)
