#include "tests/engine/methods/leaves/botanical_leaf.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::leaf {

namespace {

using Line = std::vector<Vec2>;

// Formula for half of a leaf's margin, x as a function of y.
struct Profile {
    double width = 0.3;
    double low = 1; // Below 1: the widest place is below the middle.
    double blunt = 1;
    int waves = 0;
    double wave_depth = 0; // Depth of the waves, as a share of the leaf's width at the same y.
};

Line half_of(Profile const& profile)
{
    Line line;
    constexpr int kPoints = 200;
    for (int i = 0; i <= kPoints; ++i) {
        double const y = double(i) / kPoints;
        double const body
            = std::pow(std::max(0.0, std::sin(kPi * std::pow(y, profile.low))), profile.blunt);
        double const wave
            = 1 - profile.wave_depth * (0.5 + 0.5 * std::cos(2 * kPi * profile.waves * y));
        line.emplace_back(profile.width * body * wave, y);
    }
    line.back().x() = 0;
    return line;
}

// Builds a line of parabolas, beginning at (0, 0). `controls` has a control point and an end point
// for each parabola.
Line half_of(Line const& controls)
{
    Line line { Vec2::Zero() };
    for (std::size_t k = 0; k + 1 < controls.size(); k += 2) {
        Vec2 const from = line.back();
        for (int i = 1; i <= 16; ++i) {
            double const t = i / 16.0;
            line.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * controls[k]
                           + t * t * controls[k + 1]);
        }
    }
    return line;
}

struct Species {
    std::string name;
    Line half {};
    double stalk = 0.2;
    std::vector<double> mains {}; // Angles of the main veins on one side of the midrib, in degrees.
    int pairs = 0;                // Number of pairs of side veins on the midrib.
    double first = 0.1;           // Position of the first pair, as a share of the midrib's length.
    double last = 0.8;            // Position of the last pair, as a share of the midrib's length.
    double angle = 45;            // Angle of the side veins at the midrib's base, in degrees.
    double angle_at_tip = 38;     // Angle of the side veins at the midrib's tip, in degrees.
    double turn = 0;              // Bend of each vein towards the tip, in degrees.
    // Displacement of the veins on the left relative to those on the right, as a share of the
    // interval between pairs.
    double alternate = 0;
    int sides_of_mains = 0; // Number of side veins on each side of the first main vein.
};

Line const kLimeHalf { { 0.05, -0.12 }, { 0.2, -0.1 },  { 0.42, -0.07 }, { 0.48, 0.2 },
                       { 0.52, 0.5 },   { 0.26, 0.75 }, { 0.08, 0.88 },  { 0, 1 } };

Line const kIvyHalf { { 0.05, -0.14 }, { 0.24, -0.17 }, { 0.38, -0.18 }, { 0.48, -0.14 },
                      { 0.42, -0.03 }, { 0.42, 0.08 },  { 0.52, 0.22 },  { 0.7, 0.36 },
                      { 0.5, 0.36 },   { 0.3, 0.48 },   { 0.24, 0.6 },   { 0.21, 0.7 },
                      { 0.15, 0.84 },  { 0, 1 } };

Line const kMapleHalf { { 0.08, -0.12 }, { 0.22, -0.12 }, { 0.3, -0.12 }, { 0.38, -0.17 },
                        { 0.36, -0.06 }, { 0.4, -0.02 },  { 0.46, 0.03 }, { 0.52, 0.03 },
                        { 0.45, 0.08 },  { 0.48, 0.12 },  { 0.53, 0.17 }, { 0.6, 0.19 },
                        { 0.56, 0.24 },  { 0.6, 0.3 },    { 0.66, 0.38 }, { 0.74, 0.43 },
                        { 0.62, 0.44 },  { 0.6, 0.47 },   { 0.6, 0.53 },  { 0.58, 0.59 },
                        { 0.48, 0.54 },  { 0.45, 0.53 },  { 0.42, 0.57 }, { 0.4, 0.61 },
                        { 0.28, 0.54 },  { 0.2, 0.49 },   { 0.19, 0.56 }, { 0.22, 0.62 },
                        { 0.28, 0.68 },  { 0.35, 0.71 },  { 0.26, 0.73 }, { 0.24, 0.77 },
                        { 0.25, 0.82 },  { 0.24, 0.86 },  { 0.14, 0.86 }, { 0.1, 0.9 },
                        { 0.05, 0.97 },  { 0, 1 } };

