#include "drivers/sensors/number_line.h"

#include "engine/base/printable.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/core.h>

namespace tractus::drivers {

namespace {

bool is_letter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void skip_line_blanks(std::string_view& text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\r'))
        text.remove_prefix(1);
}

// Removes a label such as "height:" or "d=" from the text, if it has one.
void skip_label(std::string_view& text)
{
    auto rest = text;
    while (!rest.empty() && (is_letter(rest.front()) || std::isdigit(rest.front()) != 0))
        rest.remove_prefix(1);
    bool const has_name = rest.size() < text.size() && is_letter(text.front());
    skip_line_blanks(rest);
    if (!has_name || rest.empty() || (rest.front() != ':' && rest.front() != '='))
        return;
    rest.remove_prefix(1);
    skip_line_blanks(rest);
    text = rest;
}

// Parses a line that contains exactly one number.
std::optional<double> parse_number_line(std::string_view text)
{
    skip_line_blanks(text);
    skip_label(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value))
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    skip_line_blanks(text);
    while (!text.empty() && (is_letter(text.front()) || text.front() == '%'))
        text.remove_prefix(1);
    skip_line_blanks(text);
    return text.empty() ? std::optional(value) : std::nullopt;
}

class NumberDecoder final : public HeightDecoder {
public:
    explicit NumberDecoder(NumberFormat format)
        : format_(format)
        , counts_per_one_(std::pow(10.0, format.decimals))
    {
    }

    std::int32_t full_scale() const override { return format_.full_scale; }

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override
    {
        std::string_view const text(reinterpret_cast<char const*>(report.data()), report.size());
        auto const value = parse_number_line(text);
        if (!value)
            return fail(Fault::Device,
                        fmt::format("\"{}\" is not one number, such as 512 or height: 23.75",
                                    printable(std::string(text.substr(0, 60)))));
        auto const counts = std::round(*value * counts_per_one_);
        if (counts > format_.full_scale)
            return fail(Fault::Device,
                        fmt::format("{:.{}f} is above the greatest number, {:.{}f}: tell it behind "
                                    "the sensor's address, as in @max={}",
                                    *value, format_.decimals, format_.full_scale / counts_per_one_,
                                    format_.decimals,
                                    *value < 1023        ? 1023
                                        : *value <= 4095 ? 4095
                                                         : 65535));
        if (counts < -0.01 * format_.full_scale)
            return fail(Fault::Device,
                        fmt::format("{:.{}f} is below 0: let the sensor count from 0 upwards",
                                    *value, format_.decimals));
        out.push_back({ .time = received,
                        .counts = static_cast<std::int32_t>(std::max(counts, 0.0)),
                        .full_scale = format_.full_scale });
        return {};
    }

private:
    NumberFormat format_;
    double counts_per_one_;
};

} // namespace

Result<std::optional<NumberFormat>> parse_greatest_number(std::string_view word)
{
    constexpr std::string_view kPrefix = "max=";
    constexpr std::size_t kMaxDecimals = 6;
    constexpr double kMaxCounts = 2e9;
    if (!word.starts_with(kPrefix))
        return std::optional<NumberFormat>();
    auto const number = word.substr(kPrefix.size());
    auto const point = number.find('.');
    auto const decimals = point == std::string_view::npos ? 0 : number.size() - point - 1;
    double value = 0;
    auto const [end, error] = std::from_chars(number.data(), number.data() + number.size(), value,
                                              std::chars_format::fixed);
    auto const counts = std::round(value * std::pow(10.0, static_cast<double>(decimals)));
    if (error != std::errc() || end != number.data() + number.size() || decimals > kMaxDecimals
        || !(counts >= 1 && counts <= kMaxCounts))
        return fail(Fault::User,
                    fmt::format("\"{}\" is not the greatest number of a sensor: expected such as "
                                "max=4095, or max=500.00 for numbers with two decimals",
                                word));
    return std::optional(NumberFormat { .full_scale = static_cast<std::int32_t>(counts),
                                        .decimals = static_cast<int>(decimals) });
}

std::unique_ptr<HeightDecoder> make_number_decoder(NumberFormat format)
{
    return std::make_unique<NumberDecoder>(format);
}

std::string number_line_path(std::string_view kind, DeviceInfo const& info)
{
    return fmt::format("{}:{}@{}", kind, info.location, info.settings);
}

std::optional<std::string> number_line_settings(std::string_view kind, DeviceInfo const& info)
{
    auto const at = info.physical_path.rfind('@');
    bool const is_of_kind = info.physical_path.starts_with(kind) && at != std::string::npos
        && info.physical_path.size() > kind.size() && info.physical_path[kind.size()] == ':';
    return is_of_kind ? std::optional(info.physical_path.substr(at + 1)) : std::nullopt;
}

} // namespace tractus::drivers
