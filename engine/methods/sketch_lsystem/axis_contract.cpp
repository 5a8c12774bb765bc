#include "engine/methods/sketch_lsystem/axis_contract.h"

#include "engine/lsystem/text/placed_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace tractus::sketch {

namespace {

constexpr std::array<std::string_view, 2> kCountNames { "SEGMENTS", "N" };

// A model's text without comments and without whitespace that has no meaning, and a map from its
// characters back to the original text.
class CleanText {
public:
    explicit CleanText(std::string_view source)
    {
        std::optional<lsystem::SourcePlace> ignored;
        text_ = lsystem::without_comments(source, 0, ignored);
        line_begins_.push_back(0);
        for (std::size_t i = 0; i < source.size(); ++i)
            if (source[i] == '\n')
                line_begins_.push_back(i + 1);
    }

    std::string_view characters() const { return text_.characters; }

    // Converts an offset in the cleaned text to an offset in the original text. An offset past the
    // end becomes the start of the original's last line.
    std::size_t in_source(std::size_t at) const
    {
        if (at >= text_.size())
            return line_begins_.back();
        auto const& place = text_.places[at];
        return line_begins_[place.line - 1] + place.column - 1;
    }

    std::uint32_t line(std::size_t at) const
    {
        return at < text_.size() ? text_.places[at].line
                                 : static_cast<std::uint32_t>(line_begins_.size());
    }

private:
    lsystem::PlacedText text_;
    std::vector<std::size_t> line_begins_;
};

// A cursor over a text; each reading function skips whitespace first.
struct Reading {
    std::string_view text;
    std::size_t at = 0;

    void skip_blanks()
    {
        while (at < text.size() && (lsystem::is_blank(text[at]) || text[at] == '\n'))
            ++at;
    }
    std::string_view token()
    {
        skip_blanks();
        if (at == text.size())
            return {};
        auto const begin = std::exchange(at, lsystem::token_end(text, at));
        return text.substr(begin, at - begin);
    }
    bool take(std::string_view wanted)
    {
        auto const before = at;
        if (token() == wanted)
            return true;
        at = before;
        return false;
    }
    // Reads up to and including the character `closing` and returns the text before it. No value if
    // any other bracket, '=' or ';' comes first.
    std::optional<std::string_view> up_to(char closing)
    {
        auto const end = text.find_first_of("[]{}=;", at);
        if (end == std::string_view::npos || text[end] != closing)
            return std::nullopt;
        auto const inside = text.substr(at, end - at);
        at = end + 1;
        return inside;
    }
};

std::optional<double> plain_number(std::string_view text)
{
    text = lsystem::trimmed_line(text);
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()
        || !std::isfinite(value))
        return std::nullopt;
    return value;
}

// Parses the numbers between an array's braces; no value if one of them is not a plain number.
std::optional<std::vector<double>> plain_numbers(std::string_view text)
{
    std::vector<double> values;
    while (true) {
        auto const comma = text.find(',');
        auto const value = plain_number(text.substr(0, comma));
        if (!value)
            return std::nullopt;
        values.push_back(*value);
        if (comma == std::string_view::npos)
            return values;
        text.remove_prefix(comma + 1);
    }
}

class ContractReader {
public:
    ContractReader(std::string const& name, std::string_view text)
        : name_(name)
        , text_(text)
    {
    }

    ContractReading read()
    {
        read_count();
        read_lengths();
        read_array("plane", result_.contract.plane);
        read_array("bend", result_.contract.bend);
        read_rules();
        return std::move(result_);
    }

private:
    void lacks(std::string const& what)
    {
        result_.lacks.push_back(fmt::format("{}: {}", name_, what));
    }
    void lacks(std::size_t at, std::string const& what)
    {
        result_.lacks.push_back(fmt::format("{}:{}: {}", name_, text_.line(at), what));
    }
    TextSpan span(std::size_t begin, std::size_t end) const
    {
        auto const first = text_.in_source(begin);
        return { first, text_.in_source(end - 1) + 1 - first };
    }

    // Finds the line "#define SEGMENTS n" or "#define N n", where n is a whole number.
    void read_count()
    {
        auto const text = text_.characters();
        for (std::size_t begin = 0; begin < text.size();) {
            auto const end = std::min(text.find('\n', begin), text.size());
            Reading line { text.substr(0, end), begin };
            begin = end + 1;
            if (!line.take("#") || !line.take("define"))
                continue;
            auto const name = line.token();
            if (std::find(kCountNames.begin(), kCountNames.end(), name) == kCountNames.end())
                continue;
            line.skip_blanks();
            auto const value = lsystem::trimmed_line(line.text.substr(line.at));
            if (value.empty() || !std::all_of(value.begin(), value.end(), lsystem::is_digit))
                return lacks(line.at - 1,
                             fmt::format("#define {} is no whole number: give it 0, "
                                         "which is the plant without a stroke",
                                         name));
            result_.contract.count_name = name;
            result_.contract.count = span(line.at, line.at + value.size());
            return;
        }
        lacks("it has no line #define SEGMENTS 0, the number of segments that a stroke has");
    }

