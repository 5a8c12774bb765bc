#include "engine/lsystem/expression_compiler.h"

#include "engine/lsystem/arithmetic.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fmt/core.h>

namespace tractus {

namespace {

constexpr int kMaxNesting = 200;
constexpr std::size_t kMaxSize = 30000; // Registers and instructions are numbered with 16 bits.

struct FunctionEntry {
    std::string_view name;
    Op op;
    int parameter_count;
};

constexpr std::array kFunctions {
    FunctionEntry { "sin", Op::Sin, 1 },          FunctionEntry { "cos", Op::Cos, 1 },
    FunctionEntry { "tan", Op::Tan, 1 },          FunctionEntry { "asin", Op::Asin, 1 },
    FunctionEntry { "acos", Op::Acos, 1 },        FunctionEntry { "atan", Op::Atan, 1 },
    FunctionEntry { "atan2", Op::Atan2, 2 },      FunctionEntry { "exp", Op::Exp, 1 },
    FunctionEntry { "log", Op::Log, 1 },          FunctionEntry { "floor", Op::Floor, 1 },
    FunctionEntry { "ceil", Op::Ceil, 1 },        FunctionEntry { "trunc", Op::Round, 1 },
    FunctionEntry { "fabs", Op::Abs, 1 },         FunctionEntry { "sign", Op::Sign, 1 },
    FunctionEntry { "sqrt", Op::Sqrt, 1 },        FunctionEntry { "pow", Op::Power, 2 },
    FunctionEntry { "ran", Op::Random, 1 },       FunctionEntry { "nran", Op::Normal, 2 },
    FunctionEntry { "bran", Op::Beta, 2 },        FunctionEntry { "biran", Op::Binomial, 2 },
    FunctionEntry { "srand", Op::SeedRandom, 1 }, FunctionEntry { "func", Op::Function, 2 },
};

// cpfg's functions that we lack. Their value is 0.
constexpr std::array<std::string_view, 22> kIgnoredFunctions { "printf",
                                                               "fprintf",
                                                               "fopen",
                                                               "fclose",
                                                               "fflush",
                                                               "fscanf",
                                                               "stop",
                                                               "play",
                                                               "inblob",
                                                               "curveX",
                                                               "curveY",
                                                               "curveZ",
                                                               "curveGAL",
                                                               "SetDerivationLength",
                                                               "GetDerivationLength",
                                                               "Display",
                                                               "vvXmin",
                                                               "vvXmax",
                                                               "vvYmin",
                                                               "vvYmax",
                                                               "vvZmin",
                                                               "vvZmax" };

struct BinaryOperator {
    std::string_view text;
    Op op;
    int level;
};

constexpr int kOrLevel = 0;
constexpr int kAndLevel = 1;
constexpr int kFirstBinaryLevel = 2;
constexpr int kUnaryLevel = 7;

// Longer ones first.
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

std::optional<std::uint16_t> GlobalNames::find(std::string_view name) const
{
    auto const found = std::find(variables.begin(), variables.end(), name);
    if (found == variables.end())
        return std::nullopt;
    return static_cast<std::uint16_t>(found - variables.begin());
}

void GlobalNames::warn(std::string warning)
{
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(std::move(warning));
}

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
    auto const reg = new_register(0);
    if (!reg || !names_.emplace(name, *reg).second)
        return std::nullopt;
    return *reg;
}

RegisterFile ExpressionCompiler::take_frame()
{
    return std::move(frame_);
}

void ExpressionCompiler::prepend_reset(Program& program) const
{
    Program result;
    for (auto const reg : reset_)
        result.push_back({ .op = Op::Copy, .target = reg, .left = constants_.at(0), .right = 0 });
    for (auto instruction : program) {
        if (instruction.op == Op::Jump || instruction.op == Op::JumpIfZero)
            instruction.target = static_cast<std::uint16_t>(instruction.target + reset_.size());
        result.push_back(instruction);
    }
    program = std::move(result);
}

Result<Register> ExpressionCompiler::new_register(double value)
{
    if (frame_.size() >= kMaxSize)
        return cursor_.error("this rule is too large: it needs more than 30000 values");
    frame_.push_back(value);
    values_.emplace_back();
    return static_cast<Register>(frame_.size() - 1);
}

Result<Register> ExpressionCompiler::constant(double value)
{
    if (auto const found = constants_.find(value); found != constants_.end())
        return found->second;
    auto const reg = TRY(new_register(value));
    values_[reg].is_constant = true;
    if (value == value) // A map cannot find NaN again.
        constants_.emplace(value, reg);
    return reg;
}

Result<Register> ExpressionCompiler::temporary()
{
    if (!free_temporaries_.empty()) {
        auto const reg = free_temporaries_.back();
        free_temporaries_.pop_back();
        return reg;
    }
    auto const reg = TRY(new_register(0));
    values_[reg].is_temporary = true;
    return reg;
}

void ExpressionCompiler::release(Register reg)
{
    if (values_[reg].is_temporary)
        free_temporaries_.push_back(reg);
}

Result<std::uint16_t> ExpressionCompiler::label(Program const& program)
{
    if (program.size() >= kMaxSize)
        return cursor_.error("this rule is too large: it needs more than 30000 instructions");
    return static_cast<std::uint16_t>(program.size());
}

Result<Register> ExpressionCompiler::emit(Op op, Register left, Register right, Program& program)
{
    if (is_pure(op) && values_[left].is_constant && values_[right].is_constant)
        return constant(compute(op, frame_[left], frame_[right]));
    TRY(label(program));
    release(left);
    if (right != left)
        release(right);
    auto const target = TRY(temporary());
    program.push_back({ .op = op, .target = target, .left = left, .right = right });
    return target;
}

Result<void> ExpressionCompiler::block(Program& program)
{
    if (!cursor_.take("{"))
        return cursor_.unexpected("'{'");
    if (++depth_ > kMaxNesting)
        return cursor_.error("blocks are nested too deeply");
    cursor_.enter_block();
    while (cursor_.peek() != '}') {
        if (cursor_.at_end())
            return cursor_.unexpected("'}'");
        TRY(statement(program));
    }
    cursor_.leave_block();
    --depth_;
    cursor_.take("}");
    return {};
}

Result<void> ExpressionCompiler::statement(Program& program)
{
    if (cursor_.take(";"))
        return {};
    auto const begin = cursor_.position();
    auto const word = name(cursor_);
    if (word == "if")
        return if_statement(program);
    if (word == "while")
        return while_statement(program);
    if (word == "do")
        return do_statement(program);
    cursor_.set_position(begin);
    if (!TRY(assignment(program))) {
        auto const value = TRY(expression(program));
        release(value);
    }
    if (!cursor_.take(";"))
        return cursor_.unexpected("';'");
    return {};
}

Result<void> ExpressionCompiler::statement_or_block(Program& program)
{
    return cursor_.peek() == '{' ? block(program) : statement(program);
}

Result<void> ExpressionCompiler::if_statement(Program& program)
{
    if (++depth_ > kMaxNesting)
        return cursor_.error("statements are nested too deeply");
    if (cursor_.peek() != '(')
        return cursor_.unexpected("'('");
    auto const condition = TRY(primary(program));
    auto const to_else = TRY(label(program));
    program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = condition, .right = 0 });
    release(condition);
    ++conditional_depth_;
    TRY(statement_or_block(program));
    auto const begin = cursor_.position();
    if (name(cursor_) == "else") {
        auto const to_end = TRY(label(program));
        program.push_back({ .op = Op::Jump, .target = 0, .left = 0, .right = 0 });
        program[to_else].target = TRY(label(program));
        TRY(statement_or_block(program));
        program[to_end].target = TRY(label(program));
    } else {
        cursor_.set_position(begin);
        program[to_else].target = TRY(label(program));
    }
    --conditional_depth_;
    --depth_;
    return {};
}

