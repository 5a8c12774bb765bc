#include "engine/lsystem/language/expression_compiler.h"

#include "engine/lsystem/language/model.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

constexpr int kMaxExpressionNesting = 200;

struct BinaryOperator {
    std::string_view text;
    Op op;
    int level;
};

constexpr int kOrLevel = 0;
constexpr int kAndLevel = 1;
constexpr int kFirstBinaryLevel = 2;
constexpr int kUnaryLevel = 7;

// Longer operators come before their prefixes, because the first match is taken.
constexpr std::array kBinaryOperators {
    BinaryOperator { "==", Op::Equal, 2 },        BinaryOperator { "!=", Op::NotEqual, 2 },
    BinaryOperator { "<>", Op::NotEqual, 2 },     BinaryOperator { "<=", Op::LessEqual, 3 },
    BinaryOperator { ">=", Op::GreaterEqual, 3 }, BinaryOperator { "<", Op::Less, 3 },
    BinaryOperator { ">", Op::Greater, 3 },       BinaryOperator { "+", Op::Add, 4 },
    BinaryOperator { "-", Op::Subtract, 4 },      BinaryOperator { "*", Op::Multiply, 5 },
    BinaryOperator { "/", Op::Divide, 5 },        BinaryOperator { "%", Op::Remainder, 5 },
    BinaryOperator { "^", Op::Power, 6 },
};

BinaryOperator const* binary_operator(Cursor& cursor, int level)
{
    if (cursor.sees_arrow())
        return nullptr;
    for (auto const& candidate : kBinaryOperators)
        if (cursor.sees(candidate.text))
            return candidate.level == level ? &candidate : nullptr;
    return nullptr;
}

} // namespace

std::optional<std::string> ExpressionCompiler::name(Cursor& cursor)
{
    std::string result;
    auto const is_first
        = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
    if (!is_first(cursor.peek()))
        return std::nullopt;
    for (auto const c : cursor.rest()) {
        if (!is_first(c) && !std::isdigit(static_cast<unsigned char>(c)))
            break;
        result.push_back(c);
    }
    cursor.set_position(cursor.position() + result.size());
    return result;
}

std::optional<Register> ExpressionCompiler::add_parameter(std::string const& name)
{
    auto const reg = frame_.add();
    if (!reg || !locals_.emplace(name, Local { *reg, true }).second)
        return std::nullopt;
    return *reg;
}

Result<Register> ExpressionCompiler::expression(Program& program)
{
    if (++depth_ > kMaxExpressionNesting)
        return cursor_.error("the expression is nested too deeply");
    auto const value = TRY(conditional(program));
    --depth_;
    return value;
}

Result<Register> ExpressionCompiler::conditional(Program& program)
{
    auto const condition = TRY(logical(program, kOrLevel));
    if (!cursor_.take("?"))
        return condition;
    auto const to_else = TRY(frame_.label(program));
    program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = condition, .right = 0 });
    frame_.release(condition);
    auto const result = TRY(frame_.temporary());
    auto const yes = TRY(expression(program));
    program.push_back({ .op = Op::Copy, .target = result, .left = yes, .right = 0 });
    frame_.release(yes);
    auto const to_end = TRY(frame_.label(program));
    program.push_back({ .op = Op::Jump, .target = 0, .left = 0, .right = 0 });
    if (!cursor_.take(":"))
        return cursor_.unexpected("':'");
    program[to_else].target = TRY(frame_.label(program));
    auto const no = TRY(expression(program));
    program.push_back({ .op = Op::Copy, .target = result, .left = no, .right = 0 });
    frame_.release(no);
    program[to_end].target = TRY(frame_.label(program));
    return result;
}

