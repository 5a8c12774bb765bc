#pragma once

#include "engine/base/check.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace tractus {

// The input from libFuzzer, in the form that the parsers need.
class FuzzInput {
public:
    FuzzInput(std::uint8_t const* data, std::size_t size)
        : text_(reinterpret_cast<char const*>(data), size)
    {
    }

    std::string_view text() const { return text_; }
    std::span<std::byte const> bytes() const { return std::as_bytes(std::span(text_)); }

    // Removes a byte and returns it, or returns 0 if none is left. Fuzzers of several parsers
    // choose the parser by this byte.
    unsigned take_byte()
    {
        if (text_.empty())
            return 0;
        auto const byte = static_cast<unsigned char>(text_.front());
        text_.remove_prefix(1);
        return byte;
    }

    // Removes the text up to and including the first zero byte, and returns it without the zero
    // byte. If there is no zero byte, removes and returns the whole text.
    std::string_view take_part()
    {
        auto const end = text_.find('\0');
        auto const part = text_.substr(0, end);
        text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
        return part;
    }

private:
    std::string_view text_;
};

// True if the input was read. Otherwise the error must be a user error of one sentence.
template<typename T> bool is_read(Result<T> const& result)
{
    if (result)
        return true;
    CHECK(result.error().fault == Fault::User);
    CHECK(!result.error().message.empty());
    return false;
}

} // namespace tractus
