#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/rewriting/fixed_successor.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tractus::lsystem {

// Applies one rule to several modules at once: each instruction runs for all modules before the
// next instruction. Results are bit-identical to those of VirtualMachine.
class RuleBatch {
public:
    // Returns true if the rule's program consists of arithmetic only, so that the same instructions
    // run for every module.
    static bool is_possible(Rule const& rule);

    // Prepares a rule that has no contexts and conditions and that must outlive the batch.
    explicit RuleBatch(Rule const& rule);

    // Adds a module whose parameters are at `from`. The kinds of its successor are written to `to`
    // immediately, the parameters no later than in finish(). Both memory places must stay valid
    // until then. `to` must have room for FixedSuccessor::kShort kinds.
    void add(float const* from, ModuleWriter& to)
    {
        if (count_ == kSize)
            finish();
        from_[count_] = from;
        to_[count_++] = to.parameters;
        successor_.write_kinds(to.kinds);
        to.parameters += successor_.parameter_count;
    }
    void finish();

private:
    static constexpr std::size_t kSize = 16;
    // The values of one register for all modules of a batch.
    using Lanes = std::array<double, kSize>;

    void execute(Instruction const& instruction);

    Rule const& rule_;
    FixedSuccessor successor_; // Successor of the rule; only its kinds are used.
    std::size_t count_ = 0;
    std::array<float const*, kSize> from_ {}; // Not owned.
    std::array<float*, kSize> to_ {};         // Not owned.
    std::vector<Lanes> registers_;
    // Parameters of the successors, each for all modules of a batch.
    std::vector<std::array<float, kSize>> parameters_;
};

} // namespace tractus::lsystem