// Compiles || and &&. The right operand is evaluated only if the left one does not decide the
// result.
Result<Register> ExpressionCompiler::logical(Program& program, int level)
{
    auto const operand = [&]() -> Result<Register> {
        return level == kAndLevel ? binary(program, kFirstBinaryLevel)
                                  : logical(program, kAndLevel);
    };
    auto left = TRY(operand());
    while (cursor_.take(level == kAndLevel ? "&&" : "||")) {
        auto const result = TRY(frame_.temporary());
        program.push_back({ .op = Op::IsTrue, .target = result, .left = left, .right = 0 });
        frame_.release(left);
        auto jump = TRY(frame_.label(program));
        program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = result, .right = 0 });
        if (level == kOrLevel) {
            program[jump].target = static_cast<std::uint16_t>(jump + 2);
            jump = TRY(frame_.label(program));
            program.push_back({ .op = Op::Jump, .target = 0, .left = 0, .right = 0 });
        }
        auto const right = TRY(operand());
        program.push_back({ .op = Op::IsTrue, .target = result, .left = right, .right = 0 });
        frame_.release(right);
        program[jump].target = TRY(frame_.label(program));
        left = result;
    }
    return left;
}

Result<Register> ExpressionCompiler::binary(Program& program, int level)
{
    if (level == kUnaryLevel)
        return unary(program);
    auto left = TRY(binary(program, level + 1));
    while (auto const* const found = binary_operator(cursor_, level)) {
        cursor_.take(found->text);
        auto const right = TRY(binary(program, level + 1));
        left = TRY(frame_.emit(found->op, left, right, program));
    }
    return left;
}

Result<Register> ExpressionCompiler::unary(Program& program)
{
    bool const is_minus = cursor_.peek() == '-' && !cursor_.sees_arrow();
    if (!is_minus && cursor_.peek() != '!')
        return primary(program);
    if (++depth_ > kMaxExpressionNesting)
        return cursor_.error("the expression is nested too deeply");
    cursor_.take_character();
    auto const operand = TRY(unary(program));
    --depth_;
    return frame_.emit(is_minus ? Op::Negate : Op::Not, operand, operand, program);
}

Result<Register> ExpressionCompiler::primary(Program& program)
{
    if (cursor_.take("(")) {
        auto const value = TRY(expression(program));
        if (!cursor_.take(")"))
            return cursor_.unexpected("')'");
        return value;
    }
    char const c = cursor_.peek();
    if (std::isdigit(static_cast<unsigned char>(c)) || c == '.')
        return number();
    auto const position = cursor_.position();
    auto const found = name(cursor_);
    if (!found)
        return cursor_.unexpected("a number, a name or '('");
    if (cursor_.peek() == '(')
        return call(*found, position, program);
    if (cursor_.peek() == '[') {
        auto const at = TRY(element(*found, program));
        TRY(frame_.label(program));
        frame_.release(at.index);
        auto const target = TRY(frame_.temporary());
        program.push_back(
            { .op = Op::LoadArray, .target = target, .left = at.array, .right = at.index });
        return target;
    }
    return variable(*found, position, program);
}

Result<Register> ExpressionCompiler::number()
{
    auto const text = cursor_.rest();
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc())
        return cursor_.unexpected("a number that is neither too large nor too small");
    cursor_.set_position(cursor_.position() + static_cast<std::size_t>(end - text.data()));
    return frame_.constant(value);
}

Result<Register> ExpressionCompiler::variable(std::string const& name, std::size_t position,
                                              Program& program)
{
    if (auto const found = locals_.find(name); found != locals_.end()) {
        if (!found->second.first_read)
            found->second.first_read = position;
        return found->second.value;
    }
    if (auto const global = names_.find_variable(name)) {
        auto const target = TRY(frame_.temporary());
        TRY(frame_.label(program));
        program.push_back({ .op = Op::LoadGlobal, .target = target, .left = *global, .right = 0 });
        return target;
    }
    if (new_names_ == NewNames::Global) {
        names_.warn_undefined(name, cursor_.source().place(position));
        return frame_.constant(0);
    }
    auto const reg = TRY(frame_.add());
    locals_.emplace(name, Local { reg, false, false, position });
    return reg;
}

