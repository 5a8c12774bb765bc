#include "engine/methods/leaves/leaf_expression.h"

#include "engine/base/vectors.h"

#include <algorithm>
#include <cmath>

namespace tractus::leaf {

namespace {

constexpr std::array kFunctions {
    FunctionName { "sin", Function::Sin, 1 },   FunctionName { "cos", Function::Cos, 1 },
    FunctionName { "tan", Function::Tan, 1 },   FunctionName { "asin", Function::Asin, 1 },
    FunctionName { "acos", Function::Acos, 1 }, FunctionName { "atan", Function::Atan, 1 },
    FunctionName { "sqrt", Function::Sqrt, 1 }, FunctionName { "floor", Function::Floor, 1 },
    FunctionName { "ceil", Function::Ceil, 1 }, FunctionName { "min", Function::Min, 2 },
    FunctionName { "max", Function::Max, 2 },   FunctionName { "pow", Function::Pow, 2 },
    FunctionName { "fabs", Function::Fabs, 1 }, FunctionName { "exp", Function::Exp, 1 },
    FunctionName { "log", Function::Log, 1 },   FunctionName { "ran", Function::Ran, 1 },
    FunctionName { "nran", Function::Nran, 2 },
};

double call(Function function, double a, double b, Random& random)
{
    switch (function) {
    case Function::Sin:
        return std::sin(radians(a));
    case Function::Cos:
        return std::cos(radians(a));
    case Function::Tan:
        return std::tan(radians(a));
    case Function::Asin:
        return std::asin(a) / radians(1);
    case Function::Acos:
        return std::acos(a) / radians(1);
    case Function::Atan:
        return std::atan(a) / radians(1);
    case Function::Sqrt:
        return std::sqrt(a);
    case Function::Floor:
        return std::floor(a);
    case Function::Ceil:
        return std::ceil(a);
    case Function::Min:
        return std::min(a, b);
    case Function::Max:
        return std::max(a, b);
    case Function::Pow:
        return std::pow(a, b);
    case Function::Fabs:
        return std::abs(a);
    case Function::Exp:
        return std::exp(a);
    case Function::Log:
        return std::log(a);
    case Function::Ran:
        return a * random.uniform();
    case Function::Nran:
        return a + b * random.normal();
    }
    return 0;
}

double combined(Operation::Kind kind, double a, double b)
{
    switch (kind) {
    case Operation::Kind::Add:
        return a + b;
    case Operation::Kind::Subtract:
        return a - b;
    case Operation::Kind::Multiply:
        return a * b;
    case Operation::Kind::Divide:
        return a / b;
    case Operation::Kind::Remainder:
        return std::fmod(std::trunc(a), std::trunc(b));
    case Operation::Kind::Power:
        return std::pow(a, b);
    case Operation::Kind::Less:
        return a < b;
    case Operation::Kind::LessOrEqual:
        return a <= b;
    case Operation::Kind::Greater:
        return a > b;
    case Operation::Kind::GreaterOrEqual:
        return a >= b;
    case Operation::Kind::Equal:
        return a == b;
    case Operation::Kind::Unequal:
        return a != b;
    case Operation::Kind::And:
        return a != 0 && b != 0;
    case Operation::Kind::Or:
        return a != 0 || b != 0;
    default:
        return 0;
    }
}

bool takes_two(Operation const& operation)
{
    if (operation.kind != Operation::Kind::Call)
        return operation.kind >= Operation::Kind::Add && operation.kind <= Operation::Kind::Or;
    return std::ranges::find(kFunctions, operation.function, &FunctionName::function)->arguments
        == 2;
}

} // namespace

std::size_t NameTable::number_of(std::string_view name)
{
    auto const found = std::ranges::find(names_, name);
    if (found != names_.end())
        return static_cast<std::size_t>(found - names_.begin());
    names_.emplace_back(name);
    return names_.size() - 1;
}

FunctionName const* find_function(std::string_view name)
{
    auto const* const found = std::ranges::find(kFunctions, name, &FunctionName::name);
    return found == kFunctions.end() ? nullptr : found;
}

double Expression::value(std::span<double const> values, Random& random) const
{
    // Size, in values, of the stack for expressions of at most as many operations, which need no
    // more.
    constexpr std::size_t kUsual = 64;
    if (operations.size() <= kUsual) {
        std::array<double, kUsual> stack;
        return evaluate_on_stack(stack.data(), values, random);
    }
    std::vector<double> stack(operations.size());
    return evaluate_on_stack(stack.data(), values, random);
}

double Expression::evaluate_on_stack(double* top, std::span<double const> values,
                                     Random& random) const
{
    using Kind = Operation::Kind;
    for (std::size_t i = 0; i < operations.size(); ++i) {
        auto const& operation = operations[i];
        if (operation.kind == Kind::Number) {
            *top++ = operation.number;
        } else if (operation.kind == Kind::Name) {
            *top++ = values[operation.target];
        } else if (operation.kind == Kind::Skip) {
            i += operation.target;
        } else if (operation.kind == Kind::SkipIfZero) {
            i += *--top == 0 ? operation.target : 0;
        } else {
            double const b = takes_two(operation) ? *--top : 0;
            double& a = top[-1];
            if (operation.kind == Kind::Call)
                a = call(operation.function, a, b, random);
            else if (operation.kind == Kind::Negate)
                a = -a;
            else if (operation.kind == Kind::Not)
                a = a == 0;
            else
                a = combined(operation.kind, a, b);
        }
    }
    return top[-1];
}

} // namespace tractus::leaf
