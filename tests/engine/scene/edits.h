#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <utility>
#include <vector>

namespace tractus {

// Strokes as sessions before format 4 name them: by their numbers in the scene's list.
inline Items numbered(std::initializer_list<std::uint64_t> numbers)
{
    return { .numbers = numbers };
}

// The ids of strokes by their numbers in the scene's list.
inline std::vector<ItemId> ids_of(Scene const& scene, std::initializer_list<std::size_t> numbers)
{
    std::vector<ItemId> ids;
    for (auto const number : numbers)
        ids.push_back(scene.associations[number].id);
    return ids;
}

// The scene after edits of which none may be refused.
inline Scene after(std::vector<Edit> const& edits, Scene scene = {})
{
    for (auto const& edit : edits) {
        auto next = apply_edit(scene, edit);
        EXPECT_TRUE(next) << next.error().message;
        if (next)
            scene = *std::move(next);
    }
    return scene;
}

} // namespace tractus
