#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/print_format.h"
#include "engine/lsystem/language/program.h"
#include "engine/lsystem/text/source_text.h"
#include "engine/lsystem/view/view.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lsystem {

// The two small text files that make a model, in the syntax of cpfg (Prusinkiewicz, Hanan, Mech,
// "An L-system-based plant modeling language", AGTIVE 1999): rules (.l) and view (.v). The view may
// be empty. The names stand in error messages.
struct ModelSource {
    std::string name = "model.l";
    std::string text {};
    std::string view_name = "model.v";
    std::string view_text {};

    bool operator==(ModelSource const&) const = default;
};

// A symbol with a number of parameters: what a module of a string is, but for its values. cpfg's
// symbols are single characters; @o, ~l and ?P are two modules each, the first without parameters.
struct ModuleKind {
    char symbol = ' ';
    std::uint8_t parameter_count = 0;

    bool operator==(ModuleKind const&) const = default;
};

// Index into Alphabet::kinds: how strings store a module, in one byte.
using KindId = std::uint8_t;

// All kinds of modules that a model names.
struct Alphabet {
    static constexpr std::size_t kMaxKinds = 255;

    std::vector<ModuleKind> kinds;

    ModuleKind const& operator[](KindId id) const { return kinds[id]; }
};

// No value for a kind that the model does not name.
std::optional<KindId> find_kind(Alphabet const& alphabet, ModuleKind const& kind);

// A string of modules to be written with new parameters: its kinds are copied as they are, its
// parameters come from the registers, in order.
struct SuccessorTemplate {
    std::vector<KindId> kinds;
    std::vector<Register> parameters;
};

// left < predecessor > right : {before} condition {after} --> successor : probability
struct Rule {
    std::vector<KindId> left;        // Nearest to the predecessor first.
    std::vector<KindId> predecessor; // At least one.
    std::vector<KindId> right;
    std::size_t parameter_count = 0; // The predecessor's, right's and left's, in this order.
    std::size_t predecessor_parameter_count = 0;

    Program condition; // before, and the condition's value into condition_result.
    Register condition_result = 0;
    bool has_condition = false;
    Program successor_program; // after, and the successor's parameters.
    SuccessorTemplate successor;
    Program probability; // Its value into probability_result.
    Register probability_result = 0;
    bool has_probability = false;

    RegisterFile frame;
    bool keeps_locals = false; // It may find its local variables as its last match left them.
    std::uint32_t line = 0;    // Line of the arrow, for messages.
};

// Rules in the order in which they are tried.
struct RuleSet {
    bool specified = false;
    int max_depth = 1;
    std::vector<Rule> rules;
    std::array<std::vector<std::uint16_t>, 256> by_kind; // Rules by their predecessor's first kind.
};

struct Block {
    Program program;
    RegisterFile frame;
};

struct ArrayVariable {
    std::string name;
    std::vector<double> values; // Values at the start.
};

// A name of a sub-L-system's that stands for a variable, or an array, of the L-system that has
// called it, or of the one that has called that, and so on.
struct ExternalName {
    bool is_array = false;
    std::uint16_t index = 0; // Into the globals or arrays of the one that has declared it.
};

// The variables that every L-system has; the first that it defines itself follows them.
enum class GlobalIndex : std::uint16_t {
    Step,             // Q: the step that is being derived.
    Steps,            // Z: the derivation length at the start.
    DerivationLength, // SetDerivationLength() changes it.
    Count,
};

// One L-system of a model: what stands between "Lsystem: ID" and "endlsystem".
struct LSystem {
    int id = 1;
    Block axiom_program;
    SuccessorTemplate axiom;
    bool stochastic = false;
    std::uint64_t seed = 0; // The model's own; 0 when it has none.
    bool ring = false;
    // Indexed by kind: contexts look past these. Right contexts look past brackets as well, as in
    // cpfg: where they are ignored, branches are no different from what bears them.
    std::array<bool, 256> ignored {};

    Block start;
    Block start_each;
    Block end_each;
    Block end;
    RuleSet rules;
    RuleSet decomposition;
    RuleSet homomorphism;

    std::vector<std::string> globals { "Q", "Z", "derivation length" };
    std::vector<ArrayVariable> arrays;
    std::vector<ExternalName> externals;
};

// A compiled model: a value that any number of derivations may share. Its main L-system is the
// first of the file; the others are its sub-L-systems.
//
// A module ?(id) or ?(id,scale) calls the sub-L-system with this id: it rewrites what follows, up
// to and with the $ that matches. The ?(…) itself is rewritten by the one that calls. Each ?(…) in
// a string has variables and arrays of its own. Its Start block runs when it is first rewritten,
// StartEach and EndEach in each step, End in the last step or when the ?(…) goes. It passes these
// variables on to the first ?(…) with the same id among its successors. A sub-L-system's axiom and
// derivation length mean nothing. Scale is the turtle's, up to the $.
struct Model : LSystem {
    std::string name;
    Alphabet alphabet; // Kinds of all L-systems.
    int steps = 0;     // derivation length.
    std::vector<LSystem> subsystems;
    std::vector<PrintFormat> formats; // Formats of printf.
    View view;
    std::vector<std::string> warnings; // Features we lack, names never defined: once each.
};

// What models mean, as a number that grows when the meaning of some model changes, so that those
// who keep models and not plants can say so. 1: until rules' local variables kept their values,
// right contexts saw brackets that are ignored as cpfg does, and cylinders had a colour for each
// point.
constexpr int kLanguageVersion = 2;

// Compiles a model. Fails, as the user's fault, with "FILE:LINE:COLUMN: what was found, what was
// expected".
//
// A name that is assigned in a block of statements of the model is a global variable; one that only
// a rule assigns is local to the rule, starts as 0 and, as in cpfg, keeps its value from one match
// of the rule to the next.
Result<Model> compile_model(ModelSource const& source, IncludeReader const& include = {});

} // namespace tractus::lsystem
