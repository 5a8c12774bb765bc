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

// Names of variables, numbered in the order in which they are met. Built-in ones come first.
class NameTable {
public:
    static constexpr std::size_t kStep = 0;
    static constexpr std::size_t kFinalStep = 1;
    static constexpr std::size_t kAge = 2;
    static constexpr std::size_t kBlade = 3;     // How large outlines are from here on.
    static constexpr std::size_t kVariation = 4; // How far leaves differ: Leaf::Options.

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
    Ran,  // ran(x): 0 to x.
    Nran, // nran(mean, deviation): normally distributed.
};

struct FunctionName {
    std::string_view name;
    Function function;
    int arguments;
};
// Null if there is none of that name.
FunctionName const* find_function(std::string_view name);

// Steps of an expression: in which order its values are found and put together.
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
        Remainder, // Remainder of whole numbers.
        Power,
        Less,
        LessOrEqual,
        Greater,
        GreaterOrEqual,
        Equal,
        Unequal,
        And,
        Or,
        Skip,       // Goes `target` operations on.
        SkipIfZero, // Likewise, if the newest value, which is taken away, is 0.
    };
    Kind kind = Kind::Number;
    Function function = Function::Sin;
    double number = 0;
    std::size_t target = 0; // A name's number, or how far to skip.
};

// Compiled by the parser; angles are degrees, truth is 1 and 0.
class Expression {
public:
    std::vector<Operation> operations {};

    bool empty() const { return operations.empty(); }

    // `values` by the names' numbers; a value that is not a number stands for one that nobody has
    // given yet. The result may be infinite or no number: the caller decides what that means.
    double value(std::span<double const> values, Random& random) const;

private:
    double value_on(double* top, std::span<double const> values, Random& random) const;
};

} // namespace tractus::leaf