std::vector<Species> with_a_midrib_alone()
{
    return { { .name = "beech",
               .half = half_of(Profile { 0.32, 0.95, 0.9, 8, 0.03 }),
               .stalk = 0.12,
               .pairs = 8,
               .first = 0.07,
               .last = 0.84,
               .angle = 49,
               .angle_at_tip = 38,
               .alternate = 0.4 },
             { .name = "birch",
               .half = half_of(Profile { 0.38, 0.55, 1.05 }),
               .stalk = 0.4,
               .pairs = 6,
               .first = 0.08,
               .last = 0.72,
               .angle = 50,
               .angle_at_tip = 40,
               .alternate = 0.15 },
             { .name = "magnolia",
               .half = half_of(Profile { 0.26, 1.45, 0.85 }),
               .stalk = 0.15,
               .pairs = 9,
               .first = 0.08,
               .last = 0.85,
               .angle = 58,
               .angle_at_tip = 52,
               .turn = 20,
               .alternate = 0.5 },
             { .name = "willow",
               .half = half_of(Profile { 0.085, 0.85, 0.8 }),
               .stalk = 0.07,
               .pairs = 8,
               .first = 0.1,
               .last = 0.72,
               .angle = 42,
               .angle_at_tip = 38,
               .alternate = 0.3 },
             { .name = "oak",
               .half = half_of(Profile { 0.36, 1.3, 0.8, 5, 0.42 }),
               .stalk = 0.05,
               .pairs = 5,
               .first = 0.1,
               .last = 0.72,
               .angle = 50,
               .angle_at_tip = 40,
               .alternate = 0.1 } };
}

std::vector<Species> with_several_main_veins()
{
    return { { .name = "lime",
               .half = half_of(kLimeHalf),
               .stalk = 0.5,
               .mains = { 58, 111 },
               .pairs = 4,
               .first = 0.25,
               .last = 0.75,
               .angle = 46,
               .angle_at_tip = 42,
               .alternate = 0.2,
               .sides_of_mains = 2 },
             { .name = "ivy",
               .half = half_of(kIvyHalf),
               .stalk = 0.6,
               .mains = { 62.8, 106 },
               .pairs = 2,
               .first = 0.5,
               .last = 0.7,
               .angle = 42,
               .angle_at_tip = 40,
               .sides_of_mains = 1 },
             { .name = "maple",
               .half = half_of(kMapleHalf),
               .stalk = 0.7,
               .mains = { 60, 114 },
               .pairs = 2,
               .first = 0.45,
               .last = 0.62,
               .angle = 40,
               .angle_at_tip = 38,
               .sides_of_mains = 1 } };
}

Species species_of(std::string const& name)
{
    for (auto const& list : { with_a_midrib_alone(), with_several_main_veins() })
        for (auto const& species : list)
            if (species.name == name)
                return species;
    ADD_FAILURE() << "there is no species " << name;
    return {};
}

bool has_inside(Line const& ring, Vec2 const& at)
{
    int turns = 0; // Winding number of the ring about the point.
    double const x = at.x();
    double const y = at.y();
    Vec2 const* before = &ring.back();
    for (Vec2 const& point : ring) {
        double const* const a = before->data();
        double const* const b = point.data();
        before = &point;
        if ((a[1] <= y) == (b[1] <= y))
            continue;
        double const side = (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x);
        if (side > 0 && b[1] > y)
            ++turns;
        else if (side < 0 && b[1] <= y)
            --turns;
    }
    return turns != 0;
}