    struct FoundArray {
        std::size_t begin;       // Offset of the '[' after the array's name.
        std::size_t end;         // Offset of the character after the closing '}'.
        std::string_view values; // Text between the braces.
    };

    // Finds "array NAME[size] = { values }".
    std::optional<FoundArray> find_array(std::string_view name)
    {
        Reading reading { text_.characters() };
        for (auto token = reading.token(); !token.empty(); token = reading.token()) {
            if (token != name)
                continue;
            auto rest = reading;
            rest.skip_blanks();
            auto const begin = rest.at;
            if (!rest.take("[") || !rest.up_to(']') || !rest.take("=") || !rest.take("{"))
                continue;
            if (auto const values = rest.up_to('}'))
                return FoundArray { begin, rest.at, *values };
        }
        lacks(fmt::format("it has no array {0} with values: give it define: {{ array {0}[1] = "
                          "{{{1}}}; }}",
                          name, name == "length" ? "10" : "0"));
        return std::nullopt;
    }

    void read_array(std::string_view name, TextSpan& place)
    {
        if (auto const found = find_array(name))
            place = span(found->begin, found->end);
    }

    void read_lengths()
    {
        auto const found = find_array("length");
        if (!found)
            return;
        result_.contract.length = span(found->begin, found->end);
        auto const values = plain_numbers(found->values);
        if (!values || !std::all_of(values->begin(), values->end(), [](double v) { return v > 0; }))
            return lacks(found->begin, "the values of length[] are not all plain numbers above 0");
        result_.contract.lengths = *values;
    }

    // Checks that some rule turns by /(plane[i])+(bend[i])\(plane[i]) and then draws F(length[i]),
    // and that a condition "i < SEGMENTS" ends the axis.
    void read_rules()
    {
        std::string rules;
        std::vector<std::size_t> places;
        auto const text = text_.characters();
        for (std::size_t i = 0; i < text.size(); ++i)
            if (!lsystem::is_blank(text[i]) && text[i] != '\n') {
                rules += text[i];
                places.push_back(i);
            }
        constexpr std::string_view kTurn = "/(plane[";
        auto const turn = rules.find(kTurn);
        auto const index_end = rules.find("])", turn == std::string::npos ? turn : turn + 1);
        if (index_end == std::string::npos)
            return lacks("no rule turns the drawn axis by /(plane[i])+(bend[i])\\(plane[i])");
        auto const index = rules.substr(turn + kTurn.size(), index_end - turn - kTurn.size());
        auto const whole = fmt::format("/(plane[{0}])+(bend[{0}])\\(plane[{0}])", index);
        if (rules.compare(turn, whole.size(), whole) != 0)
            return lacks(places[turn],
                         fmt::format("/(plane[{0}]) is not followed by "
                                     "+(bend[{0}])\\(plane[{0}])",
                                     index));
        auto const rest = std::string_view(rules).substr(turn, rules.find("-->", turn) - turn);
        if (rest.find(fmt::format("F(length[{}])", index)) == std::string_view::npos)
            lacks(places[turn],
                  fmt::format("no F(length[{}]) follows the turn, which draws the segment", index));
        auto const& name = result_.contract.count_name;
        if (!name.empty() && rules.find("<" + name) == std::string::npos)
            lacks(fmt::format("no rule ends the drawn axis by a condition i < {}", name));
    }

    std::string const& name_;
    CleanText text_;
    ContractReading result_;
};

} // namespace

ContractReading read_contract(std::string const& name, std::string_view text)
{
    return ContractReader(name, text).read();
}

Result<AxisContract> contract_of(std::string const& name, std::string_view text)
{
    auto reading = read_contract(name, text);
    if (reading.lacks.empty())
        return std::move(reading.contract);
    return fail(Fault::User,
                fmt::format("{}, so it cannot grow along a stroke; \"tractus lsystem check\" says "
                            "all that it lacks",
                            reading.lacks.front()));
}

std::string with_values(std::string_view text, AxisContract const& contract,
                        ContractValues const& values)
{
    auto const array = [&](std::string const& numbers) {
        return fmt::format("[{}] = {}", contract.count_name, numbers);
    };
    std::array<std::pair<TextSpan, std::string>, 4> places { {
        { contract.count, std::to_string(values.count) },
        { contract.length, array(values.length) },
        { contract.plane, array(values.plane) },
        { contract.bend, array(values.bend) },
    } };
    std::sort(places.begin(), places.end(), [](auto const& one, auto const& other) {
        return one.first.begin < other.first.begin;
    });
    std::string result;
    std::size_t done = 0;
    for (auto const& [place, value] : places) {
        result += text.substr(done, place.begin - done);
        result += value;
        done = place.begin + place.size;
    }
    result += text.substr(done);
    return result;
}

} // namespace tractus::sketch
