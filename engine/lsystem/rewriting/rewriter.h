#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/language/virtual_machine.h"
#include "engine/lsystem/rewriting/fixed_successor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Consecutive modules, from some position to the end of their string.
struct Modules {
    KindId const* kinds = nullptr;
    float const* parameters = nullptr;
    std::size_t count = 0;
};

// Matching brackets of a string, by which contexts skip whole branches at once.
struct Branches {
    // For each bracket, the index of the matching bracket; the string's size if there is none.
    std::vector<std::uint32_t> partner;
    // For each module, the index of its first parameter; empty for strings without parameters.
    std::vector<std::uint32_t> parameters;
};

// Returns the index of the bracket that closes the branch of module `from`, or of the $ that ends
// its sub-L-system, whichever comes first. Returns the string's size if there is neither.
std::size_t branch_end(Model const& model, ModuleString const& string, std::size_t from);

// Returns the end of the part that a cut before module `from` removes. This is the end of the
// branch or, as in cpfg, the next %(x) or %(x,i) of the branch.
std::size_t cut_end(Model const& model, ModuleString const& string, std::size_t from);

// Fills `branches` for a string of fewer than 2^32 modules and parameters.
void find_branches(Model const& model, ModuleString const& string, Branches& branches);

// Where the contexts of a module are matched: the left context leftwards from before module `left`,
// the right context rightwards from module `right`. The other two members are the indices of the
// first parameters of these modules.
struct Surroundings {
    ModuleString const* string = nullptr;
    // Matching brackets of the string; may be null if Rewriter::has_contexts() is false.
    Branches const* branches = nullptr;
    std::size_t left = 0;
    std::size_t left_parameters = 0;
    std::size_t right = 0;
    std::size_t right_parameters = 0;
};

// Finds and applies the rules of one set. Owns the frames in which the rules' programs run.
class Rewriter {
public:
    // Makes a rewriter for a set of rules of one L-system of the model.
    Rewriter(Model const& model, LSystem const& system, RuleSet const& rules,
             VirtualMachine& machine);

    // Finds the rule that rewrites the first of `modules`; nullptr if there is none. If `adjacent`
    // is true, the right context begins directly after the predecessor in the string, otherwise at
    // `around.right`. The rule's frame then holds the parameters and the results of the rule's
    // condition.
    Rule const* find(Modules const& modules, Surroundings const& around, bool adjacent);

    // Fills the rule's frame with the predecessor's parameters. Replaces find() for a rule that has
    // no contexts and is known to apply.
    void load_predecessor(Rule const& rule, float const* parameters);

    // Runs the block after the rule's condition and appends the successor. A ModuleWriter must have
    // room for the successor and for at least FixedSuccessor::kShort kinds.
    void apply(Rule const& rule, ModuleString& out);
    void apply(Rule const& rule, ModuleWriter& to);

    bool has_rules(KindId kind) const { return !rules_.by_kind[kind].empty(); }
    bool has_contexts() const { return has_contexts_; }

private:
    // Index of a module and of its first parameter.
    struct Place {
        std::size_t module = 0;
        std::size_t parameters = 0;
    };
    // The module that contexts see next to the predecessor, searched for once for all rules.
    // `place` has no value if there is none.
    struct Neighbour {
        bool is_known = false;
        std::size_t from = 0;
        std::optional<Place> place;
    };
    enum class Bracket : std::uint8_t {
        None,
        Open,
        Close,
        Keep // A %(...): the branch after it is, or will be, a separate one.
    };
    enum class OpeningBrackets { PassBranches, Stop };

    bool matches(std::uint16_t rule, Modules const& modules, Surroundings const& around,
                 bool adjacent);
    bool matches_right(Rule const& rule, double* parameters, Surroundings const& around);
    bool matches_left(Rule const& rule, double* parameters, Surroundings const& around);
    std::optional<Place> next_right(Place at, int& rounds, Surroundings const& around,
                                    OpeningBrackets brackets) const;
    std::optional<Place> next_left(Place at, int& rounds, Surroundings const& around) const;
    Place after(Place at, ModuleString const& string) const
    {
        return { at.module + 1, at.parameters + parameter_counts_[string.kinds[at.module]] };
    }
    void load(KindId kind, float const* from, double*& to) const
    {
        for (auto left = parameter_counts_[kind]; left > 0; --left)
            *to++ = static_cast<double>(*from++);
    }
    Rule const* choose(Modules const& modules, Surroundings const& around, bool adjacent);
    std::size_t index(Rule const& rule) const
    {
        return static_cast<std::size_t>(&rule - rules_.rules.data());
    }

    Model const& model_;
    LSystem const& system_;
    RuleSet const& rules_;
    VirtualMachine& machine_;
    std::vector<RegisterFile> frames_;
    std::vector<FixedSuccessor> successors_; // Successors of the rules; only their kinds are used.
    struct Candidate {
        Rule const* rule = nullptr;
        double weight = 0;
    };
    std::vector<Candidate> candidates_;
    bool has_contexts_ = false;
    std::array<Bracket, 256> brackets_ {};
    std::array<std::uint8_t, 256> parameter_counts_ {};
    Neighbour right_; // Right neighbour of the modules for which find() tries rules.
    Neighbour left_;
};

} // namespace tractus::lsystem
