#pragma once

#include "engine/scene/scene.h"

namespace tractus {

// Returns a model with a trunk of six internodes, and two branches with four and two internodes.
inline scene::LoadModel small_model()
{
    return { .source = { .name = "small.l",
                         .text = "Lsystem: 1\nderivation length: 1\n"
                                 "Axiom: F(10)F(10)[+(60)F(8)F(8)]"
                                 "F(10)[-(60)F(8)F(8)F(8)F(8)]F(10)F(10)F(10)\n"
                                 "A --> A\nendlsystem\n" } };
}

inline scene::Scene small_scene()
{
    return scene::apply_edit({}, small_model()).value();
}

inline void select(scene::Scene& scene, variation::Selection const& paths)
{
    scene = scene::apply_edit(scene, scene::select_paths(scene, paths)).value();
}

// Returns a stroke through the given positions, in mm. Between two positions it has ten tips, 5 ms
// apart.
inline Stroke stroke_through(std::vector<Vec3> const& places_mm)
{
    Stroke stroke;
    std::int64_t time_ns = 0;
    for (std::size_t i = 1; i < places_mm.size(); ++i)
        for (int k = i == 1 ? 0 : 1; k <= 10; ++k)
            stroke.tips.push_back(
                { .time = timestamp_ns(time_ns += 5'000'000),
                  .position_mm = places_mm[i - 1] + (places_mm[i] - places_mm[i - 1]) * k / 10,
                  .pressure = 0.5,
                  .touching = true });
    return stroke;
}

} // namespace tractus
