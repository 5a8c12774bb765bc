#include "engine/lsystem/language/frame_builder.h"

#include "engine/lsystem/language/arithmetic.h"

#include <cmath>

namespace tractus::lsystem {

// Maximum number of registers in a frame and of instructions in a program: their indices have 16
// bits.
static constexpr std::size_t kMaxSize = 30000;

Result<Register> FrameBuilder::add(double value)
{
    if (frame_.size() >= kMaxSize)
        return cursor_.error("this rule is too large: it needs more than 30000 values");
    frame_.push_back(value);
    kinds_.push_back(Kind::Own);
    return static_cast<Register>(frame_.size() - 1);
}

Result<Register> FrameBuilder::constant(double value)
{
    if (auto const found = constants_.find(value); found != constants_.end())
        return found->second;
    auto const reg = TRY(add(value));
    kinds_[reg] = Kind::Constant;
    if (!std::isnan(value)) // NaN is not stored, because a map cannot find it again.
        constants_.emplace(value, reg);
    return reg;
}

Result<Register> FrameBuilder::temporary()
{
    if (!free_temporaries_.empty()) {
        auto const reg = free_temporaries_.back();
        free_temporaries_.pop_back();
        return reg;
    }
    auto const reg = TRY(add());
    kinds_[reg] = Kind::Temporary;
    return reg;
}

void FrameBuilder::release(Register reg)
{
    if (kinds_[reg] == Kind::Temporary)
        free_temporaries_.push_back(reg);
}

Result<std::uint16_t> FrameBuilder::label(Program const& program) const
{
    if (program.size() >= kMaxSize)
        return cursor_.error("this rule is too large: it needs more than 30000 instructions");
    return static_cast<std::uint16_t>(program.size());
}

Result<Register> FrameBuilder::emit(Op op, Register left, Register right, Program& program)
{
    if (is_pure(op) && is_constant(left) && is_constant(right))
        return constant(compute(op, frame_[left], frame_[right]));
    TRY(label(program));
    release(left);
    if (right != left)
        release(right);
    auto const target = TRY(temporary());
    program.push_back({ .op = op, .target = target, .left = left, .right = right });
    return target;
}

} // namespace tractus::lsystem