// Returns a vein from a point to the margin. It has the given initial heading, and turns to the
// left by the given total angle.
Line vein_to(Line const& margin, Vec2 const& from, double heading_deg, double turn_left_deg)
{
    auto const grow = [&](double length, double turn) {
        constexpr double kStep = 0.008;
        Line line { from };
        for (double s = 0; s < 1.5; s += kStep) {
            double const heading
                = radians(heading_deg - turn * std::min(1.0, (s + 0.5 * kStep) / length));
            Vec2 const next = line.back() + kStep * Vec2(std::sin(heading), std::cos(heading));
            if (s > 0.03 && !has_inside(margin, next))
                break;
            line.push_back(next);
        }
        return line;
    };
    // Adjusts the curvature until the vein has turned by the requested angle at the margin.
    auto line = grow(1, 0);
    for (int i = 0; i < 4 && turn_left_deg != 0; ++i)
        line = grow(0.008 * double(line.size()), turn_left_deg);
    return line;
}

void add_pairs(BotanicalLeaf& leaf, Species const& species, Random& random)
{
    auto const margin = leaf.margin();
    double const gap = (species.last - species.first) / std::max(1, species.pairs - 1);
    for (int i = 0; i < species.pairs; ++i)
        for (bool const is_right : { true, false }) {
            double const at = species.first + i * gap
                + gap * ((is_right ? 0 : species.alternate) + 0.06 * random.normal());
            double const angle
                = species.angle + at * (species.angle_at_tip - species.angle) + random.normal();
            double const sign = is_right ? 1 : -1;
            leaf.sides.push_back(
                { .parent = -1,
                  .at = at,
                  .angle_deg = sign * angle,
                  .line = vein_to(margin, { 0, at }, sign * angle, sign * species.turn) });
        }
}

void add_mains(BotanicalLeaf& leaf, Species const& species, Random& random)
{
    auto const margin = leaf.margin();
    Vec2 const hub(0, 0.012);
    for (std::size_t k = 0; k < species.mains.size(); ++k)
        for (double const sign : { 1.0, -1.0 }) {
            double const angle = sign * (species.mains[k] + random.normal());
            leaf.mains.push_back(
                { .parent = -1, .angle_deg = angle, .line = vein_to(margin, hub, angle, 0) });
            for (int i = 0; i < (k == 0 ? species.sides_of_mains : 0); ++i)
                for (double const side : { 1.0, -1.0 }) {
                    double const at = 0.42 + 0.2 * i + 0.03 * side + 0.01 * random.normal();
                    double const own = side * (42 + random.normal());
                    auto const& line = leaf.mains.back().line;
                    Vec2 const from = line.front() + at * (line.back() - line.front());
                    leaf.sides.push_back({ .parent = static_cast<int>(leaf.mains.size()) - 1,
                                           .at = at,
                                           .angle_deg = own,
                                           .line = vein_to(margin, from, angle + own, 0) });
                }
        }
}

// Varies one half of a margin, so that the halves of a leaf are not mirror images.
Line grown(Line half, double side, Random& random)
{
    double const width = 1 + 0.015 * random.normal();
    double const bulge = 0.01 * random.normal();
    double const phase = random.uniform(0, 2 * kPi);
    for (auto& at : half)
        at.x() *= side * (width + bulge * std::sin(2 * kPi * at.y() + phase));
    return half;
}

} // namespace

std::vector<Vec2> BotanicalLeaf::margin() const
{
    auto line = right;
    line.insert(line.end(), left.rbegin() + 1, left.rend() - 1);
    return line;
}

std::vector<std::string> botanical_species()
{
    return { "beech", "birch", "ivy", "lime", "magnolia", "maple", "oak", "willow" };
}

BotanicalLeaf botanical_leaf(std::string const& name, Random& random)
{
    auto const species = species_of(name);
    BotanicalLeaf leaf;
    leaf.right = grown(species.half, 1, random);
    leaf.left = grown(species.half, -1, random);
    leaf.stalk = species.stalk * random.uniform(0.8, 1.2);
    add_mains(leaf, species, random);
    add_pairs(leaf, species, random);
    return leaf;
}

} // namespace tractus::leaf
