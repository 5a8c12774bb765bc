#pragma once

#include "engine/plant/branch_address.h"
#include "engine/plant/skeleton_lines.h"
#include "engine/stroke/erase_tips.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/select_branches.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tractus::scene {

// A field of any type that edits have. Another type of field is another alternative here, and a way
// to write it in each visitor.
using FieldRef
    = std::variant<bool*, int*, std::uint64_t*, double*, std::string*, Vec3*, std::optional<int>*,
                   std::optional<double>*, std::vector<std::uint32_t>*, std::vector<std::uint64_t>*,
                   variation::Selection*, std::vector<PathAddress>*, std::vector<TipRange>*,
                   std::map<std::string, std::string>*>;

// Visits the fields of a value in their order. What an edit consists of is said once, in a function
// that hands its fields to a visitor; visitors write them as JSON, read them back, look for strokes
// or give them random values.
class Fields {
public:
    virtual ~Fields() = default;

    // `name` identifies the field in sessions: it never changes.
    virtual void field(char const* name, FieldRef value) = 0;

    // A field that is not written where it is 0 or empty.
    virtual void sparse_field(char const* name, FieldRef value) { field(name, value); }

    // The id of the first item that the edit makes; 0 as long as it has none.
    virtual void id(std::uint64_t& id) { sparse_field("id", &id); }

    // A choice among words; the value is the word's number.
    virtual void word(char const* name, int& value, std::span<char const* const> words) = 0;

    // Bulk, of which a value has at most one: it has no name.
    virtual void numbers(Stroke& stroke) = 0;
    virtual void numbers(std::vector<SkeletonPiece>& lines) = 0;
    virtual void bytes(std::string& file) = 0; // The whole of a foreign file.

    // An enumeration as words in the order of its values.
    template<typename Enum, std::size_t N>
    void word(char const* name, Enum& value, std::array<char const*, N> const& words)
    {
        int number = static_cast<int>(value);
        word(name, number, std::span<char const* const>(words));
        value = static_cast<Enum>(number);
    }
};

} // namespace tractus::scene
