#pragma once

#include "engine/plant/join_axes.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/limb_edits.h"
#include "engine/stroke/polyline.h"
#include "tests/engine/scene/edits.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

namespace tractus::scene {

// Returns a model of a trunk with six internodes of 100 mm, rotated about the vertical axis. It has
// five branches, each with six alternate twigs.
inline LoadModel leafy_tree(double turned_deg = 0)
{
    return { .source
             = { .name = "leafy.l",
                 .text = fmt::format(
                     "Lsystem: 1\nderivation length: 1\n"
                     "Axiom: #(3)/({})F(10)[+(60)B]F(10)[-(60)B]F(10)[&(60)B]F(10)[^(60)B]"
                     "F(10)[+(40)B]F(10)\n"
                     "B --> #(1)F(4)[#(.4)+(50)F(3)]F(4)[#(.4)-(50)F(3)]F(4)[#(.4)+(50)F(3)]"
                     "#(.6)F(4)[#(.4)-(50)F(2)]F(4)[#(.4)+(50)F(2)]F(4)[#(.4)-(50)F(2)]F(4)\n"
                     "endlsystem\n",
                     turned_deg) } };
}

inline Stroke stroke_of(std::vector<Vec3> const& places_mm, double pressure = 0.5)
{
    Stroke stroke;
    for (std::size_t i = 0; i < places_mm.size(); ++i)
        stroke.tips.push_back({ .time = timestamp_ns(static_cast<std::int64_t>(i) * 5'000'000),
                                .position_mm = places_mm[i],
                                .pressure = pressure,
                                .touching = true });
    return stroke;
}

// Returns an edit that shapes the selected branches, or their descendants, by a hanging stroke.
inline Associate shaping(variation::Propagation propagation)
{
    return { .stroke = stroke_towards({ 0, 150, -120 }),
             .propagation = propagation,
             .laying = variation::StrokeLaying::HeadingAndPitch };
}

// Returns the points of a stroke that begins at `from_mm` and winds upwards and outwards.
inline std::vector<Vec3> winding(Vec3 const& from_mm, double length_mm)
{
    std::vector<Vec3> places_mm;
    for (int i = 0; i <= 60; ++i) {
        double const t = i / 60.0;
        places_mm.push_back(from_mm
                            + length_mm * Vec3(0.8 * t, 0.1 * std::sin(7 * t), 0.5 * t * t));
    }
    return places_mm;
}

// Returns an edit that draws a limb at the end of a segment of the active plant.
inline DrawLimb on_segment(Scene const& scene, SegmentId segment,
                           std::vector<Vec3> const& places_mm)
{
    auto const tip = nodes_of(*scene.base, segment).tip;
    return { .plant = scene.state.active,
             .at = scene.rest->addresses.address_of(*scene.base, segment),
             .joint_mm = scene.placement.world_of_plant(scene.base->node_position_mm[tip]),
             .scale = scene.placement.scale,
             .stroke = stroke_of(places_mm) };
}

inline Scene tree_scene(double turned_deg = 0)
{
    return after({ SetScale { 1 }, leafy_tree(turned_deg) });
}

inline Axis const& limb_axis(BuiltPlant const& plant, std::size_t number = 0)
{
    return plant.base->axes[axis_of(*plant.base, limb_segments(plant).at(number).second)];
}

inline std::size_t laterals_on(Plant const& plant, Axis const& axis)
{
    auto const id = static_cast<AxisId>(&axis - plant.axes.data());
    return static_cast<std::size_t>(
        std::count_if(plant.axes.begin(), plant.axes.end(),
                      [&](Axis const& other) { return other.parent_axis == id; }));
}

inline double distance_to(std::vector<Vec3> const& line_mm, Vec3 const& place_mm)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line_mm.size(); ++i) {
        double const share = nearest_share(place_mm, line_mm[i - 1], line_mm[i]);
        least = std::min(
            least, (line_mm[i - 1] + share * (line_mm[i] - line_mm[i - 1]) - place_mm).norm());
    }
    return least;
}

} // namespace tractus::scene
