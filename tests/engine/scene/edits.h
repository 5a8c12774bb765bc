#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <utility>
#include <vector>

namespace tractus::scene {

// Names strokes by their numbers in the scene's list, as sessions did before format 4.
inline Items numbered(std::initializer_list<std::uint64_t> numbers)
{
    return { .numbers = numbers };
}

// Returns the ids of the strokes with the given numbers in the scene's list.
inline std::vector<ItemId> ids_of(Scene const& scene, std::initializer_list<std::size_t> numbers)
{
    std::vector<ItemId> ids;
    for (auto const number : numbers)
        ids.push_back(scene.associations[number].id);
    return ids;
}

// Returns a stroke of 21 tips that rises by 100 mm and moves sideways to `end_mm`.
inline Stroke stroke_towards(Vec3 const& end_mm)
{
    Stroke stroke;
    for (int i = 0; i <= 20; ++i)
        stroke.tips.push_back({ .time = timestamp_ns(i * 5'000'000),
                                .position_mm = Vec3(0, 0, 5.0 * i) + end_mm * i / 20,
                                .touching = true });
    return stroke;
}

// Returns the scene after all of the given edits. The test fails if one of them is refused.
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

} // namespace tractus::scene