Result<ExpressionCompiler::Element> ExpressionCompiler::element(std::string const& name,
                                                                Program& program)
{
    auto const array = std::find_if(names_.arrays.begin(), names_.arrays.end(),
                                    [&](auto const& candidate) { return candidate.name == name; });
    if (array == names_.arrays.end())
        return cursor_.error(fmt::format("found {}[, but no array {} is defined", name, name));
    std::optional<Register> index;
    for (auto const size : array->sizes) {
        if (!cursor_.take("["))
            return cursor_.unexpected(
                fmt::format("'[' (array {} has {} dimensions)", name, array->sizes.size()));
        auto const subscript = TRY(expression(program));
        if (!cursor_.take("]"))
            return cursor_.unexpected("']'");
        if (!index) {
            index = subscript;
            continue;
        }
        auto const factor = TRY(frame_.constant(static_cast<double>(size)));
        auto const row = TRY(frame_.emit(Op::Multiply, *index, factor, program));
        index = TRY(frame_.emit(Op::Add, row, subscript, program));
    }
    return Element { static_cast<std::uint16_t>(array - names_.arrays.begin()), *index };
}

Result<void> ExpressionCompiler::assign(std::string const& variable, Register value,
                                        Program& program)
{
    TRY(frame_.label(program));
    auto local = locals_.find(variable);
    auto const global = names_.find_variable(variable);
    if (local == locals_.end() && !global && new_names_ == NewNames::Local) {
        auto const reg = TRY(frame_.add());
        local = locals_.emplace(variable, Local { reg }).first;
    }
    if (local != locals_.end()) {
        local->second.is_assigned = true;
        program.push_back(
            { .op = Op::Copy, .target = local->second.value, .left = value, .right = 0 });
        return {};
    }
    auto const index = global ? *global : TRY(names_.add_variable(variable, cursor_));
    program.push_back({ .op = Op::StoreGlobal, .target = index, .left = value, .right = 0 });
    return {};
}

Result<Register> ExpressionCompiler::call(std::string const& function, std::size_t position,
                                          Program& program)
{
    cursor_.take("(");
    if (function == "printf")
        return print_call(position, program);
    if (function == "SetDerivationLength" || function == "GetDerivationLength")
        return derivation_length(function, program);
    if (auto const* const missing = find_missing_function(function))
        return missing_call(*missing, position, program);
    auto const* const entry = find_function(function);
    if (!entry) {
        auto const nearest = nearest_function(function);
        auto const expected
            = nearest.empty() ? std::string("one of cpfg's") : fmt::format("{}, perhaps", nearest);
        return cursor_.error_at(
            position, fmt::format("found the function {}, expected {}", function, expected));
    }
    bool const is_function = entry->op == Op::Function;
    bool const is_curve = entry->op >= Op::CurveX && entry->op <= Op::CurveLength;
    auto const left = is_function ? TRY(table_id(names_.functions, program))
        : is_curve                ? TRY(table_id(names_.curves, program))
                                  : TRY(expression(program));
    auto right = left;
    if (entry->parameter_count == 2) {
        if (!cursor_.take(","))
            return cursor_.unexpected(fmt::format("',' ({} takes 2 values)", function));
        right = TRY(expression(program));
    }
    if (!cursor_.take(")"))
        return cursor_.unexpected("')'");
    return frame_.emit(entry->op, left, right, program);
}

Result<Register> ExpressionCompiler::derivation_length(std::string const& function,
                                                       Program& program)
{
    constexpr auto kIndex = static_cast<std::uint16_t>(GlobalIndex::DerivationLength);
    bool const sets = function.front() == 'S';
    auto target = sets ? TRY(expression(program)) : TRY(frame_.temporary());
    if (!sets && cursor_.peek() != ')') // cpfg requires an argument here; its value is ignored.
        frame_.release(TRY(expression(program)));
    if (!cursor_.take(")"))
        return cursor_.unexpected("')'");
    TRY(frame_.label(program));
    if (sets)
        program.push_back({ .op = Op::StoreGlobal, .target = kIndex, .left = target, .right = 0 });
    else
        program.push_back({ .op = Op::LoadGlobal, .target = target, .left = kIndex, .right = 0 });
    return target;
}