Result<void> ExpressionCompiler::while_statement(Program& program)
{
    if (++depth_ > kMaxNesting)
        return cursor_.error("statements are nested too deeply");
    if (cursor_.peek() != '(')
        return cursor_.unexpected("'('");
    auto const begin = TRY(label(program));
    auto const condition = TRY(primary(program));
    auto const to_end = TRY(label(program));
    program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = condition, .right = 0 });
    release(condition);
    ++conditional_depth_;
    TRY(statement_or_block(program));
    --conditional_depth_;
    program.push_back({ .op = Op::Jump, .target = begin, .left = 0, .right = 0 });
    program[to_end].target = TRY(label(program));
    --depth_;
    return {};
}

Result<void> ExpressionCompiler::do_statement(Program& program)
{
    auto const begin = TRY(label(program));
    TRY(block(program));
    if (name(cursor_) != "while" || cursor_.peek() != '(')
        return cursor_.unexpected("'while ('");
    auto const condition = TRY(primary(program));
    auto const to_end = TRY(label(program));
    program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = condition, .right = 0 });
    release(condition);
    program.push_back({ .op = Op::Jump, .target = begin, .left = 0, .right = 0 });
    program[to_end].target = TRY(label(program));
    if (!cursor_.take(";"))
        return cursor_.unexpected("';'");
    return {};
}

