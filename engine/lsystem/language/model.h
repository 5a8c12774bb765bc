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

// The two text files of a model, in the syntax of cpfg (Prusinkiewicz, Hanan, Mech, "An
// L-system-based plant modeling language", AGTIVE 1999): rules (.l) and view (.v). The view may be
// empty. The names of the files are used in error messages.
struct ModelSource {
    std::string name = "model.l";
    std::string text {};
    std::string view_name = "model.v";
    std::string view_text {};

    bool operator==(ModelSource const&) const = default;
};

// A kind of module: a symbol, which is a single character, and its number of parameters. cpfg's
// symbols @o, ~l and ?P are two modules each, the first of them without parameters.
struct ModuleKind {
    char symbol = ' ';
    std::uint8_t parameter_count = 0;

    bool operator==(ModuleKind const&) const = default;
};

// Index into Alphabet::kinds: the one byte that a string stores per module.
using KindId = std::uint8_t;

// The kinds of modules that occur in a model, at most kMaxKinds.
struct Alphabet {
    static constexpr std::size_t kMaxKinds = 255;

    std::vector<ModuleKind> kinds;

    ModuleKind const& operator[](KindId id) const { return kinds[id]; }
};

// Finds the id of a kind of module; no value if the kind does not occur in the model.
std::optional<KindId> find_kind(Alphabet const& alphabet, ModuleKind const& kind);

// A string of modules with new parameters, such as a successor. Kinds are copied; parameters are
// read from registers, in order.
struct SuccessorTemplate {
    std::vector<KindId> kinds;
    std::vector<Register> parameters;
};

// A rule: left < predecessor > right : {before} condition {after} --> successor : probability.
struct Rule {
    std::vector<KindId> left;        // Left context, from the predecessor outwards.
    std::vector<KindId> predecessor; // Strict predecessor: at least one module.
    std::vector<KindId> right;
    // Number of parameters of the predecessor, the right context and the left context together.
    // Their registers are the first of the frame, in this order.
    std::size_t parameter_count = 0;
    std::size_t predecessor_parameter_count = 0;

    // Runs the block `before` and puts the value of the condition into register condition_result.
    Program condition;
    Register condition_result = 0;
    bool has_condition = false;
    Program successor_program; // Runs the block `after` and computes the successor's parameters.
    SuccessorTemplate successor;
    Program probability; // Puts the probability into register probability_result.
    Register probability_result = 0;
    bool has_probability = false;

    RegisterFile frame;
    // True if a match may read local variables that the rule's previous match has set.
    bool keeps_locals = false;
    std::uint32_t line = 0; // Line of the arrow, for error messages.
};

// A set of rules, in the order in which they are tried.
struct RuleSet {
    bool specified = false;
    int max_depth = 1;
    std::vector<Rule> rules;
    // Indices of the rules whose predecessor begins with a kind, for each kind.
    std::array<std::vector<std::uint16_t>, 256> by_kind;
};

struct Block {
    Program program;
    RegisterFile frame;
};

struct ArrayVariable {
    std::string name;
    std::vector<double> values; // Initial values of the array's elements.
};

// An external name of a sub-L-system. It refers to the variable or array of that name in the caller
// or, if that has none, in the caller's caller, and so on.
struct ExternalName {
    bool is_array = false;
    // Index into the globals or arrays of the sub-L-system that declares the name.
    std::uint16_t index = 0;
};

// Predefined global variables of every L-system; the variables that the model defines follow them.
enum class GlobalIndex : std::uint16_t {
    Step,             // Q: the current derivation step.
    Steps,            // Z: the derivation length when the derivation starts.
    DerivationLength, // The current derivation length, which SetDerivationLength() changes.
    Count,
};

// One L-system of a model: the text between "Lsystem: ID" and "endlsystem".
struct LSystem {
    int id = 1;
    Block axiom_program;
    SuccessorTemplate axiom;
    bool stochastic = false;
    std::uint64_t seed = 0; // Seed given in the model; 0: none is given.
    bool ring = false;
    // Kinds that contexts ignore. As in cpfg, right contexts can also ignore brackets: the modules
    // of a branch then count as part of its parent axis.
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

// A compiled model, which any number of derivations may share. The first L-system of the file is
// the main one; the others are its sub-L-systems.
//
// A module ?(id) or ?(id,scale) calls the sub-L-system with this id, which rewrites the following
// modules up to and including the matching $. The module ?(...) itself is rewritten by the caller.
// Each ?(...) in a string has its own variables and arrays. The sub-L-system's Start block runs
// when the ?(...) is first rewritten, StartEach and EndEach in each step, and End in the last step
// or when the ?(...) disappears. The variables of a ?(...) pass to the first ?(...) with the same
// id in its successor. The axiom and the derivation length of a sub-L-system are ignored. `scale`
// multiplies the turtle's scale up to the $.
struct Model : LSystem {
    std::string name;
    Alphabet alphabet; // Kinds of modules in all L-systems.
    int steps = 0;     // Derivation length that the model gives.
    std::vector<LSystem> subsystems;
    std::vector<PrintFormat> formats; // Format strings of printf.
    View view;
    // Warnings about unsupported features and undefined names, each once.
    std::vector<std::string> warnings;
};

// Version of the language. It increases when the meaning of some model changes, so that programs
// that store models instead of plants can detect the change. In version 1, local variables of rules
// did not keep their values, right contexts treated ignored brackets differently from cpfg, and
// cylinders had no colour per point.
constexpr int kLanguageVersion = 2;

// Compiles a model. Fails with the user error "FILE:LINE:COLUMN: found ..., expected ...".
//
// A name that is assigned in a block of statements is a global variable. A name that is assigned
// only in a rule is a local variable of that rule: it starts as 0 and, as in cpfg, keeps its value
// from one match of the rule to the next.
Result<Model> compile_model(ModelSource const& source, IncludeReader const& include = {});

} // namespace tractus::lsystem
