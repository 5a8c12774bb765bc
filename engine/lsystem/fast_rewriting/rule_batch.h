#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/rewriting/fixed_successor.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tractus::lsystem {

// Modules that one rule rewrites, some at a time: each instruction of its program runs for all of
// them before the next one. The results are those of VirtualMachine, bit for bit.
class RuleBatch {
public:
    // Whether the rule's program is arithmetic from its first instruction to its last, so that it
    // does the same for every module, and nothing else.
    static bool is_possible(Rule const& rule);

    // Prepares a rule that a module has been found to match, with no contexts and no condition. The
    // rule must outlive it.
    explicit RuleBatch(Rule const& rule);

    // Writes what becomes of the module whose parameters are at `from`: its kinds at once, its
    // parameters by the end of finish(), until when both places must stay. `to` must have room for
    // FixedSuccessor::kShort kinds.
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
    // One register, of all modules.
    using Lanes = std::array<double, kSize>;

    void execute(Instruction const& instruction);

    Rule const& rule_;
    FixedSuccessor successor_; // Only its kinds are used.
    std::size_t count_ = 0;
    std::array<float const*, kSize> from_ {}; // Not owned.
    std::array<float*, kSize> to_ {};         // Not owned.
    std::vector<Lanes> registers_;
    std::vector<std::array<float, kSize>> parameters_; // Parameters of the successor.
};

} // namespace tractus::lsystem
