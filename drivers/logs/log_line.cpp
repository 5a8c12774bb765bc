#include "drivers/logs/log_line.h"

#include <array>
#include <cstdint>

namespace tractus::drivers {

namespace {

constexpr std::size_t kNanosecondDigits = 9;

constexpr std::array<std::int8_t, 256> make_hex_table()
{
    std::array<std::int8_t, 256> table {};
    table.fill(-1);
    for (int i = 0; i < 10; ++i)
        table[static_cast<std::size_t>('0' + i)] = static_cast<std::int8_t>(i);
    for (int i = 0; i < 6; ++i) {
        table[static_cast<std::size_t>('a' + i)] = static_cast<std::int8_t>(10 + i);
        table[static_cast<std::size_t>('A' + i)] = static_cast<std::int8_t>(10 + i);
    }
    return table;
}
constexpr auto kHex = make_hex_table();

int hex_digit(char c)
{
    return kHex[static_cast<unsigned char>(c)];
}

} // namespace

bool LogLine::time(Timestamp& time)
{
    constexpr std::int64_t kMaxSeconds = 9'000'000'000;
    std::int64_t seconds = 0;
    if (!integer(seconds, 10) || seconds < 0 || seconds > kMaxSeconds)
        return false;
    std::int64_t nanoseconds = 0;
    if (at_ != end_ && *at_ == '.') {
        ++at_;
        std::size_t digits = 0;
        for (; at_ != end_ && *at_ >= '0' && *at_ <= '9'; ++at_, ++digits)
            if (digits < kNanosecondDigits)
                nanoseconds = nanoseconds * 10 + (*at_ - '0');
        for (; digits < kNanosecondDigits; ++digits)
            nanoseconds *= 10;
    }
    time = timestamp_ns(seconds * 1'000'000'000 + nanoseconds);
    return true;
}

bool LogLine::plain_bytes(std::size_t size, std::vector<std::byte>& bytes)
{
    auto const left = static_cast<std::size_t>(end_ - at_);
    if (left % 3 != 0 || left / 3 != size) // Dividing avoids the overflow that 3 * size could have.
        return false;
    auto const old_size = bytes.size();
    bytes.resize(old_size + size);
    int wrong = 0;
    char const* at = at_;
    for (auto* byte = bytes.data() + old_size; at != end_; at += 3, ++byte) {
        int const value = hex_digit(at[1]) * 16 | hex_digit(at[2]);
        wrong |= value | (at[0] ^ ' ') << 8;
        *byte = static_cast<std::byte>(value);
    }
    if (wrong & ~0xff) {
        bytes.resize(old_size);
        return false;
    }
    at_ = end_;
    return true;
}

bool LogLine::hex_bytes(std::vector<std::byte>& bytes)
{
    for (;;) {
        skip_blanks();
        if (at_ == end_)
            return true;
        if (end_ - at_ < 2)
            return false;
        int const high = hex_digit(at_[0]);
        int const low = hex_digit(at_[1]);
        if ((high | low) < 0)
            return false;
        bytes.push_back(static_cast<std::byte>(high << 4 | low));
        at_ += 2;
        if (at_ != end_ && !is_blank(*at_))
            return false;
    }
}

std::string_view LogLine::word()
{
    skip_blanks();
    auto const* const begin = at_;
    while (at_ != end_ && !is_blank(*at_))
        ++at_;
    return { begin, static_cast<std::size_t>(at_ - begin) };
}

std::string_view LogLine::rest()
{
    skip_blanks();
    return { at_, static_cast<std::size_t>(end_ - at_) };
}

std::string LogLine::unescaped_rest()
{
    auto const line = rest();
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        bool const may_be_escape = line[i] == '\\' && i + 3 < line.size() && line[i + 1] == 'x';
        int const high = may_be_escape ? hex_digit(line[i + 2]) : -1;
        int const low = may_be_escape ? hex_digit(line[i + 3]) : -1;
        if ((high | low) < 0) {
            text += line[i];
            continue;
        }
        text += static_cast<char>(high << 4 | low);
        i += 3;
    }
    return text;
}

} // namespace tractus::drivers
