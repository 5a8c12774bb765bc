#pragma once

#include "engine/lsystem/text/source_text.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// The letters that a model's axioms and rules use, collected while these are parsed, to warn of
// letters that have no effect. Most such letters come from another notation: the ' and $ of "The
// Algorithmic Beauty of Plants" (ABoP), or names of several letters, which cpfg's language reads
// letter by letter. Positions are indices into the preprocessed text.
class ModuleUses {
public:
    // Begins an axiom or a successor.
    void begin_string();
    // Adds the next module of the axiom or successor.
    void add(char symbol, std::size_t position, bool has_parameters);
    void end_string();

    // Adds a letter that needs no effect of its own. Some rule replaces it or has it as its
    // context, a list of ignored or considered letters names it, or it is the whole successor of a
    // rule: a module in a state of rest.
    void add_known(char symbol) { known_[index(symbol)] = true; }
    // Notes that a rule has a context. From then on any letter may have an effect, as it separates
    // the modules beside it.
    void add_context() { has_contexts_ = true; }
    // Adds a strict predecessor of `module_count` modules; `written` is the model's text from
    // `position` on.
    void add_predecessor(std::string_view written, std::size_t module_count, std::size_t position);

    // Returns warnings, with positions, of names and letters without effect: first the names of
    // several letters, then the single letters in the order of the text. Of each of the two lists
    // at most kMaxListed are returned; a count of the others follows.
    std::vector<std::string> warnings(SourceText const& source) const;

    static constexpr std::size_t kMaxListed = 4;

private:
    struct Use {
        char symbol = 0;
        std::size_t position = 0;
        bool has_parameters = false;
    };
    struct Name {
        std::string letters;
        std::size_t position = 0;
        bool is_predecessor = false;
    };

    static std::size_t index(char symbol) { return static_cast<unsigned char>(symbol); }
    bool belongs_to_symbol_before(char symbol, bool has_parameters);
    void add_run(std::size_t begin, std::size_t end);
    void add_name(std::string letters, std::size_t position, bool is_predecessor);
    bool is_known(char symbol) const;
    bool is_whole_known(Name const& name) const;
    char free_letter(std::string_view name) const;
    std::string describe_name(Name const& name) const;

    // Symbols of the axiom or successor being parsed. Those of several characters, such as ~K, are
    // left out.
    std::vector<Use> string_;
    // The first characters, @, @D, ~ or ?, of a symbol that the next module continues.
    std::string prefix_;
    bool has_contexts_ = false;
    bool calls_systems_ = false; // True if a ?(...) calls a sub-L-system; a $ then ends the call.
    std::array<bool, 256> known_ {};
    std::array<bool, 256> used_ {};
    // Position of the first use of each letter.
    std::array<std::optional<std::size_t>, 256> first_ {};
    std::vector<Name> names_;
};

} // namespace tractus::lsystem
