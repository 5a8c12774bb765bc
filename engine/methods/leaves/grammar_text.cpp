#include "engine/methods/leaves/grammar_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

} // namespace

GrammarText::GrammarText(std::string_view text, std::string name)
    : text_(text)
    , name_(std::move(name))
{
    skip();
}

// Skips blanks and comments. A comment is enclosed between two @; a last @ without a partner is not
// skipped.
void GrammarText::skip()
{
    while (at_ < text_.size()) {
        char const c = text_[at_];
        if (c == '@') {
            auto const end = text_.find('@', at_ + 1);
            if (end == std::string_view::npos)
                return;
            for (; at_ <= end; ++at_)
                count_line();
        } else if (c == ' ' || c == '\t' || c == '\r' || (c == '\n' && !stays_in_line_)) {
            count_line();
            ++at_;
        } else {
            return;
        }
    }
}

void GrammarText::count_line()
{
    if (text_[at_] != '\n')
        return;
    ++line_;
    line_begin_ = at_ + 1;
}

TextPlace GrammarText::place() const
{
    return { line_, static_cast<int>(at_ - line_begin_) + 1 };
}

char GrammarText::peek()
{
    skip();
    if (at_ >= text_.size() || (stays_in_line_ && text_[at_] == '\n'))
        return '\0';
    return text_[at_];
}

bool GrammarText::next_is(std::string_view sign)
{
    return peek() != '\0' && text_.substr(at_).starts_with(sign);
}

bool GrammarText::take(std::string_view sign)
{
    if (!next_is(sign))
        return false;
    at_ += sign.size();
    skip();
    return true;
}

bool GrammarText::take_arrow()
{
    return take("→") || take("-->") || take("->");
}

Result<void> GrammarText::expect(std::string_view sign)
{
    if (!take(sign))
        return fail_expected(fmt::format("\"{}\"", sign));
    return {};
}

Result<std::string_view> GrammarText::word(std::string_view what)
{
    if (!is_letter(peek()))
        return fail_expected(what);
    auto const begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_])))
        ++at_;
    auto const word = text_.substr(begin, at_ - begin);
    skip();
    return word;
}

Result<double> GrammarText::number()
{
    (void)peek();
    double value = 0;
    auto const* const begin = text_.data() + at_;
    auto const [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc() || end == begin)
        return fail_expected("a number");
    at_ += static_cast<std::size_t>(end - begin);
    skip();
    return value;
}

tl::unexpected<Error> GrammarText::fail_at(TextPlace const& place, std::string const& what) const
{
    return fail(Fault::User, fmt::format("{}:{}:{}: {}", name_, place.line, place.column, what));
}

tl::unexpected<Error> GrammarText::fail_here(std::string const& what)
{
    (void)peek();
    return fail_at(place(), what);
}

tl::unexpected<Error> GrammarText::fail_expected(std::string_view what)
{
    char const c = peek();
    if (c == '@')
        return fail_here("a comment begins here that no second @ ends");
    if (c == '\0')
        return fail_here(fmt::format("the {} ends where {} is expected",
                                     stays_in_line_ ? "line" : "grammar", what));
    auto const length = is_letter(c)
        ? std::distance(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                        std::find_if_not(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.end(),
                                         [](char d) { return is_letter(d) || is_digit(d); }))
        : 1;
    constexpr std::ptrdiff_t kMaxShown = 30;
    auto const shown
        = text_.substr(at_, static_cast<std::size_t>(std::min<std::ptrdiff_t>(length, kMaxShown)));
    bool const is_plain = shown.size() > 1 || (c > ' ' && c < 127);
    return fail_here(is_plain ? fmt::format("\"{}\" stands where {} is expected", shown, what)
                              : fmt::format("{} is expected", what));
}

