#pragma once

#include "engine/lsystem/fast_rewriting/range_rewriter.h"
#include "engine/lsystem/language/call_stack.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tractus::lsystem {

// Rewrites strings of models with sub-L-systems, from left to right: each module by the L-system
// that is at work at its place.
class SubsystemRewriter {
public:
    // All must outlive it; `main` runs the main L-system's programs, `branches` are of the string
    // that will be rewritten.
    SubsystemRewriter(Model const& model, VirtualMachine& main, Branches const& branches);

    bool has_contexts() const;

    // Appends what the string becomes; in the last step the End blocks of the sub-L-systems run,
    // too. Stops early when `out` exceeds its limit or the main machine stops, as it does with any
    // other. Fails, as the user's fault, for a ?(…) that names no sub-L-system, or one that is at
    // work already.
    Result<void> rewrite(RangeRewriter::Task const& task, bool is_last_step);

    // Gives `string` the variables of the ?(…) that stand in it from module `from` on.
    Result<void> add_calls(ModuleString& string, std::size_t from,
                           std::size_t from_parameter) const;

private:
    enum class Read { Rewritten, Cut };

    // Follows what modules call and end, once they have been read. What they become has its calls
    // from `first_new_call` on.
    Result<void> follow(std::span<KindId const> kinds, float const* parameters,
                        std::size_t first_new_call, Read read);
    void enter(std::size_t target, Read read);
    void leave();
    void run(Block const& block);

    // Modules from one on that the L-system at work leaves as they are, and that call and end
    // nothing; and how many parameters they have.
    struct Run {
        std::size_t modules = 0;
        std::size_t parameters = 0;
    };
    Run staying(std::size_t system, std::size_t at) const;

    // A call that passes its variables on to nothing.
    static constexpr std::size_t kGone = static_cast<std::size_t>(-1);

    Model const& model_;
    VirtualMachine& main_;
    CallStack stack_;
    std::vector<std::unique_ptr<RulePlan>> plans_;
    std::vector<std::unique_ptr<RangeRewriter>> rewriters_;
    std::vector<std::array<bool, 256>> stays_ {}; // Of each L-system, the kinds of such modules.
    std::array<std::uint8_t, 256> parameter_counts_ {}; // Of kinds.
    std::vector<std::size_t> targets_; // Where in out_->calls those at work go when they end.
    ModuleString const* in_ = nullptr; // Not owned.
    ModuleString* out_ = nullptr;      // Not owned.
    std::size_t next_call_ = 0;        // Next of in_->calls.
    bool is_last_step_ = false;
};

} // namespace tractus::lsystem
