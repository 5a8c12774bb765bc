#pragma once

#include "engine/base/time.h"

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tractus::drivers {

// Reads one line of a device log from left to right. Each member function except plain_bytes()
// skips blanks first. Those that return a bool return false if the line does not continue with what
// they read.
class LogLine {
public:
    explicit LogLine(std::string_view line)
        : at_(line.data())
        , end_(line.data() + line.size())
    {
    }

    template<typename Integer> bool integer(Integer& value, int base)
    {
        skip_blanks();
        auto const [next, error] = std::from_chars(at_, end_, value, base);
        if (error != std::errc())
            return false;
        at_ = next;
        return true;
    }

    // Reads seconds with any number of decimals; digits beyond nanoseconds are cut off.
    bool time(Timestamp& time);

    // Appends `size` bytes in LogWriter's notation, a blank and two digits for each, up to the
    // line's end. Returns false, and appends nothing, for any other text.
    bool plain_bytes(std::size_t size, std::vector<std::byte>& bytes);

    // Appends all bytes up to the line's end. Returns false if anything else follows.
    bool hex_bytes(std::vector<std::byte>& bytes);

    std::string_view word();
    std::string_view rest();

    // Returns the rest of the line with the "\xHH" escapes of LogWriter decoded. A backslash that
    // begins no escape is kept.
    std::string unescaped_rest();

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t'; }
    void skip_blanks()
    {
        while (at_ != end_ && is_blank(*at_))
            ++at_;
    }

    char const* at_;
    char const* end_;
};

} // namespace tractus::drivers
