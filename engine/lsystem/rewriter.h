#pragma once

#include "engine/lsystem/machine.h"
#include "engine/lsystem/model.h"
#include "engine/lsystem/module_string.h"

#include <cstddef>
#include <vector>

namespace tractus {

// Modules from some place on to the end of their string.
struct Modules {
    KindId const* kinds = nullptr;
    float const* parameters = nullptr;
    std::size_t count = 0;
};

// Where contexts are looked for: in `string`, leftwards from before module `left` and rightwards
// from module `right`, whose parameters begin at the given places.
struct Surroundings {
    ModuleString const* string = nullptr;
    std::size_t left = 0;
    std::size_t left_parameters = 0;
    std::size_t right = 0;
    std::size_t right_parameters = 0;
};

// Finds and applies the rules of one set. Holds the frames in which their programs run.
class Rewriter {
public:
    Rewriter(Model const& model, RuleSet const& rules, Machine& machine, bool stochastic);

    // The rule that rewrites the first of `modules`, nullptr if none does. With `adjacent` the
    // right context begins behind the predecessor in the string; otherwise at `around.right`.
    // Parameters, and what the condition's block has changed, are in the rule's frame.
    Rule const* find(Modules const& modules, Surroundings const& around, bool adjacent);

    // Runs the block behind the condition and appends the successor.
    void apply(Rule const& rule, ModuleString& out);

    bool has_rules(KindId kind) const { return !rules_.by_kind[kind].empty(); }

private:
    bool matches(Rule const& rule, double* frame, Modules const& modules,
                 Surroundings const& around, bool adjacent);
    bool matches_right(Rule const& rule, double* parameters, Surroundings const& around) const;
    bool matches_left(Rule const& rule, double* parameters, Surroundings const& around) const;
    void load(KindId kind, float const* from, double*& to) const;
    Rule const* choose(Modules const& modules, Surroundings const& around, bool adjacent);
    double* frame(Rule const& rule)
    {
        return frames_[static_cast<std::size_t>(&rule - rules_.rules.data())].data();
    }

    Model const& model_;
    RuleSet const& rules_;
    Machine& machine_;
    bool stochastic_;
    std::vector<RegisterFile> frames_;
    struct Candidate {
        Rule const* rule = nullptr;
        double weight = 0;
    };
    std::vector<Candidate> candidates_;
};

} // namespace tractus
