#pragma once

#include "engine/base/random.h"
#include "engine/methods/silhouettes/bumps.h"
#include "engine/methods/silhouettes/outline.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"
#include "tests/corpus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace tractus::silhouette {

// Returns a stroke through points, drawn with 200 samples a second and with the surface at 140 mm.
inline Stroke stroke_of(std::vector<Vec2> const& points)
{
    Stroke stroke;
    std::int64_t time_ns = 0;
    for (auto const& point : points)
        stroke.tips.push_back({ .time = timestamp_ns(time_ns += 5'000'000),
                                .position_mm = { point.x(), point.y(), 140 },
                                .touching = true });
    return stroke;
}

// Returns the scene after an edit that draws on its active plant, or on a new plant if no plant is
// active.
inline scene::Scene draw_on(scene::Scene const& before, DrawTree edit)
{
    edit.plant = before.state.active;
    auto after = scene::apply_edit(before, edit);
    EXPECT_TRUE(after) << after.error().message;
    return after.value_or(scene::Scene {});
}

inline std::vector<Vec2> upright(double low, double high)
{
    return { Vec2(0, low), Vec2(0, high) };
}

inline Drawing star(int spikes, double inner_mm, double outer_mm)
{
    Drawing drawing { { {} }, upright(-inner_mm, 0.3 * outer_mm) };
    for (int i = 0; i < 2 * spikes; ++i) {
        double const angle = kPi / 2 + i * kPi / spikes;
        drawing.outline[0].push_back((i % 2 == 0 ? outer_mm : inner_mm)
                                     * Vec2(std::cos(angle), std::sin(angle)));
    }
    return drawing;
}

inline Drawing ellipse(double half_width_mm, double half_height_mm)
{
    Drawing drawing { { {} }, upright(-1.2 * half_height_mm, 0.7 * half_height_mm) };
    for (int i = 0; i < 200; ++i)
        drawing.outline[0].emplace_back(half_width_mm * std::cos(i * kPi / 100),
                                        half_height_mm * std::sin(i * kPi / 100));
    return drawing;
}

// Returns the outline of overlapping discs (x, y, radius) around the origin. Its points lie on rays
// from the origin.
inline std::vector<Vec2> union_of_discs(std::vector<Vec3> const& discs, int points)
{
    std::vector<Vec2> outline;
    for (int i = 0; i < points; ++i) {
        double const angle = -kPi / 2 + 2 * kPi * i / points;
        Vec2 const ray(std::cos(angle), std::sin(angle));
        double far = 0;
        for (auto const& disc : discs) {
            double const along = ray.dot(disc.head<2>());
            double const square
                = along * along - disc.head<2>().squaredNorm() + disc.z() * disc.z();
            if (square >= 0)
                far = std::max(far, along + std::sqrt(square));
        }
        outline.emplace_back(far * ray);
    }
    return outline;
}

// Returns a crown with a smooth bottom. Lobes lead from its right over its top to its left.
inline Drawing lobed_crown(int lobes, double first_deg = -25, double last_deg = 205)
{
    std::vector<Vec3> discs { Vec3(0, 0, 60) };
    double const step_deg = (last_deg - first_deg) / std::max(lobes - 1, 1);
    double const radius = std::min(1.12 * 62 * std::sin(radians(step_deg) / 2), 45.0);
    for (int i = 0; i < lobes; ++i) {
        double const angle = radians(first_deg + i * step_deg);
        discs.emplace_back(62 * std::cos(angle), 62 * std::sin(angle), radius);
    }
    return { { union_of_discs(discs, 720) }, upright(-90, 50) };
}

// Returns a scene with a tree whose crown has five lobes.
inline scene::Scene lobed_tree()
{
    auto const drawing = lobed_crown(5);
    auto const stem
        = draw_on({}, { .part = DrawTree::Part::Trunk, .stroke = stroke_of(drawing.trunk) });
    return draw_on(stem,
                   { .part = DrawTree::Part::Outline, .stroke = stroke_of(drawing.outline[0]) });
}

// Returns a drawing whose outline is a closed line through random points, which crosses itself.
inline Drawing scribble(std::uint32_t number)
{
    Random random({ 20, 1, number });
    Drawing drawing { { {} }, {} };
    auto const corners = 8 + random.next_u32() % 24;
    for (std::uint32_t i = 0; i < corners; ++i)
        drawing.outline[0].emplace_back(random.uniform(0, 100), random.uniform(0, 100));
    drawing.outline[0].push_back(drawing.outline[0].front());
    return drawing;
}

inline Drawing moved(Drawing drawing, Similarity const& way)
{
    for (auto& stroke : drawing.outline)
        stroke = way.points(stroke);
    drawing.trunk = way.points(drawing.trunk);
    return drawing;
}

inline CleanDrawing cleaned(Drawing const& drawing, OutlineOptions const& options = {})
{
    auto result = clean_drawing(drawing, options);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : *clean_drawing(ellipse(50, 50));
}

inline std::string refusal(Drawing const& drawing)
{
    auto const result = clean_drawing(drawing);
    return result ? "it is taken" : result.error().message;
}

// An outline of the corpus of published drawings.
struct Published {
    std::string name;
    Drawing drawing;
    nlohmann::json expected;
};

inline Vec2 point_in(nlohmann::json const& point)
{
    return { point[0].get<double>(), point[1].get<double>() };
}

inline std::vector<Vec2> points_in(nlohmann::json const& list)
{
    std::vector<Vec2> points;
    for (auto const& point : list)
        points.push_back(point_in(point));
    return points;
}

inline std::vector<Published> published_outlines()
{
    std::vector<Published> result;
    for (auto const& entry : std::filesystem::directory_iterator(corpus() / "silhouettes")) {
        if (entry.path().extension() != ".json" || entry.path().stem() == "arrangement")
            continue;
        std::ifstream stream(entry.path());
        auto const file = nlohmann::json::parse(stream);
        result.push_back({ entry.path().stem().string(),
                           { { points_in(file["outline"]) }, points_in(file["trunk"]) },
                           file["expected"] });
    }
    std::sort(result.begin(), result.end(),
              [](Published const& a, Published const& b) { return a.name < b.name; });
    EXPECT_EQ(result.size(), 11U);
    return result;
}

// Returns the bumps of a drawing, in the frame of the drawing.
inline std::vector<Bump> bumps_of(CleanDrawing const& clean)
{
    auto bumps = find_bumps(ChordalAxis(clean.outline));
    if (auto const run = inside_run(clean.outline, clean.trunk))
        set_roles(bumps, clean.outline, clean.trunk, *run);
    return bumps;
}

} // namespace tractus::silhouette
