#pragma once

#include "engine/lsystem/fast_rewriting/block_scan.h"
#include "engine/lsystem/fast_rewriting/rule_batch.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/language/virtual_machine.h"
#include "engine/lsystem/rewriting/expander.h"
#include "engine/lsystem/rewriting/fixed_successor.h"
#include "engine/lsystem/rewriting/rewriter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Properties of a model's rules that rewriting needs; computed once for a model.
class RulePlan {
public:
    // Makes a plan for one L-system of the model. Both must outlive the plan.
    RulePlan(Model const& model, LSystem const& system);

    Model const& model() const { return model_; }
    LSystem const& system() const { return system_; }

    // How modules of a kind are rewritten.
    enum class Way : std::uint8_t {
        Copy,  // The module stays as it is.
        Fixed, // The module always has the same successor.
        // Like Chance; in addition, the program of each rule can run for many modules at once.
        Batch,
        Chance, // Chance alone chooses among the rules, which have no contexts or conditions.
        Search, // The rules must be tried one after another.
    };
    Way way(KindId kind) const { return ways_[kind]; }
    FixedSuccessor const& fixed(KindId kind) const { return fixed_[kind]; }

    // True if chance chooses among several rules for the kind; otherwise one rule is used.
    bool has_chance(KindId kind) const { return candidates_[kind].size() > 1; }
    // Returns the index in RuleSet::rules of the rule that a random number in [0, 1) selects for
    // the kind.
    std::size_t choose(KindId kind, double number) const;
    BlockScan::Kinds const& scan_kinds() const { return scan_kinds_; }

    // True if every kind is rewritten as Copy or Fixed.
    bool is_fixed() const { return is_fixed_; }
    // True if all successors of a kind have the same size, whatever chance and parameters are, for
    // every kind.
    bool has_known_sizes() const { return has_known_sizes_ && has_bounds_; }
    struct Size {
        std::size_t modules = 0;
        std::size_t parameters = 0;
    };
    Size size(KindId kind) const { return sizes_[kind]; }
    // True if a string may be divided into ranges that different rewriters process in any order: no
    // rule has side effects, keeps local variables or replaces several modules at once, and nothing
    // is cut off.
    bool is_divisible() const { return is_divisible_; }
    // True if longest() and most_parameters() bound the size of every module's successor. This
    // requires that the model has no decomposition rules, no cuts and no predecessors of several
    // modules.
    bool has_bounds() const { return has_bounds_; }
    // True if some kind is rewritten as Batch.
    bool has_batches() const { return has_batches_; }
    std::size_t longest() const { return longest_; }
    std::size_t most_parameters() const { return most_parameters_; }

private:
    struct Candidate {
        std::size_t rule = 0;
        double weight = 0;
    };

    Rule const& rule(Candidate const& candidate) const
    {
        return system_.rules.rules[candidate.rule];
    }
    Way find_rewrite_mode(KindId kind);
    bool find_chances(KindId kind);
    bool find_size(KindId kind);
    void find_batches();

    Model const& model_;
    LSystem const& system_;
    std::array<Way, 256> ways_ {};
    std::array<FixedSuccessor, 256> fixed_ {};
    std::array<std::vector<Candidate>, 256> candidates_;
    std::array<double, 256> total_weights_ {};
    std::array<Size, 256> sizes_ {};
    BlockScan::Kinds scan_kinds_ {};
    bool is_fixed_ = true;
    bool has_known_sizes_ = true;
    bool is_divisible_ = true;
    bool has_bounds_ = true;
    bool has_batches_ = false;
    std::size_t longest_ = 1;
    std::size_t most_parameters_ = 0;
};

// Rewrites a range of a string, module by module, from the left. Each thread needs its own
// rewriter.
class RangeRewriter {
public:
    // The arguments must outlive this object. `branches` are the matching brackets of the string to
    // be rewritten; they are only needed if rules have contexts.
    RangeRewriter(RulePlan const& plan, VirtualMachine& machine, Branches const& branches);

    bool has_contexts() const { return rewriter_.has_contexts() || decomposition_.has_contexts(); }

    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::size_t parameter = 0; // Index of the first parameter of the range's first module.
    };

    // Input and output of the rewriting of a string in one step.
    struct Task {
        ModuleString const& in;
        std::uint32_t step;
        StringLimit limit; // Size limit of `out`.
        ModuleString& out;
    };

    // Appends the successors of the range's modules. Stops early if `out` exceeds its limit or the
    // machine stops.
    void rewrite(Task const& task, Range const& range);

    // Writes the successors of the range's modules, whose sizes must be known, to memory of exactly
    // the required size. Stops early if the machine stops.
    void rewrite_to_place(ModuleString const& in, std::uint32_t step, Range const& range,
                          ModuleWriter to);

    // Appends the branches that a %(x) has cut off in rewrite() since the last call. Each follows a
    // module %(x,i), where i is the number of the branch's turtle state.
    void rewrite_kept(Task const& task);

    // Appends the successor of the module with index `at`, whose first parameter has index
    // `parameter`. Returns the number of modules read: more than one for a long predecessor or a
    // cut.
    std::size_t rewrite_module(Task const& task, std::size_t at, std::size_t parameter);

private:
    // Room in the output after the range. With ForWideRuns, a wide move may write parameters past
    // the range's end.
    enum class Room : std::uint8_t { Tight, ForWideRuns };

    void rewrite_bounded(Range const& range);
    void rewrite_any(Range const& range);
    std::size_t write_block(Range const& range, Room room, ModuleWriter& to);
    std::size_t write_blocks(Range const& range, Room room, ModuleWriter& to);
    void rewrite_one_bounded(std::size_t at, std::size_t parameter, ModuleWriter& to);
    std::size_t rewrite_one(Modules const& rest, Surroundings const& around);
    void decompose_successor(Surroundings const& around, std::size_t predecessor_length);
    void append_one(Modules const& modules);
    void keep(Range const& range);
    void begin(Task const& task);
    bool is_over() const
    {
        return out_->size() > limit_.modules || out_->byte_size() > limit_.bytes
            || machine_.has_stopped();
    }

    RulePlan const& plan_;
    Model const& model_;
    LSystem const& system_;
    VirtualMachine& machine_;
    Branches const& branches_;
    Rewriter rewriter_;
    Expander decomposition_;
    BlockScan scan_;
    // One batch for each rule; empty if no kind is rewritten as Batch.
    std::vector<RuleBatch> batches_;
    std::uint32_t step_ = 0;
    ModuleString const* in_ = nullptr; // Not owned.
    ModuleString* out_ = nullptr;      // Not owned.
    StringLimit limit_;
    // Successor of one rule before decomposition; also a buffer for the end of a range.
    ModuleString successor_;
    struct Kept {
        Range range;
        std::size_t turtle = 0;
    };
    std::vector<Kept> kept_;
};

} // namespace tractus::lsystem
