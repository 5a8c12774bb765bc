#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/cursor.h"
#include "engine/lsystem/program.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Names that all blocks and rules of a model share.
struct GlobalNames {
    std::vector<std::string> variables;
    struct Array {
        std::string name;
        std::vector<std::size_t> sizes; // One per dimension.
    };
    std::vector<Array> arrays;
    std::vector<std::string> functions; // func(NAME, x) takes names as well as numbers.
    std::vector<std::string> warnings;

    std::optional<std::uint16_t> find(std::string_view name) const;
    void warn(std::string warning); // Once each.
};

// Compiles cpfg's C-like expressions and statements into programs over one frame.
//
// Operators from weakest to strongest: ?: || && == != (or <>) < <= >= > + - * / % ^ - !, all binary
// ones from the left, so that -2^2 is 4 and 2^3^2 is 64.
class ExpressionCompiler {
public:
    // Where an assignment to a new name puts it: the model's blocks make globals, rules make
    // locals.
    enum class NewNames { Global, Local };

    ExpressionCompiler(Cursor& cursor, GlobalNames& globals, NewNames new_names)
        : cursor_(cursor)
        , globals_(globals)
        , new_names_(new_names)
    {
    }

    // A formal parameter of the rule; no value if the name is taken.
    std::optional<Register> add_parameter(std::string const& name);

    // Reads a block of statements in braces; its instructions go to `program`.
    Result<void> block(Program& program);

    // Reads an expression; the register that holds its value.
    Result<Register> expression(Program& program);

    // Puts in front of `program`, the first that a match runs, what sets to 0 the locals that it
    // could otherwise find with the value of the last match.
    void prepend_reset(Program& program) const;

    // The initial frame. The last thing to be called.
    RegisterFile take_frame();

    // Reads a name. No value where none stands.
    static std::optional<std::string> name(Cursor& cursor);

private:
    Result<void> statement(Program& program);
    Result<void> if_statement(Program& program);
    Result<void> while_statement(Program& program);
    Result<void> do_statement(Program& program);
    Result<void> statement_or_block(Program& program);
    Result<bool> assignment(Program& program);
    Result<void> assign_array(std::string const& array, Program& program);
    Result<void> assign(std::string const& variable, Register value, Program& program);
    Result<Register> conditional(Program& program);
    Result<Register> logical(Program& program, int level);
    Result<Register> binary(Program& program, int level);
    Result<Register> unary(Program& program);
    Result<Register> primary(Program& program);
    Result<Register> number();
    Result<Register> call(std::string const& function, std::size_t position, Program& program);
    Result<Register> ignored_call(std::string const& function, Program& program);
    Result<Register> function_id(Program& program);
    Result<Register> variable(std::string const& name, std::size_t position, Program& program);
    struct Element {
        std::uint16_t array = 0;
        Register index = 0;
    };
    Result<Element> array_element(std::string const& name, Program& program);
    Result<Register> emit(Op op, Register left, Register right, Program& program);
    Result<Register> new_register(double value);
    Result<Register> constant(double value);
    Result<Register> temporary();
    void release(Register reg);
    Result<std::uint16_t> label(Program const& program);

    struct Value {
        bool is_constant = false;
        bool is_temporary = false;
    };

    Cursor& cursor_;
    GlobalNames& globals_;
    NewNames new_names_;
    RegisterFile frame_;
    std::vector<Value> values_; // One per register.
    std::map<std::string, Register, std::less<>> names_;
    std::map<double, Register> constants_;
    std::vector<Register> free_temporaries_;
    std::vector<Register> reset_;
    int depth_ = 0;
    int conditional_depth_ = 0;
};

} // namespace tractus
