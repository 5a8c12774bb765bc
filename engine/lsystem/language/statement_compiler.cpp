#include "engine/lsystem/language/statement_compiler.h"

#include "engine/lsystem/text/user_text.h"

#include <array>
#include <fmt/core.h>

namespace tractus::lsystem {

static constexpr int kMaxStatementNesting = 200;

Result<void> StatementCompiler::block(Program& program)
{
    if (!cursor_.take("{"))
        return cursor_.unexpected("'{'");
    if (++depth_ > kMaxStatementNesting)
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

Result<void> StatementCompiler::statement(Program& program)
{
    if (cursor_.take(";"))
        return {};
    auto const begin = cursor_.position();
    auto const word = ExpressionCompiler::name(cursor_);
    if (word == "if")
        return if_statement(program);
    if (word == "while")
        return while_statement(program);
    if (word == "do")
        return do_statement(program);
    cursor_.set_position(begin);
    if (!TRY(assignment(program)))
        frame_.release(TRY(expressions_.expression(program)));
    if (cursor_.take(";"))
        return {};
    // Keywords that are not followed by a condition.
    constexpr std::array<std::string_view, 2> kWords { "else", "do" };
    if (auto const meant = word ? nearest_word(*word, kWords) : ""; !meant.empty())
        return cursor_.error_at(begin,
                                fmt::format("found '{}', expected '{}', perhaps", *word, meant));
    return cursor_.unexpected("';'");
}

Result<void> StatementCompiler::statement_or_block(Program& program)
{
    return cursor_.peek() == '{' ? block(program) : statement(program);
}

// Compiles a condition in parentheses and a jump for the case that it is false. Returns the index
// of the jump instruction, whose target the caller must set.
Result<std::uint16_t> StatementCompiler::jump_unless_condition(Program& program)
{
    if (cursor_.peek() != '(')
        return cursor_.unexpected("'('");
    auto const condition = TRY(expressions_.primary(program));
    auto const jump = TRY(frame_.label(program));
    program.push_back({ .op = Op::JumpIfZero, .target = 0, .left = condition, .right = 0 });
    frame_.release(condition);
    return jump;
}

Result<void> StatementCompiler::if_statement(Program& program)
{
    if (++depth_ > kMaxStatementNesting)
        return cursor_.error("statements are nested too deeply");
    auto const to_else = TRY(jump_unless_condition(program));
    TRY(statement_or_block(program));
    auto const begin = cursor_.position();
    if (ExpressionCompiler::name(cursor_) == "else") {
        auto const to_end = TRY(frame_.label(program));
        program.push_back({ .op = Op::Jump, .target = 0, .left = 0, .right = 0 });
        program[to_else].target = TRY(frame_.label(program));
        TRY(statement_or_block(program));
        program[to_end].target = TRY(frame_.label(program));
    } else {
        cursor_.set_position(begin);
        program[to_else].target = TRY(frame_.label(program));
    }
    --depth_;
    return {};
}

Result<void> StatementCompiler::while_statement(Program& program)
{
    if (++depth_ > kMaxStatementNesting)
        return cursor_.error("statements are nested too deeply");
    auto const begin = TRY(frame_.label(program));
    auto const to_end = TRY(jump_unless_condition(program));
    TRY(statement_or_block(program));
    program.push_back({ .op = Op::Jump, .target = begin, .left = 0, .right = 0 });
    program[to_end].target = TRY(frame_.label(program));
    --depth_;
    return {};
}

Result<void> StatementCompiler::do_statement(Program& program)
{
    auto const begin = TRY(frame_.label(program));
    TRY(block(program));
    if (ExpressionCompiler::name(cursor_) != "while")
        return cursor_.unexpected("'while ('");
    auto const to_end = TRY(jump_unless_condition(program));
    program.push_back({ .op = Op::Jump, .target = begin, .left = 0, .right = 0 });
    program[to_end].target = TRY(frame_.label(program));
    if (!cursor_.take(";"))
        return cursor_.unexpected("';'");
    return {};
}

// Compiles an assignment and returns true. If the next statement is none, consumes nothing and
// returns false.
Result<bool> StatementCompiler::assignment(Program& program)
{
    auto const begin = cursor_.position();
    auto const variable = ExpressionCompiler::name(cursor_);
    if (variable && cursor_.peek() == '[') {
        TRY(assign_element(*variable, program));
        return true;
    }
    if (!variable || !cursor_.sees("=") || cursor_.sees("==")) {
        cursor_.set_position(begin);
        return false;
    }
    cursor_.take("=");
    auto const value = TRY(expressions_.expression(program));
    TRY(expressions_.assign(*variable, value, program));
    frame_.release(value);
    return true;
}

Result<void> StatementCompiler::assign_element(std::string const& array, Program& program)
{
    auto const element = TRY(expressions_.element(array, program));
    if (!cursor_.take("="))
        return cursor_.unexpected("'='");
    auto const value = TRY(expressions_.expression(program));
    TRY(frame_.label(program));
    program.push_back(
        { .op = Op::StoreArray, .target = element.array, .left = element.index, .right = value });
    frame_.release(value);
    frame_.release(element.index);
    return {};
}

} // namespace tractus::lsystem
