#pragma once

#include <string>
#include <tl/expected.hpp>
#include <type_traits>
#include <utility>

namespace tractus {

// Says who has to act to resolve an error.
enum class Fault {
    User,    // The command line, a file or a permission must be corrected.
    Device,  // Hardware or firmware violated its own protocol.
    Station, // This program has a bug.
};

struct Error {
    Fault fault = Fault::Station;
    std::string message; // One sentence: what failed, on which device or file, and what to do.
};

// A value or the error that explains why there is none. The compiler warns if a Result is ignored.
template<typename T> class [[nodiscard]] Result : public tl::expected<T, Error> {
public:
    using tl::expected<T, Error>::expected;
};

inline tl::unexpected<Error> fail(Fault fault, std::string message)
{
    return tl::unexpected<Error>(Error { fault, std::move(message) });
}

namespace detail {

template<typename T> T take(Result<T>&& result)
{
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

template<typename T> T take(Result<T>& result)
{
    return take(std::move(result));
}

} // namespace detail

// Evaluates to the value of a Result; if there is none, returns its error from the enclosing
// function. Uses a statement expression (g++ and clang). Do not nest it: -Wshadow rejects that.
#define TRY(expression)                                                                            \
    __extension__({                                                                                \
        auto&& try_result = (expression);                                                          \
        if (!try_result)                                                                           \
            return tl::unexpected(std::move(try_result).error());                                  \
        ::tractus::detail::take(std::move(try_result));                                            \
    })

} // namespace tractus
