#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Makes an error for a character of the text that is read.
using ErrorAt = std::function<tl::unexpected<Error>(std::size_t index, std::string const& what)>;

// A character between apostrophes, as #if may compare it: up to four, of which each is a byte, as
// in gcc.
struct CharacterConstant {
    std::int32_t value = 0;
    std::size_t end = 0; // Behind the second apostrophe.
};

// The constant whose first apostrophe is at `at`; no value where there is none.
std::optional<CharacterConstant> character_constant(std::string_view text, std::size_t at);

// The value of an #if's expression (C11 6.10.1) in which macros have been replaced: 64-bit
// integers, with sign or without, and all of C's operators but the comma; names are 0. Arithmetic
// wraps around. Fails with `error` where it is no such expression.
Result<std::int64_t> condition_value(std::string_view text, ErrorAt const& error);

} // namespace tractus::lsystem
