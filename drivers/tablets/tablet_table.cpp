#include "drivers/tablets/tablet_table.h"

#include "drivers/tablets/tablets_text.h"
#include "engine/base/check.h"

#include <charconv>
#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

namespace {

std::string_view trimmed(std::string_view text)
{
    auto const first = text.find_first_not_of(' ');
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

// Removes the text up to and including the separator, and returns the part before the separator.
std::string_view take(std::string_view& text, std::string_view separator)
{
    auto const end = text.find(separator);
    auto const part = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + separator.size());
    return trimmed(part);
}

template<typename T> bool read_number(std::string_view text, T& value, int base = 10)
{
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    return error == std::errc() && end == text.data() + text.size();
}

bool read_number(std::string_view text, double& value)
{
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

// Parses "02 b0 04, 02 b0 02".
bool read_reports(std::string_view text, std::vector<std::vector<std::byte>>& reports)
{
    while (!text.empty()) {
        auto bytes = take(text, ",");
        auto& report = reports.emplace_back();
        while (!bytes.empty()) {
            unsigned value = 0;
            if (!read_number(take(bytes, " "), value, 16) || value > 0xFF)
                return false;
            report.push_back(static_cast<std::byte>(value));
        }
        if (report.empty())
            return false;
    }
    return !reports.empty();
}

bool read_indices(std::string_view text, std::vector<int>& indices)
{
    while (!text.empty())
        if (!read_number(take(text, ","), indices.emplace_back()))
            return false;
    return !indices.empty();
}

// Parses "254 x 158.75".
template<typename T> bool read_pair(std::string_view text, T& first, T& second)
{
    return read_number(take(text, " x "), first) && read_number(trimmed(text), second);
}

bool read_sizes(std::string_view text, TabletIdentifier& identifier)
{
    auto const input = take(text, "/");
    if (input != "-" && !read_number(input, identifier.input_size.emplace()))
        return false;
    return text.empty() || read_number(text, identifier.output_size.emplace());
}

// Parses a clause such as "string 200" or "if 201 HUION_…". Fails if its word is not known.
bool read_clause(std::string_view clause, TabletIdentifier& identifier)
{
    auto& setup = identifier.setup;
    auto const word = take(clause, " ");
    if (word == "string")
        return read_indices(clause, setup.strings);
    if (word == "feature")
        return read_reports(clause, setup.feature_reports);
    if (word == "output")
        return read_reports(clause, setup.output_reports);
    if (word == "interface")
        return read_number(clause, identifier.interface_number.emplace());
    if (word == "if") {
        auto& condition = identifier.conditions.emplace_back();
        bool const is_number = read_number(take(clause, " "), condition.index);
        condition.pattern = clause;
        return is_number && !clause.empty();
    }
    return false;
}

bool read_product(std::string_view text, TabletIdentifier& identifier)
{
    identifier.is_any_product = text == "*";
    return identifier.is_any_product || read_number(text, identifier.product_id, 16);
}

bool read_identifier(std::string_view line, TabletIdentifier& identifier)
{
    auto head = take(line, ";");
    auto ids = take(head, " ");
    auto const sizes = take(head, " ");
    identifier.family = trimmed(head);
    bool is_right = read_number(take(ids, ":"), identifier.vendor_id, 16)
        && read_product(ids, identifier) && read_sizes(sizes, identifier)
        && !identifier.family.empty();
    while (is_right && !line.empty())
        is_right = read_clause(take(line, ";"), identifier);
    return is_right;
}

bool read_tablet(std::string_view line, Tablet& tablet)
{
    tablet.name = take(line, "|");
    bool const is_right = !tablet.name.empty()
        && read_pair(take(line, "|"), tablet.size_mm.x(), tablet.size_mm.y())
        && read_pair(take(line, "|"), tablet.x_maximum, tablet.y_maximum)
        && read_number(take(line, "|"), tablet.pressure_maximum)
        && read_number(take(line, "|"), tablet.pen_buttons)
        && read_number(take(line, "|"), tablet.pad_keys);
    tablet.is_size_in_doubt = line == " size in doubt";
    return is_right && (line.empty() || tablet.is_size_in_doubt);
}

} // namespace

Result<std::vector<Tablet>> parse_tablets(std::string_view text)
{
    std::vector<Tablet> tablets;
    for (int number = 1; !text.empty(); ++number) {
        auto const line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (line.empty() || line.starts_with('#'))
            continue;
        bool const is_right = !line.starts_with(' ') ? read_tablet(line, tablets.emplace_back())
                                                     : !tablets.empty()
                && read_identifier(trimmed(line), tablets.back().identifiers.emplace_back());
        if (!is_right)
            return fail(Fault::Station,
                        fmt::format("tablets.txt:{}: cannot read \"{}\"", number, line));
    }
    return tablets;
}

std::span<Tablet const> known_tablets()
{
    static auto const tablets = [] {
        auto parsed = parse_tablets(tablets_text());
        CHECK(parsed);
        return *std::move(parsed);
    }();
    return tablets;
}

} // namespace tractus::drivers
