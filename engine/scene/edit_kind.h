#pragma once

#include "engine/base/result.h"
#include "engine/scene/fields.h"

#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::scene {

struct DocumentState;
class SceneBuilder;

// All that the program knows of a kind of edit: a row of the table of kinds. Sessions, their log
// and their repair, undo, export and tests work by it and know no kind by name.
struct EditKind {
    char const* word;                // In sessions: "associate". Never changes.
    bool loads_plant;                // It brings a source for a plant.
    std::shared_ptr<void> (*make)(); // An edit as it is by default.
    std::shared_ptr<void> (*copy)(void const* edit);
    void (*fields)(Fields& visitor, void* edit);
    // See apply_edit().
    Result<DocumentState> (*apply)(DocumentState state, void const* edit, SceneBuilder& builder);
    // What it does, for people: "selects 1 path, 3 segments".
    std::string (*describe)(void const* edit);
};

// A struct whose edits have a kind: its static member kKind.
template<typename T>
concept EditFields = requires
{
    {
        T::kKind
        } -> std::convertible_to<EditKind const&>;
};

// Something that the user did, of any kind. A value: copies share its fields, which nobody changes.
class Edit {
public:
    template<EditFields T>
    Edit(T edit) // NOLINT(google-explicit-constructor): is one.
        : kind_(&T::kKind)
        , fields_(std::make_shared<T const>(std::move(edit)))
    {
    }

    // `fields` point to the type that belongs to the kind.
    Edit(EditKind const& kind, std::shared_ptr<void const> fields)
        : kind_(&kind)
        , fields_(std::move(fields))
    {
    }

    EditKind const& kind() const { return *kind_; }
    std::string describe() const { return kind_->describe(fields_.get()); }

    // Null for an edit of another type.
    template<EditFields T> T const* get() const
    {
        return kind_ == &T::kKind ? static_cast<T const*>(fields_.get()) : nullptr;
    }

    // Lets the visitor look at the fields, which it leaves as they are.
    void show(Fields& visitor) const;

    // The same edit after the visitor has changed its fields.
    Edit changed_by(Fields& visitor) const;

private:
    friend Result<DocumentState> apply_edit(DocumentState state, Edit const& edit,
                                            SceneBuilder& builder);

    EditKind const* kind_;
    std::shared_ptr<void const> fields_; // Shared between copies.
};

// The kinds of edits that a program knows. No two have the same word.
using EditKinds = std::span<EditKind const* const>;

// Null if there is none.
EditKind const* find_edit_kind(EditKinds kinds, std::string_view word);

} // namespace tractus::scene
