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

// Everything the program knows about one kind of edit: a row in the table of kinds. Sessions, the
// session log and its repair, undo, export and tests use only this table and name no kind of edit.
struct EditKind {
    char const* word;                // Name in sessions, such as "associate". Must never change.
    bool loads_plant;                // True if the edit sets the source of a plant.
    std::shared_ptr<void> (*make)(); // Makes an edit with default values.
    std::shared_ptr<void> (*copy)(void const* edit);
    void (*fields)(Fields& visitor, void* edit);
    // Returns the state after the edit, or an error. Called by apply_edit().
    Result<DocumentState> (*apply)(DocumentState state, void const* edit, SceneBuilder& builder);
    // Returns a description for the user, such as "selects 1 path, 3 segments".
    std::string (*describe)(void const* edit);
};

// Satisfied by structs that are a kind of edit: they have a static member kKind.
template<typename T>
concept EditFields = requires
{
    {
        T::kKind
        } -> std::convertible_to<EditKind const&>;
};

// An edit of any kind. A value: copies share the edit's immutable fields.
class Edit {
public:
    template<EditFields T>
    Edit(T edit) // NOLINT(google-explicit-constructor): conversion is intended.
        : kind_(&T::kKind)
        , fields_(std::make_shared<T const>(std::move(edit)))
    {
    }

    // `fields` must point to the struct that belongs to the kind.
    Edit(EditKind const& kind, std::shared_ptr<void const> fields)
        : kind_(&kind)
        , fields_(std::move(fields))
    {
    }

    EditKind const& kind() const { return *kind_; }
    std::string describe() const { return kind_->describe(fields_.get()); }

    // Returns the edit's fields, or null if the edit is of another kind.
    template<EditFields T> T const* get() const
    {
        return kind_ == &T::kKind ? static_cast<T const*>(fields_.get()) : nullptr;
    }

    // Passes the fields to a visitor that only reads them.
    void show(Fields& visitor) const;

    // Returns a copy of the edit whose fields the visitor has changed.
    Edit changed_by(Fields& visitor) const;

private:
    friend Result<DocumentState> apply_edit(DocumentState state, Edit const& edit,
                                            SceneBuilder& builder);

    EditKind const* kind_;
    std::shared_ptr<void const> fields_; // Fields of the edit, shared between its copies.
};

// The kinds of edits that a program knows. Each kind has a different word.
using EditKinds = std::span<EditKind const* const>;

// Finds a kind of edit by its word in sessions; null if there is none.
EditKind const* find_edit_kind(EditKinds kinds, std::string_view word);

} // namespace tractus::scene
