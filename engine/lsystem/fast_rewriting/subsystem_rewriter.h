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

// Rewrites strings of models with sub-L-systems, from left to right. Each module is rewritten by
// the L-system that is active at its place.
class SubsystemRewriter {
public:
    // The arguments must outlive this object. `main` runs the programs of the main L-system.
    // `branches` are the matching brackets of the string to be rewritten.
    SubsystemRewriter(Model const& model, VirtualMachine& main, Branches const& branches);

    bool has_contexts() const;

    // Appends the rewritten string. In the last step, the End blocks of the sub-L-systems run, too.
    // Stops early if `out` exceeds its limit or any machine stops. Fails with a user error for a
    // ?(...) whose sub-L-system does not exist or is already active.
    Result<void> rewrite(RangeRewriter::Task const& task, bool is_last_step);

    // Adds calls, with their initial variables, for the ?(...) modules of `string` from index
    // `from` on. `from_parameter` is the index of the first parameter there.
    Result<void> add_calls(ModuleString& string, std::size_t from,
                           std::size_t from_parameter) const;

private:
    enum class Read { Rewritten, Cut };

    // Follows the calls and returns among modules that have been read. The calls of these modules'
    // successors begin at index `first_new_call`.
    Result<void> follow(std::span<KindId const> kinds, float const* parameters,
                        std::size_t first_new_call, Read read);
    void enter(std::size_t target, Read read);
    void leave();
    void run(Block const& block);

    // A run of modules that the active L-system leaves unchanged and that contain no calls or
    // returns. `parameters` is the total number of their parameters.
    struct Run {
        std::size_t modules = 0;
        std::size_t parameters = 0;
    };
    Run staying(std::size_t system, std::size_t at) const;

    // Target of a call that was removed: its variables are discarded.
    static constexpr std::size_t kGone = static_cast<std::size_t>(-1);

    Model const& model_;
    VirtualMachine& main_;
    CallStack stack_;
    std::vector<std::unique_ptr<RulePlan>> plans_;
    std::vector<std::unique_ptr<RangeRewriter>> rewriters_;
    // For each L-system, whether modules of each kind stay unchanged.
    std::vector<std::array<bool, 256>> stays_ {};
    std::array<std::uint8_t, 256> parameter_counts_ {}; // Number of parameters of each kind.
    // For each active sub-L-system, the index in out_->calls of the call that receives its
    // variables when it ends; or kGone.
    std::vector<std::size_t> targets_;
    ModuleString const* in_ = nullptr; // Not owned.
    ModuleString* out_ = nullptr;      // Not owned.
    std::size_t next_call_ = 0;        // Index of the next call in in_->calls.
    bool is_last_step_ = false;
};

} // namespace tractus::lsystem
