#pragma once

#include "engine/base/vectors.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/virtual_machine.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lsystem {

// A reference implementation of the language, as short as possible. It has no tables, indices or
// parallel pieces, and rewrites one module after the other. The program's optimised implementation
// is compared with it. It executes compiled rules with the program's own machine, and supports
// neither sub-L-systems, nor queries, nor persistent cuts.

struct ReferenceModule {
    KindId kind = 0;
    std::vector<float> parameters {};
};
using ReferenceString = std::vector<ReferenceModule>;

class ReferenceRewriter {
public:
    ReferenceRewriter(Model const& model, std::uint64_t seed);

    // Derives a string from the axiom; no value if the string would exceed `most_modules`.
    std::optional<ReferenceString> derive(int steps, std::size_t most_modules);

    // Returns the string after applying the homomorphism rules, which must be deterministic.
    ReferenceString drawn(ReferenceString const& string);

private:
    enum class Looks { Right, Left };

    ReferenceString step(ReferenceString const& string, int number, std::size_t most_modules);
    std::size_t rewrite(ReferenceString const& string, std::size_t at, ReferenceString& out);
    void expand(RuleSet const& rules, ReferenceString const& string, std::size_t left,
                std::size_t right, ReferenceModule const& module, int depth, ReferenceString& out);
    Rule const* find(RuleSet const& rules, ReferenceString const& string, std::size_t left,
                     std::size_t right, ReferenceString const& predecessor);
    bool matches(Rule const& rule, ReferenceString const& string, std::size_t left,
                 std::size_t right, ReferenceString const& predecessor);
    bool matches_context(std::vector<KindId> const& context, Looks looks,
                         ReferenceString const& string, std::size_t from, double* values);
    std::optional<std::size_t> next(ReferenceString const& string, std::size_t from, Looks looks,
                                    bool names_bracket, int& rounds) const;
    ReferenceString successor(Rule const& rule);
    RegisterFile& frame(Rule const& rule);
    char symbol(KindId kind) const { return model_.alphabet[kind].symbol; }

    Model const& model_;
    VirtualMachine machine_;
    std::vector<std::pair<Rule const*, RegisterFile>> frames_;
};

std::string to_string(Model const& model, ReferenceString const& string);

struct ReferenceSegment {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double diameter = 0;
};

// Returns the segments that a string draws, in turtle units and in the order of the string. The
// symbols may be F, G, f, g, + - & ^ \ / | [ ] !(w) #(w) and @v. `angle_deg` and `width` are those
// of the view.
std::vector<ReferenceSegment> draw_reference(Model const& model, ReferenceString const& string,
                                             double angle_deg, double width);

} // namespace tractus::lsystem
