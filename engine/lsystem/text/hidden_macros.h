#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Sets of macros by number, each kept once: those that a token came from, which do not replace it
// again ("hide sets" in Prosser's algorithm). No value: there would be too many sets, or too many
// macros in one, as hostile models make them.
class HiddenMacros {
public:
    using Id = std::uint32_t; // Names a set.
    static constexpr Id kEmpty = 0;
    static constexpr std::size_t kMaxNesting = 200; // Macros in a set.

    bool has(Id set, std::uint32_t macro) const;

    std::optional<Id> in_both(Id a, Id b);
    std::optional<Id> in_any(Id a, Id b);
    std::optional<Id> with(Id set, std::uint32_t macro);

private:
    using Set = std::vector<std::uint32_t>; // Sorted.

    std::optional<Id> id(Set set);

    std::vector<Set> sets_ { {} };
    std::map<Set, Id> ids_ { { {}, kEmpty } };
};

} // namespace tractus::lsystem
