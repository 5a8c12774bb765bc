#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/expression_compiler.h"
#include "engine/lsystem/language/program.h"

#include <string>

namespace tractus::lsystem {

// Compiles cpfg's C-like statements: assignments, calls, if, while, do and blocks.
class StatementCompiler {
public:
    explicit StatementCompiler(ExpressionCompiler& expressions)
        : expressions_(expressions)
        , cursor_(expressions.cursor())
        , frame_(expressions.frame())
    {
    }

    // Compiles a block of statements in braces and appends its instructions to `program`.
    Result<void> block(Program& program);

private:
    Result<void> statement(Program& program);
    Result<void> if_statement(Program& program);
    Result<void> while_statement(Program& program);
    Result<void> do_statement(Program& program);
    Result<void> statement_or_block(Program& program);
    Result<bool> assignment(Program& program);
    Result<void> assign_element(std::string const& array, Program& program);
    Result<std::uint16_t> jump_unless_condition(Program& program);

    ExpressionCompiler& expressions_;
    Cursor& cursor_;
    FrameBuilder& frame_;
    int depth_ = 0;
};

} // namespace tractus::lsystem
