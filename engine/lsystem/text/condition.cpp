#include "engine/lsystem/text/condition.h"

#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/core.h>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace tractus::lsystem {

namespace {

constexpr int kMaxNesting = 100;

struct Operator {
    std::string_view symbol;
    int strength; // Precedence: operators with a higher strength bind more tightly.
};
// Operators of C. Longer ones come before their prefixes.
constexpr std::array kOperators {
    Operator { "||", 1 }, Operator { "&&", 2 }, Operator { "==", 6 }, Operator { "!=", 6 },
    Operator { "<=", 7 }, Operator { ">=", 7 }, Operator { "<<", 8 }, Operator { ">>", 8 },
    Operator { "|", 3 },  Operator { "^", 4 },  Operator { "&", 5 },  Operator { "<", 7 },
    Operator { ">", 7 },  Operator { "+", 9 },  Operator { "-", 9 },  Operator { "*", 10 },
    Operator { "/", 10 }, Operator { "%", 10 },
};

// A value of C's type intmax_t or uintmax_t. An operation is unsigned if one of its operands is.
struct Value {
    std::int64_t number = 0;
    bool is_unsigned = false;
};

std::uint64_t bits(Value const& value)
{
    return static_cast<std::uint64_t>(value.number);
}

bool is_less(Value const& a, Value const& b)
{
    return a.is_unsigned || b.is_unsigned ? bits(a) < bits(b) : a.number < b.number;
}

// Bitwise shifts. As in gcc, a negative count shifts in the other direction.
std::int64_t shifted_left(Value const& value, Value const& by);

std::int64_t shifted_right(Value const& value, Value const& by)
{
    if (!by.is_unsigned && by.number < 0)
        return shifted_left(value, { static_cast<std::int64_t>(0 - bits(by)), true });
    bool const is_far = bits(by) >= 64;
    if (value.is_unsigned)
        return is_far ? 0 : static_cast<std::int64_t>(bits(value) >> bits(by));
    return value.number >> (is_far ? 63 : bits(by));
}

std::int64_t shifted_left(Value const& value, Value const& by)
{
    if (!by.is_unsigned && by.number < 0)
        return shifted_right(value, { static_cast<std::int64_t>(0 - bits(by)), true });
    return bits(by) >= 64 ? 0 : static_cast<std::int64_t>(bits(value) << bits(by));
}

class ConditionParser {
public:
    ConditionParser(std::string_view text, ErrorAt const& error)
        : text_(text)
        , error_(error)
    {
    }

    Result<std::int64_t> parse()
    {
        auto const value = TRY(conditional());
        if (skip(); at_ < text_.size())
            return error_(at_,
                          fmt::format("found '{}' in #if, expected an operator or the end of "
                                      "the line",
                                      shown(text_.substr(at_, token_end(text_, at_) - at_))));
        return value.number;
    }

private:
    Result<Value> conditional();
    Result<Value> binary(int strength);
    Result<Value> unary();
    Result<Value> number();
    Result<Value> apply(Operator const& op, Value const& left, Value const& right,
                        std::size_t position) const;
    Result<Value> divide(Operator const& op, Value const& left, Value const& right,
                         std::size_t position) const;
    std::optional<Operator> take_operator(int strength);
    bool take(char symbol)
    {
        skip();
        bool const found = at_ < text_.size() && text_[at_] == symbol;
        at_ += found;
        return found;
    }
    void skip()
    {
        while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n'))
            ++at_;
    }

