#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/print_format.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// The names that a model defines, while it is compiled. Variables and arrays belong to one
// L-system, and all its blocks and rules share them; the rest belongs to the model.
struct Names {
    struct Array {
        std::string name;
        std::vector<std::size_t> sizes; // One per dimension.
    };

    std::vector<std::string> variables;
    std::vector<Array> arrays;
    std::vector<std::string> functions; // func(NAME, x) takes names as well as numbers.
    std::vector<std::string> curves;    // curveX(NAME, t) likewise.
    std::vector<PrintFormat> formats;
    std::vector<std::string> texts; // Strings as parameters of modules, such as @L("leaf").
    std::vector<std::string> warnings;
    std::set<std::string> warned_of;

    // Most variables, and most arrays: they have 16-bit numbers.
    static constexpr std::size_t kMax = 60'000;

    std::optional<std::uint16_t> find_variable(std::string_view name) const;
    // Returns its number. Fails, at the cursor's place, when there are too many.
    Result<std::uint16_t> add_variable(std::string name, Cursor const& cursor);
    void warn(std::string warning); // Once each.
    // Once for all warnings about the same thing: the first place is enough.
    void warn_of(std::string const& thing, std::string warning);
};

} // namespace tractus::lsystem
