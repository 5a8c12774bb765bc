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

// Pointer to a field of an edit, of any type that edits use. A new type of field needs an
// alternative here and support in each visitor.
using FieldRef
    = std::variant<bool*, int*, std::uint64_t*, double*, std::string*, Vec3*, std::optional<int>*,
                   std::optional<double>*, std::vector<std::uint32_t>*, std::vector<std::uint64_t>*,
                   variation::Selection*, std::vector<PathAddress>*, std::vector<TipRange>*,
                   std::map<std::string, std::string>*>;

// Visitor of the fields of an edit, in order. Each kind of edit has one function that passes its
// fields to a visitor. Visitors write the fields as JSON, read them back, search for strokes or
// fill in random values.
class Fields {
public:
    virtual ~Fields() = default;

    // Visits a field. `name` identifies the field in sessions and must never change.
    virtual void field(char const* name, FieldRef value) = 0;

    // Visits a field that visitors leave out of a session if it is 0 or empty.
    virtual void sparse_field(char const* name, FieldRef value) { field(name, value); }

    // Visits the id of the first item that the edit makes; the id is 0 if not assigned yet.
    virtual void id(std::uint64_t& id) { sparse_field("id", &id); }

    // Visits a choice from a list of words. `value` is the index of the chosen word.
    virtual void word(char const* name, int& value, std::span<char const* const> words) = 0;

    // Visits the edit's bulk data, which has no name; an edit has at most one such field.
    virtual void numbers(Stroke& stroke) = 0;
    virtual void numbers(std::vector<SkeletonPiece>& lines) = 0;
    virtual void bytes(std::string& file) = 0; // Visits the contents of a file of another program.

    // Visits an enumeration, which is written as one of `words`; these are in the order of the
    // enumeration's values.
    template<typename Enum, std::size_t N>
    void word(char const* name, Enum& value, std::array<char const*, N> const& words)
    {
        int number = static_cast<int>(value);
        word(name, number, std::span<char const* const>(words));
        value = static_cast<Enum>(number);
    }
};

} // namespace tractus::scene