// Whether an assignment stood here; if not, nothing is read.
Result<bool> ExpressionCompiler::assignment(Program& program)
{
    auto const begin = cursor_.position();
    auto const variable = name(cursor_);
    if (variable && cursor_.peek() == '[') {
        TRY(assign_array(*variable, program));
        return true;
    }
    if (!variable || !cursor_.sees("=") || cursor_.sees("==")) {
        cursor_.set_position(begin);
        return false;
    }
    cursor_.take("=");
    auto const value = TRY(expression(program));
    TRY(assign(*variable, value, program));
    release(value);
    return true;
}

Result<void> ExpressionCompiler::assign_array(std::string const& array, Program& program)
{
    auto const element = TRY(array_element(array, program));
    if (!cursor_.take("="))
        return cursor_.unexpected("'='");
    auto const value = TRY(expression(program));
    TRY(label(program));
    program.push_back(
        { .op = Op::StoreArray, .target = element.array, .left = element.index, .right = value });
    release(value);
    release(element.index);
    return {};
}

Result<void> ExpressionCompiler::assign(std::string const& variable, Register value,
                                        Program& program)
{
    TRY(label(program));
    auto local = names_.find(variable);
    auto const global = globals_.find(variable);
    if (local == names_.end() && !global && new_names_ == NewNames::Local) {
        auto const reg = TRY(new_register(0));
        local = names_.emplace(variable, reg).first;
        if (conditional_depth_ > 0) {
            TRY(constant(0));
            reset_.push_back(reg);
        }
    }
    if (local != names_.end()) {
        program.push_back({ .op = Op::Copy, .target = local->second, .left = value, .right = 0 });
        return {};
    }
    if (!global)
        globals_.variables.push_back(variable);
    auto const index = global ? *global : static_cast<std::uint16_t>(globals_.variables.size() - 1);
    program.push_back({ .op = Op::StoreGlobal, .target = index, .left = value, .right = 0 });
    return {};
}

Result<Register> ExpressionCompiler::expression(Program& program)
{
    if (++depth_ > kMaxNesting)
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
    auto const to_else = TRY(label(program));
    program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = condition, .right = 0 });
    release(condition);
    auto const result = TRY(temporary());
    ++conditional_depth_;
    auto const yes = TRY(expression(program));
    program.push_back({ .op = Op::Copy, .target = result, .left = yes, .right = 0 });
    release(yes);
    auto const to_end = TRY(label(program));
    program.push_back({ .op = Op::Jump, .target = 0, .left = 0, .right = 0 });
    if (!cursor_.take(":"))
        return cursor_.unexpected("':'");
    program[to_else].target = TRY(label(program));
    auto const no = TRY(expression(program));
    program.push_back({ .op = Op::Copy, .target = result, .left = no, .right = 0 });
    release(no);
    program[to_end].target = TRY(label(program));
    --conditional_depth_;
    return result;
}

// || and &&: the right side is evaluated only when the left does not decide.
Result<Register> ExpressionCompiler::logical(Program& program, int level)
{
    auto const operand = [&]() -> Result<Register> {
        return level == kAndLevel ? binary(program, kFirstBinaryLevel)
                                  : logical(program, kAndLevel);
    };
    auto left = TRY(operand());
    while (cursor_.take(level == kAndLevel ? "&&" : "||")) {
        auto const result = TRY(temporary());
        program.push_back({ .op = Op::IsTrue, .target = result, .left = left, .right = 0 });
        release(left);
        auto jump = TRY(label(program));
        program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = result, .right = 0 });
        if (level == kOrLevel) {
            program[jump].target = static_cast<std::uint16_t>(jump + 2);
            jump = TRY(label(program));
            program.push_back({ .op = Op::Jump, .target = 0, .left = 0, .right = 0 });
        }
        auto const right = TRY(operand());
        program.push_back({ .op = Op::IsTrue, .target = result, .left = right, .right = 0 });
        release(right);
        program[jump].target = TRY(label(program));
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
        left = TRY(emit(found->op, left, right, program));
    }
    return left;
}

