#pragma once

#include "engine/base/random.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::leaf {

// Names of variables, numbered in the order in which they appear in the text, after the built-in
// ones.
class NameTable {
public:
    static constexpr std::size_t kStep = 0;
    static constexpr std::size_t kFinalStep = 1;
    static constexpr std::size_t kAge = 2;
    // Index of the name `blade`: the scale of the blades that begin while it has this value.
    static constexpr std::size_t kBlade = 3;
    // Index of the name `variation`: the scale of variation between leaves (Leaf::Options).
    static constexpr std::size_t kVariation = 4;

    std::size_t number_of(std::string_view name);
    std::string const& name(std::size_t number) const { return names_[number]; }
    std::size_t count() const { return names_.size(); }

private:
    std::vector<std::string> names_ { "step", "finalstep", "age", "blade", "variation" };
};

enum class Function : std::uint8_t {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sqrt,
    Floor,
    Ceil,
    Min,
    Max,
    Pow,
    Fabs,
    Exp,
    Log,
    Ran,  // The function ran(x): uniform, 0 to x.
    Nran, // The function nran(mean, deviation): normally distributed.
};

struct FunctionName {
    std::string_view name;
    Function function;
    int arguments;
};
// Finds a function by name; null if there is none.
FunctionName const* find_function(std::string_view name);

// An instruction of a compiled expression (stack machine).
struct Operation {
    enum class Kind : std::uint8_t {
        Number,
        Name,
        Call,
        Negate,
        Not,
        Add,
        Subtract,
        Multiply,
        Divide,
        Remainder, // Remainder of a division of integers.
        Power,
        Less,
        LessOrEqual,
        Greater,
        GreaterOrEqual,
        Equal,
        Unequal,
        And,
        Or,
        Skip,       // Skips `target` instructions.
        SkipIfZero, // Pops a value and skips `target` instructions if it is 0.
    };
    Kind kind = Kind::Number;
    Function function = Function::Sin;
    double number = 0;
    std::size_t target = 0; // For a Name its index; for a skip the number of instructions to skip.
};

// An expression compiled by the parser. Angles are in degrees; true is 1 and false is 0.
class Expression {
public:
    std::vector<Operation> operations {};

    bool empty() const { return operations.empty(); }

    // Evaluates the expression. `values` is indexed by the number of a name (NameTable); NaN marks
    // a name without a value. The result can be infinite or NaN; the caller must check it.
    double value(std::span<double const> values, Random& random) const;

private:
    double evaluate_on_stack(double* top, std::span<double const> values, Random& random) const;
};

} // namespace tractus::leaf