    std::string_view text_;
    ErrorAt const& error_;
    std::size_t at_ = 0;
    int depth_ = 0;
    // False while operands of && || ?: are parsed that are not evaluated and may contain errors
    // such as 1/0.
    bool is_evaluated_ = true;
};

Result<Value> ConditionParser::conditional()
{
    if (depth_ > kMaxNesting)
        return error_(at_, fmt::format("#if is nested deeper than {}", kMaxNesting));
    ++depth_;
    auto const condition = TRY(binary(1));
    auto result = condition;
    if (take('?')) {
        bool const outer = is_evaluated_;
        is_evaluated_ = outer && condition.number != 0;
        auto const first = TRY(conditional());
        if (!take(':'))
            return error_(at_, "found ? in #if, expected : behind it");
        is_evaluated_ = outer && condition.number == 0;
        auto const second = TRY(conditional());
        is_evaluated_ = outer;
        result = condition.number != 0 ? first : second;
        result.is_unsigned = first.is_unsigned || second.is_unsigned;
    }
    --depth_;
    return result;
}

// Consumes the next operator if it binds at least as tightly as `strength`.
std::optional<Operator> ConditionParser::take_operator(int strength)
{
    skip();
    auto const rest = text_.substr(at_);
    auto const found = std::find_if(kOperators.begin(), kOperators.end(), [&](auto const& op) {
        return rest.substr(0, op.symbol.size()) == op.symbol;
    });
    if (found == kOperators.end() || found->strength < strength)
        return std::nullopt;
    at_ += found->symbol.size();
    return *found;
}

Result<Value> ConditionParser::binary(int strength)
{
    auto left = TRY(unary());
    while (auto const op = take_operator(strength)) {
        auto const position = at_ - op->symbol.size();
        bool const outer = is_evaluated_;
        if ((op->symbol == "&&" && left.number == 0) || (op->symbol == "||" && left.number != 0))
            is_evaluated_ = false;
        auto const right = TRY(binary(op->strength + 1));
        is_evaluated_ = outer;
        left = TRY(apply(*op, left, right, position));
    }
    return left;
}

Result<Value> ConditionParser::apply(Operator const& op, Value const& left, Value const& right,
                                     std::size_t position) const
{
    auto const a = bits(left);
    auto const b = bits(right);
    bool const is_unsigned = left.is_unsigned || right.is_unsigned;
    auto const truth = [](bool holds) { return Value { holds, false }; };
    auto const wrapped = [&](std::uint64_t value) {
        return Value { static_cast<std::int64_t>(value), is_unsigned };
    };
    auto const& symbol = op.symbol;
    if (symbol == "/" || symbol == "%")
        return divide(op, left, right, position);
    return symbol == "||" ? truth(a != 0 || b != 0)
        : symbol == "&&"  ? truth(a != 0 && b != 0)
        : symbol == "=="  ? truth(a == b)
        : symbol == "!="  ? truth(a != b)
        : symbol == "<="  ? truth(!is_less(right, left))
        : symbol == ">="  ? truth(!is_less(left, right))
        : symbol == "<"   ? truth(is_less(left, right))
        : symbol == ">"   ? truth(is_less(right, left))
        : symbol == "<<"  ? Value { shifted_left(left, right), left.is_unsigned }
        : symbol == ">>"  ? Value { shifted_right(left, right), left.is_unsigned }
        : symbol == "|"   ? wrapped(a | b)
        : symbol == "^"   ? wrapped(a ^ b)
        : symbol == "&"   ? wrapped(a & b)
        : symbol == "+"   ? wrapped(a + b)
        : symbol == "-"   ? wrapped(a - b)
                          : wrapped(a * b);
}

Result<Value> ConditionParser::divide(Operator const& op, Value const& left, Value const& right,
                                      std::size_t position) const
{
    bool const is_unsigned = left.is_unsigned || right.is_unsigned;
    bool const is_quotient = op.symbol == "/";
    if (right.number == 0 && is_evaluated_)
        return error_(position, "#if divides by zero");
    if (right.number == 0)
        return Value { 0, is_unsigned };
    if (is_unsigned) {
        auto const value = is_quotient ? bits(left) / bits(right) : bits(left) % bits(right);
        return Value { static_cast<std::int64_t>(value), true };
    }
    // The smallest integer has no negative counterpart, so dividing it by -1 would overflow.
    if (right.number == -1)
        return Value { is_quotient ? static_cast<std::int64_t>(0 - bits(left)) : 0, false };
    return Value { is_quotient ? left.number / right.number : left.number % right.number, false };
}

Result<Value> ConditionParser::unary()
{
    std::string signs;
    for (skip(); at_ < text_.size() && std::string_view("+-!~").find(text_[at_]) != text_.npos;
         skip())
        signs += text_[at_++];
    auto value = TRY(number());
    for (auto sign = signs.rbegin(); sign != signs.rend(); ++sign)
        value = *sign == '-'
            ? Value { static_cast<std::int64_t>(0 - bits(value)), value.is_unsigned }
            : *sign == '!' ? Value { value.number == 0, false }
            : *sign == '~' ? Value { ~value.number, value.is_unsigned }
                           : value;
    return value;
}

Result<Value> ConditionParser::number()
{
    if (take('(')) {
        auto const value = TRY(conditional());
        if (!take(')'))
            return error_(at_, "an opening parenthesis in #if is not closed");
        return value;
    }
    skip();
    if (at_ >= text_.size())
        return error_(at_, "found the end of the line in #if, expected a number or a name");
    auto const position = at_;
    if (text_[at_] == '\'') {
        auto const character = character_constant(text_, at_);
        if (!character)
            return error_(at_, "found ' in #if, expected one character and another '");
        at_ = character->end;
        return Value { character->value, false };
    }
    at_ = token_end(text_, at_);
    auto const token = text_.substr(position, at_ - position);
    if (is_name_start(token.front()))
        return Value {};
    auto digits = token;
    while (!digits.empty() && std::string_view("uUlL").find(digits.back()) != token.npos)
        digits.remove_suffix(1);
    bool const is_hex = digits.substr(0, 2) == "0x" || digits.substr(0, 2) == "0X";
    if (is_hex)
        digits.remove_prefix(2);
    int const base = is_hex ? 16 : digits.size() > 1 && digits.front() == '0' ? 8 : 10;
    std::uint64_t value = 0;
    auto const [end, problem]
        = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (digits.empty() || problem != std::errc() || end != digits.data() + digits.size())
        return error_(position,
                      fmt::format("found '{}' in #if, expected an integer", shown(token)));
    bool const is_unsigned = token.substr(digits.size() + (is_hex ? 2 : 0)).find_first_of("uU")
            != std::string_view::npos
        || value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return Value { static_cast<std::int64_t>(value), is_unsigned };
}

// Parses an escape sequence whose backslash is just before index `at`. Returns the character and
// the index after the sequence.
std::pair<unsigned, std::size_t> escaped_character(std::string_view text, std::size_t at)
{
    constexpr std::string_view kLetters = "abfnrtv";
    constexpr std::string_view kValues = "\a\b\f\n\r\t\v";
    if (auto const letter = kLetters.find(text[at]); letter != kLetters.npos)
        return { static_cast<unsigned char>(kValues[letter]), at + 1 };
    bool const is_hex = text[at] == 'x';
    int const base = is_hex ? 16 : 8;
    auto const begin = at + (is_hex ? 1 : 0);
    auto const digits = text.substr(begin, is_hex ? text.npos : 3);
    unsigned value = 0;
    auto const [end, problem]
        = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (problem != std::errc())
        return { static_cast<unsigned char>(text[at]), at + 1 };
    return { value, begin + static_cast<std::size_t>(end - digits.data()) };
}

} // namespace

std::optional<CharacterConstant> character_constant(std::string_view text, std::size_t at)
{
    std::size_t end = at + 1;
    std::size_t count = 0;
    std::uint32_t value = 0;
    for (; end < text.size() && text[end] != '\''; ++count) {
        unsigned character = static_cast<unsigned char>(text[end++]);
        if (character == '\\' && end < text.size())
            std::tie(character, end) = escaped_character(text, end);
        value = value << 8 | (character & 0xff);
    }
    if (end >= text.size() || count == 0 || count > 4)
        return std::nullopt;
    auto const sign
        = count == 1 ? static_cast<signed char>(value) : static_cast<std::int32_t>(value);
    return CharacterConstant { sign, end + 1 };
}

Result<std::int64_t> condition_value(std::string_view text, ErrorAt const& error)
{
    return ConditionParser(text, error).parse();
}

} // namespace tractus::lsystem
