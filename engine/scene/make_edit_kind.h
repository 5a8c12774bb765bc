#pragma once

#include "engine/scene/edit_kind.h"
#include "engine/scene/scene.h"

#include <memory>
#include <string>
#include <utility>

namespace tractus {

// The row for edits of type T, from functions on T.
template<typename T, void (*fields)(Fields&, T&),
         Result<Scene> (*apply)(Scene, T const&, LoadOptions const&),
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
                 [](Scene scene, void const* edit, LoadOptions const& options) {
                     return apply(std::move(scene), *static_cast<T const*>(edit), options);
                 },
             .describe = [](void const* edit) { return describe(*static_cast<T const*>(edit)); } };
}

} // namespace tractus
