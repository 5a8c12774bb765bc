#include "engine/lsystem/fast_rewriting/rule_batch.h"

#include "engine/lsystem/language/arithmetic.h"

#include <algorithm>

namespace tractus::lsystem {

bool RuleBatch::is_possible(Rule const& rule)
{
    return std::all_of(rule.successor_program.begin(), rule.successor_program.end(),
                       [](Instruction const& instruction) { return is_pure(instruction.op); });
}

RuleBatch::RuleBatch(Rule const& rule)
    : rule_(rule)
    , successor_(FixedSuccessor::of(rule))
    , registers_(rule.frame.size())
    , parameters_(rule.successor.parameters.size())
{
    for (std::size_t i = 0; i < registers_.size(); ++i)
        registers_[i].fill(rule.frame[i]);
}

void RuleBatch::finish()
{
    if (count_ == 0)
        return;
    for (std::size_t k = 0; k < rule_.predecessor_parameter_count; ++k)
        for (std::size_t i = 0; i < count_; ++i)
            registers_[k][i] = static_cast<double>(from_[i][k]);
    for (auto const& instruction : rule_.successor_program)
        execute(instruction);
    auto const count = parameters_.size();
    for (std::size_t k = 0; k < count; ++k) {
        auto const& lanes = registers_[rule_.successor.parameters[k]];
        for (std::size_t i = 0; i < kSize; ++i)
            parameters_[k][i] = static_cast<float>(lanes[i]);
    }
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t k = 0; k < count; ++k)
            to_[i][k] = parameters_[k][i];
    count_ = 0;
}

// Executes the operations that are most frequent in rules as vector operations.
void RuleBatch::execute(Instruction const& instruction)
{
    Lanes const left = registers_[instruction.left];
    Lanes const right = registers_[instruction.right];
    auto& target = registers_[instruction.target];
    switch (instruction.op) {
    case Op::Copy:
        target = left;
        break;
    case Op::Add:
        for (std::size_t i = 0; i < kSize; ++i)
            target[i] = left[i] + right[i];
        break;
    case Op::Subtract:
        for (std::size_t i = 0; i < kSize; ++i)
            target[i] = left[i] - right[i];
        break;
    case Op::Multiply:
        for (std::size_t i = 0; i < kSize; ++i)
            target[i] = left[i] * right[i];
        break;
    default:
        for (std::size_t i = 0; i < count_; ++i)
            target[i] = compute(instruction.op, left[i], right[i]);
    }
}

} // namespace tractus::lsystem
