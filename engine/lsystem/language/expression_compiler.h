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

// Compiles cpfg's C-like expressions into programs over one frame.
//
// Operators from weakest to strongest: ?: || && == != (or <>) < <= >= > + - * / % ^ - !, all binary
// ones from the left, so that -2^2 is 4 and 2^3^2 is 64.
class ExpressionCompiler {
public:
    // Where an assignment to a new name puts it: the blocks of an L-system make globals, rules make
    // locals.
    enum class NewNames { Global, Local };

    ExpressionCompiler(Cursor& cursor, Names& names, NewNames new_names)
        : cursor_(cursor)
        , names_(names)
        , new_names_(new_names)
        , frame_(cursor)
    {
    }

    // A formal parameter of the rule; no value if the name is taken.
    std::optional<Register> add_parameter(std::string const& name);

    // Reads an expression; the register that holds its value.
    Result<Register> expression(Program& program);
    // Reads one in parentheses, a number, a name or a call.
    Result<Register> primary(Program& program);

    // Reads a string as a parameter of a module: the number of the string in the model.
    Result<Register> text();

    // An element of an array, whose name has been read.
    struct Element {
        std::uint16_t array = 0;
        Register index = 0;
    };
    Result<Element> element(std::string const& array, Program& program);

    Result<void> assign(std::string const& variable, Register value, Program& program);

    // A local variable of a rule.
    struct Local {
        Register value = 0;
        bool is_parameter = false;
        bool is_assigned = false;
        std::optional<std::size_t> first_read {}; // Place of the first reading in the text.
    };
    std::map<std::string, Local, std::less<>> const& locals() const { return locals_; }

    Cursor& cursor() { return cursor_; }
    FrameBuilder& frame() { return frame_; }

    // Reads a name. No value where none stands.
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