// Compiles a call of printf. The values to print go to consecutive registers.
Result<Register> ExpressionCompiler::print_call(std::size_t position, Program& program)
{
    constexpr std::size_t kMaxFormats = 10000;
    if (cursor_.peek() != '"')
        return cursor_.unexpected("a format in double quotes");
    auto const format_position = cursor_.position();
    auto format = parse_print_format(TRY(quoted_text()));
    if (!format)
        return cursor_.error_at(format_position, format.error().message);
    if (names_.formats.size() >= kMaxFormats)
        return cursor_.error("the model has more than 10000 calls of printf");
    std::vector<Register> values;
    while (cursor_.take(","))
        values.push_back(TRY(expression(program)));
    if (!cursor_.take(")"))
        return cursor_.unexpected("',' or ')'");
    if (values.size() != format->value_count())
        names_.warn(fmt::format("{}: the format of printf asks for {} values, found {}; those "
                                "missing are 0",
                                cursor_.source().place(position), format->value_count(),
                                values.size()));
    Register first = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto const reg = TRY(frame_.add());
        first = i == 0 ? reg : first;
        TRY(frame_.label(program));
        program.push_back({ .op = Op::Copy, .target = reg, .left = values[i], .right = 0 });
        frame_.release(values[i]);
    }
    TRY(frame_.label(program));
    program.push_back({ .op = Op::Print,
                        .target = static_cast<std::uint16_t>(names_.formats.size()),
                        .left = first,
                        .right = static_cast<std::uint16_t>(values.size()) });
    names_.formats.push_back(*std::move(format));
    return frame_.constant(0);
}

Result<Register> ExpressionCompiler::text()
{
    auto quoted = TRY(quoted_text());
    auto const found = std::find(names_.texts.begin(), names_.texts.end(), quoted);
    auto const number = std::distance(names_.texts.begin(), found);
    if (found == names_.texts.end())
        names_.texts.push_back(std::move(quoted));
    return frame_.constant(static_cast<double>(number));
}

// Reads a text in double quotes. A backslash and the character after it are kept as they are.
Result<std::string> ExpressionCompiler::quoted_text()
{
    auto const begin = cursor_.position();
    cursor_.take("\"");
    auto const text = cursor_.rest();
    std::size_t end = 0;
    while (end < text.size() && text[end] != '"' && text[end] != '\n')
        end += text[end] == '\\' ? 2 : 1;
    if (end >= text.size() || text[end] == '\n')
        return cursor_.error_at(begin, "the string has no closing '\"'");
    cursor_.set_position(cursor_.position() + end + 1);
    return std::string(text.substr(0, end));
}

Result<Register> ExpressionCompiler::missing_call(MissingFunction const& function,
                                                  std::size_t position, Program& program)
{
    auto const place = cursor_.source().place(position);
    switch (function.about) {
    case MissingFunction::About::Files:
        names_.warn_of("files",
                       fmt::format("{}: models read and write no files here: fopen() gives -1, and "
                                   "fprintf, fscanf, fflush and fclose do nothing",
                                   place));
        break;
    case MissingFunction::About::Window:
        names_.warn_of("window",
                       fmt::format("{}: {}() is about cpfg's window; stop, play and Display do "
                                   "nothing here, and vvXmin to vvScale are 0",
                                   place, function.name));
        break;
    case MissingFunction::About::Blobs:
        names_.warn_of("blobs",
                       fmt::format("{}: inblob() is not supported; its value is 0, as outside of "
                                   "all blobs",
                                   place));
    }
    std::optional<Register> first;
    while (cursor_.peek() != ')') {
        if (cursor_.peek() == '"') {
            TRY(quoted_text());
        } else {
            cursor_.take("&"); // Skips the address operator before an argument of fscanf.
            auto const argument = TRY(expression(program));
            if (!first && function.which == MissingFunction::Value::FirstArgument)
                first = argument;
            else
                frame_.release(argument);
        }
        if (!cursor_.take(",") && cursor_.peek() != ')')
            return cursor_.unexpected(fmt::format("')' to end the call of {}", function.name));
    }
    cursor_.take(")");
    return first ? *first : frame_.constant(function.value);
}

// Compiles the number of a function or curve, which may also be given by a name in `tables`.
Result<Register> ExpressionCompiler::table_id(std::vector<std::string> const& tables,
                                              Program& program)
{
    auto const begin = cursor_.position();
    if (auto const found = name(cursor_)) {
        auto const table = std::find(tables.begin(), tables.end(), *found);
        if (table != tables.end() && (cursor_.peek() == ',' || cursor_.peek() == ')'))
            return frame_.constant(static_cast<double>(table - tables.begin() + 1));
    }
    cursor_.set_position(begin);
    return expression(program);
}

} // namespace tractus::lsystem
