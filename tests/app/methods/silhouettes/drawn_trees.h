#pragma once

#include "app/methods/silhouettes/outline_meaning.h"
#include "tests/app/small_model.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

// Strokes for a tree that is drawn by its outline, and the scenes that result.
namespace tractus::silhouette::drawn_trees {

using silhouette::DrawTree;

// Returns an outline around (x, y), in mm, with four lobes and a radius of 30 mm.
inline Stroke crown_around(double x, double y, double share = 1)
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 60 * share; ++i) {
        double const angle = i * 2 * kPi / 60 - kPi / 2;
        double const r = 30 + 6 * std::fabs(std::sin(2 * angle));
        places.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle), 150);
    }
    return stroke_through(places);
}

inline Stroke trunk_at(double x)
{
    return stroke_through({ { x, -60, 150 }, { x + 2, -20, 150 }, { x, 20, 150 } });
}

// Returns an outline around the crown's upper right lobe.
inline Stroke lobe_of_crown(double size = 1)
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 40; ++i) {
        double const angle = i * 2 * kPi / 40;
        double const r = size * (11 + 2 * std::cos(5 * angle));
        places.emplace_back(19 + r * std::cos(angle), 29 + r * std::sin(angle), 150);
    }
    return stroke_through(places);
}

inline DrawTree meant(Stroke const& stroke, scene::Scene const& scene, OutlineTool const& tool = {})
{
    auto const edit = drawn_tree(tool, stroke, scene);
    EXPECT_TRUE(edit) << edit.error().message;
    return edit.value_or(DrawTree {});
}

inline scene::Scene after(scene::Scene const& scene, Stroke const& stroke,
                          OutlineTool const& tool = {})
{
    return scene::apply_edit(scene, meant(stroke, scene, tool)).value();
}

inline scene::Scene crowned()
{
    return after(after({}, trunk_at(0)), crown_around(0, 10));
}

} // namespace tractus::silhouette::drawn_trees
