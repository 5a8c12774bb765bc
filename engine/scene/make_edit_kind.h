#pragma once

#include "engine/scene/document_state.h"
#include "engine/scene/edit_kind.h"
#include "engine/scene/scene_builder.h"

#include <memory>
#include <string>
#include <utility>

namespace tractus::scene {

// Makes the table row for edits of type T from functions that take a T.
template<typename T, void (*fields)(Fields&, T&),
         Result<DocumentState> (*apply)(DocumentState, T const&, SceneBuilder&),
         std::string (*describe)(T const&)>
constexpr EditKind make_edit_kind(char const* word, bool loads_plant = false)
{
    return { .word = word,
             .loads_plant = loads_plant,
             .make = [] { return std::shared_ptr<void>(std::make_shared<T>()); },
             .copy =
                 [](void const* edit) {
                     return std::shared_ptr<void>(
                         std::make_shared<T>(*static_cast<T const*>(edit)));
                 },
             .fields = [](Fields& visitor, void* edit) { fields(visitor, *static_cast<T*>(edit)); },
             .apply =
                 [](DocumentState state, void const* edit, SceneBuilder& builder) {
                     return apply(std::move(state), *static_cast<T const*>(edit), builder);
                 },
             .describe = [](void const* edit) { return describe(*static_cast<T const*>(edit)); } };
}

} // namespace tractus::scene
