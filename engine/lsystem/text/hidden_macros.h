#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Numbered sets of macros, each stored once: the "hide sets" of Prosser's algorithm. The set of a
// token contains the macros that the token came from, which must not replace it again. Operations
// return no value if there are too many sets, or too many macros in a set, as in hostile models.
class HiddenMacros {
public:
    using Id = std::uint32_t; // Number of a set.
    static constexpr Id kEmpty = 0;
    static constexpr std::size_t kMaxNesting = 200; // Maximum number of macros in a set.

    bool has(Id set, std::uint32_t macro) const;

    std::optional<Id> in_both(Id a, Id b);
    std::optional<Id> in_any(Id a, Id b);
    std::optional<Id> with(Id set, std::uint32_t macro);

private:
    using Set = std::vector<std::uint32_t>; // Macros of a set, sorted by number.

    std::optional<Id> id(Set set);

    std::vector<Set> sets_ { {} };
    std::map<Set, Id> ids_ { { {}, kEmpty } };
};

} // namespace tractus::lsystem
