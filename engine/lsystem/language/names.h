#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/module_uses.h"
#include "engine/lsystem/language/print_format.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Names that are defined in a model, while it is compiled. Variables and arrays belong to one
// L-system and are shared by its blocks and rules; everything else belongs to the whole model.
struct Names {
    struct Array {
        std::string name;
        std::vector<std::size_t> sizes; // Size of each dimension.
    };

    std::vector<std::string> variables;
    std::vector<Array> arrays;
    // Names of the functions that func(NAME, x) can call; func() also accepts a number.
    std::vector<std::string> functions;
    // Names of the curves that curveX(NAME, t) can read; curveX() also accepts a number.
    std::vector<std::string> curves;
    std::vector<PrintFormat> formats;
    std::vector<std::string> texts; // Strings that are parameters of modules, as in @L("leaf").
    ModuleUses uses;
    std::vector<std::string> warnings;
    std::set<std::string> warned_of;
    std::vector<std::string> undefined; // Warnings of names that have no definition.

    // Maximum number of variables, and of arrays: their indices have 16 bits.
    static constexpr std::size_t kMax = 60'000;

    std::optional<std::uint16_t> find_variable(std::string_view name) const;
    // Adds a variable and returns its index. Fails at the cursor's position if there are too many.
    Result<std::uint16_t> add_variable(std::string name, Cursor const& cursor);
    void warn(std::string warning); // Adds a warning unless it has been added.
    // Adds a warning unless there is one about the same thing already: one place is enough.
    void warn_of(std::string const& thing, std::string warning);
    // Adds a warning that a name, read at `place`, has no definition. Later places of the name are
    // not added.
    void warn_undefined(std::string const& name, std::string const& place);
    // Returns warnings of the first three undefined names, and the number of further ones.
    std::vector<std::string> undefined_warnings() const;
};

} // namespace tractus::lsystem
