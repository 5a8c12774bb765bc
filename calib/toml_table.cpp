#include "calib/toml_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <optional>
#include <sstream>

namespace tractus::calib {

static constexpr std::string_view expectation(NumberRange range)
{
    switch (range) {
    case NumberRange::Any:
        return "a number";
    case NumberRange::Positive:
        return "a number greater than 0";
    case NumberRange::NotNegative:
        return "a number of 0 or more";
    }
    return "a number";
}

static bool is_in(NumberRange range, double number)
{
    switch (range) {
    case NumberRange::Any:
        return std::isfinite(number);
    case NumberRange::Positive:
        return std::isfinite(number) && number > 0;
    case NumberRange::NotNegative:
        return std::isfinite(number) && number >= 0;
    }
    return false;
}

static std::string in_full(toml::node const& node)
{
    if (node.is_table())
        return "a table";
    if (auto const number = node.value_exact<double>())
        return fmt::format("{}", *number);
    if (auto const* const array = node.as_array()) {
        std::vector<std::string> elements;
        for (auto const& element : *array)
            elements.push_back(in_full(element));
        return fmt::format("[{}]", fmt::join(elements, ", "));
    }
    std::ostringstream text;
    node.visit([&](auto const& value) { text << value; });
    return text.str();
}

// Formats a value for an error message: on one line, and shortened at a character boundary if it is
// long.
static std::string describe(toml::node const& node)
{
    constexpr std::size_t kLongest = 40;
    auto shown = in_full(node);
    std::replace(shown.begin(), shown.end(), '\n', ' ');
    if (shown.size() <= kLongest)
        return shown;
    auto end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(shown[end]) & 0xC0) == 0x80)
        --end;
    return shown.substr(0, end) + " …";
}

// Returns the number in a node if it lies in `range`. Integers are accepted.
static std::optional<double> number_in(toml::node const& node, NumberRange range)
{
    auto const number = node.value_exact<double>();
    auto const integer = node.value_exact<std::int64_t>();
    if (!number && !integer)
        return std::nullopt;
    double const value = number ? *number : static_cast<double>(*integer);
    return is_in(range, value) ? std::optional(value) : std::nullopt;
}

