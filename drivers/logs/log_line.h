#pragma once

#include "engine/base/time.h"

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tractus::drivers {

// Reads one line of a device log from left to right. Each reader skips blanks first and says
// whether it found what it was asked for.
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

    // Seconds with a fraction of any length; what is finer than a nanosecond is cut off.
    bool time(Timestamp& time);

    // Appends the `size` bytes of a line written as LogWriter does: each a blank and two digits,
    // and nothing else. False, and nothing appended, if it is not.
    bool plain_bytes(std::size_t size, std::vector<std::byte>& bytes);

    // Appends every byte up to the line's end. False if something else than bytes is there.
    bool hex_bytes(std::vector<std::byte>& bytes);

    std::string_view word();
    std::string_view rest();

    // The rest, with what LogWriter wrote as "\xHH". A backslash that begins none stays.
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
