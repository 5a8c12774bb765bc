#include "engine/lsystem/condition.h"

#include "engine/lsystem/placed_text.h"
#include "engine/lsystem/user_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/core.h>
#include <limits>
#include <optional>

namespace tractus {

namespace {

constexpr int kMaxNesting = 100;

struct Operator {
    std::string_view symbol;
    int strength; // The greater, the tighter it binds.
};
// Those of two characters before their beginnings.
constexpr std::array kOperators {
    Operator { "||", 1 }, Operator { "&&", 2 }, Operator { "==", 6 }, Operator { "!=", 6 },
    Operator { "<=", 7 }, Operator { ">=", 7 }, Operator { "<<", 8 }, Operator { ">>", 8 },
    Operator { "|", 3 },  Operator { "^", 4 },  Operator { "&", 5 },  Operator { "<", 7 },
    Operator { ">", 7 },  Operator { "+", 9 },  Operator { "-", 9 },  Operator { "*", 10 },
    Operator { "/", 10 }, Operator { "%", 10 },
};

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
        return value;
    }

private:
    Result<std::int64_t> conditional();
    Result<std::int64_t> binary(int strength);
    Result<std::int64_t> unary();
    Result<std::int64_t> number();
    Result<std::int64_t> apply(Operator const& op, std::int64_t left, std::int64_t right,
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
    bool is_evaluated_ = true; // False where && || ?: pass over what may be wrong, such as 1/0.
};

Result<std::int64_t> ConditionParser::conditional()
{
    if (depth_ > kMaxNesting)
        return error_(at_, fmt::format("#if is nested deeper than {}", kMaxNesting));
    ++depth_;
    auto const condition = TRY(binary(1));
    auto result = condition;
    if (take('?')) {
        bool const outer = is_evaluated_;
        is_evaluated_ = outer && condition != 0;
        auto const first = TRY(conditional());
        if (!take(':'))
            return error_(at_, "found ? in #if, expected : behind it");
        is_evaluated_ = outer && condition == 0;
        auto const second = TRY(conditional());
        is_evaluated_ = outer;
        result = condition != 0 ? first : second;
    }
    --depth_;
    return result;
}

// The operator here, if it binds at least so tightly.
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

Result<std::int64_t> ConditionParser::binary(int strength)
{
    auto left = TRY(unary());
    while (auto const op = take_operator(strength)) {
        auto const position = at_ - op->symbol.size();
        bool const outer = is_evaluated_;
        if ((op->symbol == "&&" && left == 0) || (op->symbol == "||" && left != 0))
            is_evaluated_ = false;
        auto const right = TRY(binary(op->strength + 1));
        is_evaluated_ = outer;
        left = TRY(apply(*op, left, right, position));
    }
    return left;
}

Result<std::int64_t> ConditionParser::apply(Operator const& op, std::int64_t left,
                                            std::int64_t right, std::size_t position) const
{
    auto const a = static_cast<std::uint64_t>(left);
    auto const b = static_cast<std::uint64_t>(right);
    auto const wrapped = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
    auto const& symbol = op.symbol;
    if (symbol == "/" || symbol == "%") {
        if (right == 0 && is_evaluated_)
            return error_(position, "#if divides by zero");
        if (right == 0)
            return std::int64_t { 0 };
        if (right == -1) // The least number has no opposite.
            return symbol == "/" ? wrapped(0 - a) : std::int64_t { 0 };
        return symbol == "/" ? left / right : left % right;
    }
    bool const is_far = b >= 64;
    return symbol == "||" ? std::int64_t { left != 0 || right != 0 }
        : symbol == "&&"  ? std::int64_t { left != 0 && right != 0 }
        : symbol == "=="  ? std::int64_t { left == right }
        : symbol == "!="  ? std::int64_t { left != right }
        : symbol == "<="  ? std::int64_t { left <= right }
        : symbol == ">="  ? std::int64_t { left >= right }
        : symbol == "<"   ? std::int64_t { left < right }
        : symbol == ">"   ? std::int64_t { left > right }
        : symbol == "<<"  ? (is_far ? std::int64_t { 0 } : wrapped(a << b))
        : symbol == ">>"  ? (is_far ? std::int64_t { left < 0 ? -1 : 0 } : left >> right)
        : symbol == "|"   ? wrapped(a | b)
        : symbol == "^"   ? wrapped(a ^ b)
        : symbol == "&"   ? wrapped(a & b)
        : symbol == "+"   ? wrapped(a + b)
        : symbol == "-"   ? wrapped(a - b)
                          : wrapped(a * b);
}

Result<std::int64_t> ConditionParser::unary()
{
    std::string signs;
    for (skip(); at_ < text_.size() && std::string_view("+-!~").find(text_[at_]) != text_.npos;
         skip())
        signs += text_[at_++];
    auto value = TRY(number());
    for (auto sign = signs.rbegin(); sign != signs.rend(); ++sign)
        value = *sign == '-' ? static_cast<std::int64_t>(0 - static_cast<std::uint64_t>(value))
            : *sign == '!'   ? std::int64_t { value == 0 }
            : *sign == '~'   ? ~value
                             : value;
    return value;
}

Result<std::int64_t> ConditionParser::number()
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
    at_ = token_end(text_, at_);
    auto const token = text_.substr(position, at_ - position);
    if (is_name_start(token.front()))
        return std::int64_t { 0 };
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
    return static_cast<std::int64_t>(value);
}

} // namespace

Result<std::int64_t> condition_value(std::string_view text, ErrorAt const& error)
{
    return ConditionParser(text, error).parse();
}

} // namespace tractus