// Returns the numbers of an array with exactly `count` elements.
static std::optional<std::vector<double>> numbers_in(toml::node const& node, std::size_t count,
                                                     NumberRange range)
{
    auto const* const array = node.as_array();
    if (!array || array->size() != count)
        return std::nullopt;
    std::vector<double> numbers;
    for (auto const& element : *array) {
        auto const number = number_in(element, range);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

Result<TomlTable> TomlTable::parse(std::string_view text, std::string name)
{
    try {
        auto document
            = std::make_shared<Document const>(Document { name, toml::parse(text, name) });
        auto const& root = document->root;
        return TomlTable(std::move(document), root, {});
    } catch (toml::parse_error const& error) {
        auto const place = error.source().begin;
        return fail(Fault::User,
                    fmt::format("{}:{}:{}: not TOML: {}", name, place.line, place.column,
                                error.description()));
    }
}

std::string TomlTable::path_of(std::string_view key) const
{
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

// Returns the line of a node, from 1; the parser has none for the file as a whole.
static auto line_of(toml::node const& node)
{
    return std::max(node.source().begin.line, toml::source_index { 1 });
}

std::string TomlTable::place() const
{
    return fmt::format("{}:{}: {}", document_->name, line_of(*table_), path_);
}

tl::unexpected<Error> TomlTable::wrong(std::string_view key, std::string_view problem) const
{
    auto const* const node = table_->get(key);
    return fail(Fault::User,
                fmt::format("{}:{}: {} {}", document_->name, line_of(node ? *node : *table_),
                            path_of(key), problem));
}

Result<void> TomlTable::require_version(std::int64_t newest)
{
    auto const version = TRY(integer("version", NumberRange::Positive));
    if (version > newest)
        return wrong("version",
                     fmt::format("is {}, expected at most {}: a later tractus wrote this "
                                 "file, so use that one to read it",
                                 version, newest));
    return {};
}

bool TomlTable::has(std::string_view key)
{
    known_.emplace(key);
    return table_->contains(key);
}

Result<toml::node const*> TomlTable::find(std::string_view key, std::string_view expected)
{
    if (!has(key))
        return wrong(key, fmt::format("is missing, expected {}", expected));
    return table_->get(key);
}

Result<double> TomlTable::number(std::string_view key, NumberRange range)
{
    auto const* const node = TRY(find(key, expectation(range)));
    if (auto const value = number_in(*node, range))
        return *value;
    return wrong(key, fmt::format("is {}, expected {}", describe(*node), expectation(range)));
}

Result<double> TomlTable::number_or(std::string_view key, double fallback, NumberRange range)
{
    if (!has(key))
        return fallback;
    return number(key, range);
}

Result<std::int64_t> TomlTable::integer(std::string_view key, NumberRange range)
{
    auto const expected = fmt::format("whole {}", expectation(range).substr(2));
    auto const* const node = TRY(find(key, "a " + expected));
    auto const value = node->value_exact<std::int64_t>();
    if (value && is_in(range, static_cast<double>(*value)))
        return *value;
    return wrong(key, fmt::format("is {}, expected a {}", describe(*node), expected));
}

Result<std::string> TomlTable::text(std::string_view key)
{
    auto const* const node = TRY(find(key, "a text in quotes"));
    if (auto const value = node->value_exact<std::string>())
        return *value;
    return wrong(key, fmt::format("is {}, expected a text in quotes", describe(*node)));
}

Result<std::size_t> TomlTable::word(std::string_view key,
                                    std::vector<std::string_view> const& words)
{
    auto const expected = fmt::format("\"{}\"", fmt::join(words, "\", \""));
    auto const* const node = TRY(find(key, "one of " + expected));
    auto const value = node->value_exact<std::string>();
    auto const found = std::find(words.begin(), words.end(), value.value_or(""));
    if (value && found != words.end())
        return static_cast<std::size_t>(found - words.begin());
    return wrong(key, fmt::format("is {}, expected one of {}", describe(*node), expected));
}

Result<std::vector<double>> TomlTable::numbers(std::string_view key, std::size_t count,
                                               NumberRange range)
{
    auto const expected = fmt::format("an array of {} numbers, each {}", count, expectation(range));
    auto const* const node = TRY(find(key, expected));
    if (auto const values = numbers_in(*node, count, range))
        return *values;
    return wrong(key, fmt::format("is {}, expected {}", describe(*node), expected));
}

Result<Vec2> TomlTable::vec2(std::string_view key, NumberRange range)
{
    auto const values = TRY(numbers(key, 2, range));
    return Vec2(values[0], values[1]);
}

Result<Vec2> TomlTable::vec2_or(std::string_view key, Vec2 const& fallback)
{
    if (!has(key))
        return fallback;
    return vec2(key);
}

Result<Vec3> TomlTable::vec3(std::string_view key)
{
    auto const values = TRY(numbers(key, 3, NumberRange::Any));
    return Vec3(values[0], values[1], values[2]);
}

Result<std::vector<double>> TomlTable::number_list(std::string_view key)
{
    constexpr std::string_view kExpected = "an array of numbers";
    auto const* const node = TRY(find(key, kExpected));
    auto const* const array = node->as_array();
    if (array)
        if (auto const values = numbers_in(*node, array->size(), NumberRange::Any))
            return *values;
    return wrong(key, fmt::format("is {}, expected {}", describe(*node), kExpected));
}

Result<std::vector<std::vector<double>>> TomlTable::points(std::string_view key,
                                                           std::size_t dimensions)
{
    auto const expected
        = fmt::format("an array of points, each an array of {} numbers", dimensions);
    auto const* const node = TRY(find(key, expected));
    auto const* const array = node->as_array();
    if (!array)
        return wrong(key, fmt::format("is {}, expected {}", describe(*node), expected));
    std::vector<std::vector<double>> points;
    for (auto const& element : *array) {
        auto const values = numbers_in(element, dimensions, NumberRange::Any);
        if (!values)
            return wrong(key,
                         fmt::format("has {} as point {}, expected {}", describe(element),
                                     points.size() + 1, expected));
        points.push_back(*values);
    }
    return points;
}

Result<std::vector<Vec2>> TomlTable::vec2_list(std::string_view key)
{
    std::vector<Vec2> places;
    for (auto const& values : TRY(points(key, 2)))
        places.emplace_back(values[0], values[1]);
    return places;
}

Result<std::vector<Vec3>> TomlTable::vec3_list(std::string_view key)
{
    std::vector<Vec3> places;
    for (auto const& values : TRY(points(key, 3)))
        places.emplace_back(values[0], values[1], values[2]);
    return places;
}

Result<TomlTable> TomlTable::table(std::string_view key)
{
    auto const expected = fmt::format("a table [{}]", path_of(key));
    auto const* const node = TRY(find(key, expected));
    if (auto const* const table = node->as_table())
        return TomlTable(document_, *table, path_of(key));
    return wrong(key, fmt::format("is {}, expected {}", describe(*node), expected));
}

Result<std::vector<TomlTable>> TomlTable::tables(std::string_view key)
{
    auto const expected = fmt::format("tables [[{}]]", path_of(key));
    auto const* const node = TRY(find(key, expected));
    auto const* const array = node->as_array();
    if (!array || array->empty() || !array->is_homogeneous<toml::table>())
        return wrong(key, fmt::format("is {}, expected {}", describe(*node), expected));
    std::vector<TomlTable> tables;
    for (auto const& element : *array)
        tables.push_back(TomlTable(document_, *element.as_table(),
                                   fmt::format("{}[{}]", path_of(key), tables.size() + 1)));
    return tables;
}

Result<void> TomlTable::refuse_unknown_keys() const
{
    for (auto const& [key, value] : *table_)
        if (!known_.contains(key.str()))
            return wrong(
                key.str(),
                fmt::format("is not a key of this place, expected {}", fmt::join(known_, ", ")));
    return {};
}

} // namespace tractus::calib
