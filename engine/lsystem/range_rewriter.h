#pragma once

#include "engine/lsystem/expander.h"
#include "engine/lsystem/fixed_successor.h"
#include "engine/lsystem/machine.h"
#include "engine/lsystem/model.h"
#include "engine/lsystem/module_string.h"
#include "engine/lsystem/rewriter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus {

// What rewriting needs to know of a model's rules, found out once.
class RulePlan {
public:
    // For one L-system of the model, which must outlive it.
    RulePlan(Model const& model, LSystem const& system);

    Model const& model() const { return model_; }
    LSystem const& system() const { return system_; }

    // How modules of a kind are rewritten.
    enum class Way : std::uint8_t {
        Fixed,  // Always to the same successor.
        Chance, // Chance alone chooses among rules without contexts and conditions.
        Search, // Rules must be tried one after the other.
    };
    Way way(KindId kind) const { return ways_[kind]; }
    FixedSuccessor const& fixed(KindId kind) const { return fixed_[kind]; }

    struct Candidate {
        Rule const* rule = nullptr;
        double weight = 0;
    };
    std::vector<Candidate> const& candidates(KindId kind) const { return candidates_[kind]; }
    double total_weight(KindId kind) const { return total_weights_[kind]; }

    // Every kind's way is Fixed.
    bool is_fixed() const { return is_fixed_; }
    // What modules of every kind become has one size, whatever chance and their parameters are.
    bool has_known_sizes() const { return has_known_sizes_ && has_bounds_; }
    struct Size {
        std::size_t modules = 0;
        std::size_t parameters = 0;
    };
    Size size(KindId kind) const { return sizes_[kind]; }
    // A string may be cut into ranges that are rewritten by different rewriters, in any order: no
    // rule changes a global variable or prints, and none reads more modules than its predecessor.
    bool is_divisible() const { return is_divisible_; }
    // What one module becomes has at most so many modules and parameters, where the model has
    // neither decomposition rules nor cuts.
    bool has_bounds() const { return has_bounds_; }
    std::size_t longest() const { return longest_; }
    std::size_t most_parameters() const { return most_parameters_; }

private:
    Way find_way(KindId kind);
    bool find_chances(KindId kind);
    bool find_size(KindId kind);

    Model const& model_;
    LSystem const& system_;
    std::array<Way, 256> ways_ {};
    std::array<FixedSuccessor, 256> fixed_ {};
    std::array<std::vector<Candidate>, 256> candidates_;
    std::array<double, 256> total_weights_ {};
    std::array<Size, 256> sizes_ {};
    bool is_fixed_ = true;
    bool has_known_sizes_ = true;
    bool is_divisible_ = true;
    bool has_bounds_ = true;
    std::size_t longest_ = 1;
    std::size_t most_parameters_ = 0;
};

// Rewrites a range of a string, module after module, from the left. Each thread needs its own.
class RangeRewriter {
public:
    // All must outlive it; `branches` are of the string that will be rewritten, where rules have
    // contexts.
    RangeRewriter(RulePlan const& plan, Machine& machine, Branches const& branches);

    bool has_contexts() const { return rewriter_.has_contexts() || decomposition_.has_contexts(); }

    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::size_t parameter = 0; // Where the first module's parameters begin.
    };

    // What is rewritten, and where to.
    struct Task {
        ModuleString const& in;
        std::uint32_t step;
        StringLimit limit; // Of `out`.
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
    void rewrite_bounded(Range const& range, std::uint32_t step);
    void rewrite_any(Range const& range, std::uint32_t step);
    std::size_t write_bounded(Range const& range, std::uint32_t step, ModuleWriter& to);
    void rewrite_one_bounded(Modules const& rest, Surroundings const& around, std::uint32_t step,
                             ModuleWriter& to);
    Rule const& choose(KindId kind);
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
    Machine& machine_;
    Branches const& branches_;
    Rewriter rewriter_;
    Expander decomposition_;
    ModuleString const* in_ = nullptr; // Not owned.
    ModuleString* out_ = nullptr;      // Not owned.
    StringLimit limit_;
    ModuleString successor_; // Of one rule, before decomposition.
    struct Kept {
        Range range;
        std::size_t turtle = 0;
    };
    std::vector<Kept> kept_;
};

} // namespace tractus
