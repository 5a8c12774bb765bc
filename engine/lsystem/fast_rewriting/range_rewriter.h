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

// Facts about a model's rules that rewriting needs, found out once.
class RulePlan {
public:
    // Plans one L-system of the model, which must outlive it.
    RulePlan(Model const& model, LSystem const& system);

    Model const& model() const { return model_; }
    LSystem const& system() const { return system_; }

    // How modules of a kind are rewritten.
    enum class Way : std::uint8_t {
        Copy,   // It stays as it is.
        Fixed,  // Always to the same successor.
        Batch,  // Does as Chance, and all its rules' programs can run for many modules at once.
        Chance, // Chance alone chooses among rules without contexts and conditions.
        Search, // Rules must be tried one after the other.
    };
    Way way(KindId kind) const { return ways_[kind]; }
    FixedSuccessor const& fixed(KindId kind) const { return fixed_[kind]; }

    // A kind without chance has one candidate.
    bool has_chance(KindId kind) const { return candidates_[kind].size() > 1; }
    // The number, in RuleSet::rules, of the rule that a random number of [0, 1) chooses.
    std::size_t choose(KindId kind, double number) const;
    BlockScan::Kinds const& scan_kinds() const { return scan_kinds_; }

    // Every kind's way is Copy or Fixed.
    bool is_fixed() const { return is_fixed_; }
    // Whether what modules of every kind become has one size, whatever chance and their parameters
    // are.
    bool has_known_sizes() const { return has_known_sizes_ && has_bounds_; }
    struct Size {
        std::size_t modules = 0;
        std::size_t parameters = 0;
    };
    Size size(KindId kind) const { return sizes_[kind]; }
    // A string may be cut into ranges that are rewritten by different rewriters, in any order: no
    // rule changes a global variable or prints, and none reads more modules than its predecessor.
    bool is_divisible() const { return is_divisible_; }
    // Whether what one module becomes is bounded: at most so many modules and parameters, where the
    // model has neither decomposition rules nor cuts.
    bool has_bounds() const { return has_bounds_; }
    // Whether some kind's way is Batch.
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
    Way find_way(KindId kind);
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

// Rewrites a range of a string, module after module, from the left. Each thread needs its own.
class RangeRewriter {
public:
    // All must outlive it; `branches` are of the string that will be rewritten, where rules have
    // contexts.
    RangeRewriter(RulePlan const& plan, VirtualMachine& machine, Branches const& branches);

    bool has_contexts() const { return rewriter_.has_contexts() || decomposition_.has_contexts(); }

    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::size_t parameter = 0; // Where the first module's parameters begin.
    };

    // A piece of work: what is rewritten, and where to.
    struct Task {
        ModuleString const& in;
        std::uint32_t step;
        StringLimit limit; // Limit of `out`.
        ModuleString& out;
    };

    // Appends what the modules of the range become. Stops early when `out` exceeds its limit or
    // the machine stops.
    void rewrite(Task const& task, Range const& range);

    // Writes what the modules of the range become, whose sizes are known, to where there is room
    // for exactly that. Stops early when the machine stops.
    void rewrite_to_place(ModuleString const& in, std::uint32_t step, Range const& range,
                          ModuleWriter to);

    // Appends the branches that %(x) has cut off in rewrite() since this was called last, each
    // behind a %(x,i), where i is its turtle's number.
    void rewrite_kept(Task const& task);

    // Appends what the module at `at` becomes, whose parameters begin at `parameter`; returns how
    // many modules have been read: more than one for long predecessors and cuts.
    std::size_t rewrite_module(Task const& task, std::size_t at, std::size_t parameter);

private:
    // Whether parameters may be written up to a wide move behind the last of a range.
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
    std::vector<RuleBatch> batches_; // One for each rule, where there are any.
    std::uint32_t step_ = 0;
    ModuleString const* in_ = nullptr; // Not owned.
    ModuleString* out_ = nullptr;      // Not owned.
    StringLimit limit_;
    ModuleString successor_; // Successor of one rule, before decomposition.
    struct Kept {
        Range range;
        std::size_t turtle = 0;
    };
    std::vector<Kept> kept_;
};

} // namespace tractus::lsystem
