#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Makes the error for the character at `index` of the parsed text.
using ErrorAt = std::function<tl::unexpected<Error>(std::size_t index, std::string const& what)>;

// A character constant of an #if expression. As in gcc it has up to four characters, one byte each.
struct CharacterConstant {
    std::int32_t value = 0;
    std::size_t end = 0; // Index of the character after the closing quote.
};

// Parses the character constant whose opening quote is at index `at`; no value if there is none.
std::optional<CharacterConstant> character_constant(std::string_view text, std::size_t at);

// Evaluates the expression of an #if whose macros have been replaced (C11 6.10.1). Numbers are
// signed and unsigned 64-bit integers; all operators of C but the comma are supported; the
// remaining names are 0. Arithmetic wraps around. Fails with `error` for an invalid expression.
Result<std::int64_t> condition_value(std::string_view text, ErrorAt const& error);

} // namespace tractus::lsystem
