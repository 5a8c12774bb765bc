#include "engine/lsystem/language/arithmetic.h"

#include "engine/base/check.h"
#include "engine/base/vectors.h"

#include <cmath>

namespace tractus::lsystem {

// The remainder of C's % for integers, with all special cases defined: 0 for a zero divisor and for
// values that are not numbers.
static double remainder(double left, double right)
{
    double const dividend = std::trunc(left);
    double const divisor = std::trunc(right);
    if (divisor == 0 || !std::isfinite(dividend) || std::isnan(divisor))
        return 0;
    return std::fmod(dividend, divisor);
}

bool is_pure(Op op)
{
    return op >= Op::Copy && op <= Op::Sqrt;
}

// Evaluates a function of one number, or of the two coordinates of a point.
static double call_function(Op op, double left, double right)
{
    switch (op) {
    case Op::Sin:
        return std::sin(radians(left));
    case Op::Cos:
        return std::cos(radians(left));
    case Op::Tan:
        return std::tan(radians(left));
    case Op::Asin:
        return degrees(std::asin(left));
    case Op::Acos:
        return degrees(std::acos(left));
    case Op::Atan:
        return degrees(std::atan(left));
    case Op::Atan2:
        return degrees(std::atan2(right, left));
    case Op::Exp:
        return std::exp(left);
    case Op::Log:
        return std::log(left);
    case Op::Floor:
        return std::floor(left);
    case Op::Ceil:
        return std::ceil(left);
    case Op::Round:
        return std::floor(left + 0.5);
    case Op::Abs:
        return std::fabs(left);
    case Op::Sign:
        return (left > 0) - (left < 0);
    case Op::Sqrt:
        return std::sqrt(left);
    default:
        CHECK(false);
        return 0;
    }
}

double compute(Op op, double left, double right)
{
    switch (op) {
    case Op::Copy:
        return left;
    case Op::Add:
        return left + right;
    case Op::Subtract:
        return left - right;
    case Op::Multiply:
        return left * right;
    case Op::Divide:
        return right == 0 ? left : left / right;
    case Op::Remainder:
        return remainder(left, right);
    case Op::Power:
        return std::pow(left, right);
    case Op::Less:
        return left < right;
    case Op::LessEqual:
        return left <= right;
    case Op::Greater:
        return left > right;
    case Op::GreaterEqual:
        return left >= right;
    case Op::Equal:
        return left == right;
    case Op::NotEqual:
        return left != right;
    case Op::Negate:
        return -left;
    case Op::Not:
        return left == 0;
    case Op::IsTrue:
        return left != 0;
    default:
        return call_function(op, left, right);
    }
}

} // namespace tractus::lsystem