namespace {

struct Operator {
    std::string_view sign;
    Operation::Kind kind;
    int rank;
};

// Operators with their precedence. An operator comes before those that are a prefix of it.
constexpr std::array kOperators {
    Operator { "||", Operation::Kind::Or, 1 },
    Operator { "&&", Operation::Kind::And, 2 },
    Operator { "==", Operation::Kind::Equal, 3 },
    Operator { "!=", Operation::Kind::Unequal, 3 },
    Operator { "<=", Operation::Kind::LessOrEqual, 4 },
    Operator { ">=", Operation::Kind::GreaterOrEqual, 4 },
    Operator { "<", Operation::Kind::Less, 4 },
    Operator { ">", Operation::Kind::Greater, 4 },
    Operator { "+", Operation::Kind::Add, 5 },
    Operator { "-", Operation::Kind::Subtract, 5 },
    Operator { "*", Operation::Kind::Multiply, 6 },
    Operator { "/", Operation::Kind::Divide, 6 },
    Operator { "%", Operation::Kind::Remainder, 6 },
    Operator { "^", Operation::Kind::Power, 8 },
};
constexpr int kComparisonRank = 4;
constexpr int kSignRank = 7;    // Precedence of the sign: -a ^ b means -(a ^ b).
constexpr int kHighestRank = 9; // Precedence above that of any operator.
constexpr int kDeepest = 200;

class ExpressionReader {
public:
    ExpressionReader(GrammarText& text, NameTable& names, bool in_angles)
        : text_(text)
        , names_(names)
        , in_angles_(in_angles)
    {
    }

    Result<Expression> read()
    {
        TRY(choice());
        return std::move(made_);
    }

private:
    using Kind = Operation::Kind;

    void add(Operation operation) { made_.operations.push_back(operation); }

    Result<void> choice()
    {
        TRY(binary(1));
        if (text_.take("?")) {
            auto const test = add_skip(Kind::SkipIfZero);
            TRY(choice());
            TRY(text_.expect(":"));
            auto const over = add_skip(Kind::Skip);
            land(test);
            // A choice (?:) counts towards the depth, because choices can nest without parentheses.
            ++depth_;
            TRY(choice());
            --depth_;
            land(over);
        }
        return {};
    }

    std::size_t add_skip(Kind kind)
    {
        add({ .kind = kind });
        return made_.operations.size();
    }
    // Makes a skip lead to the operation that is added next.
    void land(std::size_t skip)
    {
        made_.operations[skip - 1].target = made_.operations.size() - skip;
    }

    Operator const* next_operator(int least)
    {
        for (auto const& candidate : kOperators) {
            if (!text_.next_is(candidate.sign))
                continue;
            bool const is_bracket = in_angles_ && candidate.rank == kComparisonRank;
            return candidate.rank >= least && !is_bracket ? &candidate : nullptr;
        }
        return nullptr;
    }

    Result<void> binary(int least)
    {
        if (++depth_ > kDeepest)
            return text_.fail_here(fmt::format("an expression is nested deeper than {}", kDeepest));
        TRY(unary());
        while (auto const* const found = next_operator(least)) {
            text_.take(found->sign);
            TRY(binary(found->kind == Kind::Power ? found->rank : found->rank + 1));
            add({ .kind = found->kind });
        }
        --depth_;
        return {};
    }

    Result<void> unary()
    {
        if (text_.take("-")) {
            TRY(binary(kSignRank));
            add({ .kind = Kind::Negate });
            return {};
        }
        if (text_.next_is("!") && !text_.next_is("!=")) {
            text_.take("!");
            TRY(binary(kHighestRank));
            add({ .kind = Kind::Not });
            return {};
        }
        if (text_.take("("))
            return in_parentheses();
        char const c = text_.peek();
        if (is_digit(c) || c == '.') {
            add({ .kind = Kind::Number, .number = TRY(text_.number()) });
            return {};
        }
        auto const place = text_.place();
        auto const word = TRY(text_.word("a value"));
        if (text_.next_is("("))
            return call(word, place);
        add({ .kind = Kind::Name, .target = names_.number_of(word) });
        return {};
    }

    Result<void> in_parentheses()
    {
        bool const outside = std::exchange(in_angles_, false);
        TRY(choice());
        TRY(text_.expect(")"));
        in_angles_ = outside;
        return {};
    }

    Result<void> call(std::string_view word, TextPlace const& place)
    {
        auto const* const function = find_function(word);
        if (!function)
            return text_.fail_at(place, fmt::format("there is no function {}", word));
        bool const outside = std::exchange(in_angles_, false);
        TRY(text_.expect("("));
        for (int i = 0; i < function->arguments; ++i) {
            if (i > 0)
                TRY(text_.expect(","));
            TRY(choice());
        }
        TRY(text_.expect(")"));
        in_angles_ = outside;
        add({ .kind = Kind::Call, .function = function->function });
        return {};
    }

    GrammarText& text_;
    NameTable& names_;
    bool in_angles_;
    int depth_ = 0;
    Expression made_;
};

} // namespace

Result<Expression> read_expression(GrammarText& text, NameTable& names, bool in_angles)
{
    return ExpressionReader(text, names, in_angles).read();
}

} // namespace tractus::leaf
