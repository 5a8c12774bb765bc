#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/placed_text.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// The macros that #define makes, with and without parameters. Errors are the user's, with their
// place.
class MacroTable {
public:
    // `files` are the names of the files that places are in; they must outlive the table.
    explicit MacroTable(std::vector<std::string> const& files)
        : files_(files)
    {
    }

    // What stands behind #define in `line`.
    Result<void> define(PlacedText const& line, std::string_view rest);
    void undefine(std::string_view name);
    bool is_defined(std::string_view name) const { return macros_.find(name) != macros_.end(); }
    // What a macro without parameters stands for; the name itself for others.
    std::string_view body(std::string_view name) const;

    // Appends the text with its macros replaced. A macro within what it stands for is left alone,
    // as in C.
    Result<void> expand(PlacedText const& text, PlacedText& out) const;

private:
    struct Macro {
        bool has_parameters = false;
        std::vector<std::string> parameters;
        std::string body;
    };
    using Active = std::vector<std::string>; // Macros that are being replaced.

    Result<void> expand(PlacedText const& text, PlacedText& out, Active& active) const;
    Result<void> expand_body(std::string const& name, PlacedText const& body, PlacedText& out,
                             Active& active) const;
    Result<std::size_t> expand_call(Macro const& macro, std::string const& name,
                                    PlacedText const& text, std::size_t open, PlacedText& out,
                                    Active& active) const;
    Result<std::size_t> find_arguments(PlacedText const& text, std::size_t open,
                                       std::string const& name,
                                       std::vector<PlacedText>& arguments) const;
    tl::unexpected<Error> error(PlacedText const& text, std::size_t index,
                                std::string const& what) const
    {
        return error_in(text, index, files_, what);
    }

    std::vector<std::string> const& files_;
    std::map<std::string, Macro, std::less<>> macros_;
};

} // namespace tractus
