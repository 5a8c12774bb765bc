#pragma once

#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/line_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace tractus::lines {

// Returns a sketch with an upright stem of 200 mm and boundaries 50 and 30 mm beside it. Lower
// organs lean more upwards than higher ones.
inline LineSketch hand_sketch()
{
    return { .stem = { Vec3(0, 0, 0), Vec3(0, 200, 0) },
             .left = { Vec2(-50, 0), Vec2(-50, 300) },
             .right = { Vec2(30, 0), Vec2(30, 300) },
             .inclinations = { { Vec2(-60, 100), Vec2(0, 40), Vec2(40, 80) },
                               { Vec2(-60, 160), Vec2(0, 160), Vec2(40, 160) } },
             .nodes_per_layer = { 4 } };
}

inline std::vector<Vec3> line(std::vector<Vec2> const& points)
{
    std::vector<Vec3> result;
    for (auto const& point : points)
        result.emplace_back(point.x(), point.y(), 0);
    return result;
}

// Returns an arc of a circle about (radius, 0). It begins vertically and bends to the right.
inline std::vector<Vec3> arc(double radius_mm, double angle_deg, int pieces)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= pieces; ++i) {
        double const angle = radians(angle_deg) * i / pieces;
        points.emplace_back(radius_mm - radius_mm * std::cos(angle), radius_mm * std::sin(angle),
                            0);
    }
    return points;
}

// Returns a sketch with a stem that bends to the right, and with corners in its boundaries and
// inclination lines.
inline LineSketch bent_sketch()
{
    return { .stem = arc(100, 60, 100),
             .left = { Vec2(-60, -10), Vec2(-20, 60), Vec2(30, 130) },
             .right = { Vec2(40, -10), Vec2(60, 40), Vec2(75, 110) },
             .inclinations = { { Vec2(-60, 50), Vec2(2, 20), Vec2(60, 40) },
                               { Vec2(-10, 110), Vec2(40, 80), Vec2(90, 85) } },
             .nodes_per_layer = { 6 } };
}

// Returns a sketch whose stem has only some points, with corners of up to 30 degrees.
inline LineSketch coarse_sketch()
{
    return { .stem = { Vec3(0, 0, 0), Vec3(10, 50, 0), Vec3(40, 90, 0), Vec3(55, 140, 0),
                       Vec3(50, 190, 0) },
             .left = { Vec2(-40, 0), Vec2(-35, 60), Vec2(0, 120), Vec2(20, 210) },
             .right = { Vec2(45, -10), Vec2(70, 60), Vec2(95, 140), Vec2(80, 230) },
             .inclinations = { { Vec2(-60, 60), Vec2(4, 20), Vec2(70, 45) },
                               { Vec2(-30, 130), Vec2(42, 96), Vec2(110, 110) },
                               { Vec2(10, 200), Vec2(53, 160), Vec2(100, 180) } },
             .nodes_per_layer = { 5, 7 } };
}

inline LineSketch mirrored(LineSketch sketch)
{
    for (auto& point : sketch.stem)
        point.x() = -point.x();
    std::swap(sketch.left, sketch.right);
    for (auto* const boundary : { &sketch.left, &sketch.right })
        for (auto& point : *boundary)
            point.x() = -point.x();
    for (auto& line : sketch.inclinations)
        for (auto& point : line)
            point.x() = -point.x();
    for (auto& line : sketch.around)
        for (auto& point : line)
            point.x() = -point.x();
    return sketch;
}

inline Construction measured(LineSketch const& sketch)
{
    auto result = measure_sketch(sketch);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : *measure_sketch(hand_sketch());
}

// Returns the error message of measure_sketch() for a sketch.
inline std::string refusal(LineSketch const& sketch)
{
    auto const result = measure_sketch(sketch);
    return result ? "it is measured" : result.error().message;
}

inline lsystem::Model compiled(LineModel const& model)
{
    auto result
        = lsystem::compile_model(model.source, [&](std::string const& name) -> Result<std::string> {
              return model.functions.at(name);
          });
    EXPECT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->warnings.empty()) << result->warnings.front();
    return *result;
}

inline Plant grown(LineModel const& model)
{
    auto const text = compiled(model);
    return *lsystem::interpret(text, *lsystem::derive(text));
}

// Returns the tips of the organs in the plant of a sketch's model, on the sheet.
inline std::vector<Vec3> tips_of(LineSketch const& sketch, Pattern const& pattern)
{
    auto const construction = measured(sketch);
    return organ_tips(construction, grown(write_model(construction, pattern, "plant")));
}

// Returns the distance of a point from a line as seen from the front.
inline double distance_mm(Vec3 const& point, std::vector<Vec2> const& line)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        Vec2 const piece = line[i] - line[i - 1];
        Vec2 const way = point.head<2>() - line[i - 1];
        double const share = std::clamp(way.dot(piece) / piece.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (way - share * piece).norm());
    }
    return least;
}

} // namespace tractus::lines
