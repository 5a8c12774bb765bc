#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/frame_builder.h"
#include "engine/lsystem/language/functions.h"
#include "engine/lsystem/language/names.h"
#include "engine/lsystem/language/program.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lsystem {

// Compiles cpfg's C-like expressions to programs that share one frame of registers.
//
// Operators from lowest to highest precedence: ?: || && == != (or <>) < <= >= > + - * / % ^ - !.
// All binary operators are left-associative, so -2^2 is 4 and 2^3^2 is 64.
class ExpressionCompiler {
public:
    // Scope of the variables that assignments create: global in the blocks of an L-system, local in
    // rules.
    enum class NewNames { Global, Local };

    ExpressionCompiler(Cursor& cursor, Names& names, NewNames new_names)
        : cursor_(cursor)
        , names_(names)
        , new_names_(new_names)
        , frame_(cursor)
    {
    }

    // Adds a formal parameter of the rule; returns no value if the name is already used.
    std::optional<Register> add_parameter(std::string const& name);

    // Compiles an expression; returns the register of its value.
    Result<Register> expression(Program& program);
    // Compiles a primary expression: an expression in parentheses, a number, a name or a call.
    Result<Register> primary(Program& program);

    // Reads a quoted string that is a parameter of a module. Returns the register that contains the
    // string's number in the model.
    Result<Register> text();

    // An element of an array. element() reads the element's index after the array's name has been
    // read.
    struct Element {
        std::uint16_t array = 0;
        Register index = 0;
    };
    Result<Element> element(std::string const& array, Program& program);

    Result<void> assign(std::string const& variable, Register value, Program& program);

    // A local variable or a parameter of a rule.
    struct Local {
        Register value = 0;
        bool is_parameter = false;
        bool is_assigned = false;
        // Position in the text at which the variable is first read; no value if it is never read.
        std::optional<std::size_t> first_read {};
    };
    std::map<std::string, Local, std::less<>> const& locals() const { return locals_; }

    Cursor& cursor() { return cursor_; }
    FrameBuilder& frame() { return frame_; }

    // Reads a name; returns no value if none comes next.
    static std::optional<std::string> name(Cursor& cursor);

private:
    Result<Register> conditional(Program& program);
    Result<Register> logical(Program& program, int level);
    Result<Register> binary(Program& program, int level);
    Result<Register> unary(Program& program);
    Result<Register> number();
    Result<Register> variable(std::string const& name, std::size_t position, Program& program);
    Result<Register> call(std::string const& function, std::size_t position, Program& program);
    Result<Register> derivation_length(std::string const& function, Program& program);
    Result<Register> print_call(std::size_t position, Program& program);
    Result<Register> missing_call(MissingFunction const& function, std::size_t position,
                                  Program& program);
    Result<Register> table_id(std::vector<std::string> const& tables, Program& program);
    Result<std::string> quoted_text();

    Cursor& cursor_;
    Names& names_;
    NewNames new_names_;
    FrameBuilder frame_;
    std::map<std::string, Local, std::less<>> locals_;
    int depth_ = 0;
};

} // namespace tractus::lsystem
