#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/text/hidden_macros.h"
#include "engine/lsystem/text/placed_text.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// The table of macros that #define defines, with and without parameters, and their replacement as
// in C11 6.10.3: `#` and `##`, macros in arguments, and rescanning together with the following
// text. __LINE__ and __FILE__ give their own position or, inside a macro call, the position at
// which the outermost call begins. A `#` without a parameter after it stands for itself, because it
// is a turtle symbol. As in gcc, the variable arguments may have a name, and a comma before ##
// __VA_ARGS__ is removed if the call has no variable arguments. Errors are user errors that give
// the position.
class MacroTable {
public:
    // `files` contains the names of the files, for positions in errors; it must outlive the table.
    explicit MacroTable(std::vector<std::string> const& files)
        : files_(files)
    {
    }

    // Defines a macro from `rest`, the part of `line` after #define.
    Result<void> define(PlacedText const& line, std::string_view rest);
    void undefine(std::string_view name);
    bool is_defined(std::string_view name) const
    {
        return macros_.find(name) != macros_.end() || is_place_macro(name);
    }

    // Appends a text to `out`, with its macros replaced.
    Result<void> expand(PlacedText const& text, PlacedText& out);

    // Like expand(), if the text is complete. If it ends inside a macro call, or after a name whose
    // parentheses may follow, the following text is needed: returns false and appends nothing.
    Result<bool> expand_whole(PlacedText const& text, PlacedText& out);

private:
    // A preprocessing token, or a single blank.
    struct Token {
        std::string characters;
        SourcePlace place; // Position of the token's first character.
        // True if the token comes from a macro's body. All its characters then have the position of
        // the macro call.
        bool is_in_body = false;
        bool is_paste = false; // True for the operator ## in a macro's body.
        // Macros that the token came from, which must not replace it again.
        HiddenMacros::Id hidden = HiddenMacros::kEmpty;
    };
    using Tokens = std::vector<Token>;

    struct Macro {
        std::uint32_t number = 0;
        bool has_parameters = false;
        bool is_variadic = false; // True if the last parameter takes the remaining arguments.
        std::vector<std::string> parameters;
        Tokens body;
    };
    struct Call {
        std::vector<Tokens> arguments;
        std::vector<Tokens> expanded; // Arguments after macro replacement; filled on demand.
        std::vector<bool> is_expanded;
        SourcePlace place;
        int depth = 0; // Nesting depth of calls in arguments of calls.
        // True if the call has no comma before its variable arguments.
        bool leaves_out_rest = false;
    };

    static bool is_place_macro(std::string_view name)
    {
        return name == "__LINE__" || name == "__FILE__";
    }
    static Tokens tokens_of(PlacedText const& text);
    static std::size_t parameter_index(Macro const& macro, Token const& token);
    Result<void> set_body(Macro& macro, PlacedText const& line, std::string_view text);
    Result<std::string_view> set_parameters(Macro& macro, PlacedText const& line,
                                            std::string_view rest);
    bool ends_in_call(PlacedText const& text) const;
    Macro const* macro_for(Token const& token) const;
    bool expand_place_macro(Token& token) const;

    template<typename Sink> Result<void> expand(Tokens& rest, int depth, Sink const& sink);
    Result<bool> take_call(Macro const& macro, Token const& name, Tokens& rest, Call& call,
                           HiddenMacros::Id& hidden);
    Result<void> check_arguments(Macro const& macro, Token const& name, Call& call) const;
    Result<Tokens> substitute(Macro const& macro, Call& call);
    Result<void> substitute_token(Macro const& macro, Call& call, std::size_t at, Tokens& result);
    Result<void> expand_argument(Call& call, std::size_t index);
    static std::string quoted(Tokens const& argument);
    static bool takes_comma(Macro const& macro, Call const& call, std::size_t at, Tokens& result);
    static void paste(Tokens& result, Tokens const& next);

    Result<HiddenMacros::Id> known_set(std::optional<HiddenMacros::Id> set,
                                       SourcePlace const& place) const;
    Result<void> spend(std::size_t size, SourcePlace const& place);

    tl::unexpected<Error> error(PlacedText const& text, std::size_t index,
                                std::string const& what) const
    {
        return error_in(text, index, files_, what);
    }
    tl::unexpected<Error> error(SourcePlace const& place, std::string const& what) const;

    std::vector<std::string> const& files_;
    std::map<std::string, Macro, std::less<>> macros_;
    std::uint32_t next_number_ = 0;
    HiddenMacros hidden_;
    std::size_t spent_ = 0;
    // True if a text that was expanded ended inside a macro call, or before the call's parenthesis.
    bool ended_in_call_ = false;
};

} // namespace tractus::lsystem