Result<Register> ExpressionCompiler::unary(Program& program)
{
    bool const is_minus = cursor_.peek() == '-' && !cursor_.sees_arrow();
    if (!is_minus && cursor_.peek() != '!')
        return primary(program);
    if (++depth_ > kMaxNesting)
        return cursor_.error("the expression is nested too deeply");
    cursor_.take_character();
    auto const operand = TRY(unary(program));
    --depth_;
    return emit(is_minus ? Op::Negate : Op::Not, operand, operand, program);
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
        auto const element = TRY(array_element(*found, program));
        TRY(label(program));
        release(element.index);
        auto const target = TRY(temporary());
        program.push_back({ .op = Op::LoadArray,
                            .target = target,
                            .left = element.array,
                            .right = element.index });
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
    return constant(value);
}

Result<Register> ExpressionCompiler::variable(std::string const& name, std::size_t position,
                                              Program& program)
{
    if (auto const found = names_.find(name); found != names_.end())
        return found->second;
    if (auto const global = globals_.find(name)) {
        auto const target = TRY(temporary());
        TRY(label(program));
        program.push_back({ .op = Op::LoadGlobal, .target = target, .left = *global, .right = 0 });
        return target;
    }
    globals_.warn(fmt::format("{}: {} is not defined; its value is 0",
                              cursor_.source().place(position), name));
    if (new_names_ == NewNames::Global)
        return constant(0);
    auto const reg = TRY(new_register(0));
    TRY(constant(0));
    names_.emplace(name, reg);
    reset_.push_back(reg);
    return reg;
}

Result<ExpressionCompiler::Element> ExpressionCompiler::array_element(std::string const& name,
                                                                      Program& program)
{
    auto const array = std::find_if(globals_.arrays.begin(), globals_.arrays.end(),
                                    [&](auto const& candidate) { return candidate.name == name; });
    if (array == globals_.arrays.end())
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
        auto const factor = TRY(constant(static_cast<double>(size)));
        auto const row = TRY(emit(Op::Multiply, *index, factor, program));
        index = TRY(emit(Op::Add, row, subscript, program));
    }
    return Element { static_cast<std::uint16_t>(array - globals_.arrays.begin()), *index };
}

Result<Register> ExpressionCompiler::call(std::string const& function, std::size_t position,
                                          Program& program)
{
    auto const* const entry
        = std::find_if(kFunctions.begin(), kFunctions.end(),
                       [&](auto const& candidate) { return candidate.name == function; });
    if (entry == kFunctions.end()) {
        if (std::find(kIgnoredFunctions.begin(), kIgnoredFunctions.end(), function)
            == kIgnoredFunctions.end())
            return cursor_.error_at(
                position, fmt::format("found the function {}, expected one of cpfg's", function));
        globals_.warn(fmt::format("{}: {}() is not supported; its value is 0",
                                  cursor_.source().place(position), function));
        return ignored_call(function, program);
    }
    cursor_.take("(");
    auto const left
        = entry->op == Op::Function ? TRY(function_id(program)) : TRY(expression(program));
    auto right = left;
    if (entry->parameter_count == 2) {
        if (!cursor_.take(","))
            return cursor_.unexpected(fmt::format("',' ({} takes 2 values)", function));
        right = TRY(expression(program));
    }
    if (!cursor_.take(")"))
        return cursor_.unexpected("')'");
    return emit(entry->op, left, right, program);
}

Result<Register> ExpressionCompiler::ignored_call(std::string const& function, Program& program)
{
    cursor_.take("(");
    while (cursor_.peek() != ')') {
        if (cursor_.take("\"")) {
            auto const close = cursor_.rest().find('"');
            if (close == std::string_view::npos)
                return cursor_.error("the string has no closing '\"'");
            cursor_.set_position(cursor_.position() + close + 1);
        } else {
            cursor_.take("&"); // The address of a variable, for fscanf.
            release(TRY(expression(program)));
        }
        if (!cursor_.take(",") && cursor_.peek() != ')')
            return cursor_.unexpected(fmt::format("')' to end the call of {}", function));
    }
    cursor_.take(")");
    return constant(0);
}

// A function's number, or its name in the view file.
Result<Register> ExpressionCompiler::function_id(Program& program)
{
    auto const begin = cursor_.position();
    if (auto const found = name(cursor_)) {
        auto const function
            = std::find(globals_.functions.begin(), globals_.functions.end(), *found);
        if (function != globals_.functions.end() && cursor_.peek() == ',')
            return constant(static_cast<double>(function - globals_.functions.begin() + 1));
    }
    cursor_.set_position(begin);
    return expression(program);
}

} // namespace tractus
