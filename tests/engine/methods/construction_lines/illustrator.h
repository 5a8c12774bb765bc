#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/recognise_line.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tractus::lines {

// Draws sketches like a hand, with known roles of the lines. It shares nothing with the code that
// recognises lines.
class Illustrator {
public:
    explicit Illustrator(unsigned seed)
        : random_(seed)
    {
        height_mm_ = between(110, 260);
        bow_ = between(-0.9, 0.9);
        width_left_mm_ = between(25, 70);
        width_right_mm_ = between(25, 70);
        closing_ = between(0.2, 1);
        from_foot_ = chance(0.3);
        tremor_mm_ = between(0.3, 1);
    }

    struct Meant {
        Role role;
        std::vector<Vec3> stroke;
    };

    // Returns how far lines extend beside the stem on one side, in mm.
    double width_mm(Role side) const
    {
        return side == Role::Left ? width_left_mm_ : width_right_mm_;
    }

    // Draws the lines of a sketch. The stem is the first one.
    std::vector<Meant> draw()
    {
        std::vector<Meant> rest;
        if (chance(0.9))
            add_boundary(rest, Role::Left);
        if (chance(0.9) || rest.empty())
            add_boundary(rest, Role::Right);
        add_inclinations(rest);
        std::shuffle(rest.begin(), rest.end(), random_);
        if (chance(0.3)) { // An illustrator who does not like a line draws it again later.
            auto const& earlier = rest[random_() % rest.size()];
            rest.push_back({ earlier.role, trembling(earlier.stroke) });
        }
        std::vector<Meant> all { { Role::Stem, trembling(stem()) } };
        for (auto& line : rest) {
            if (chance(0.5))
                std::reverse(line.stroke.begin(), line.stroke.end());
            all.push_back(line);
        }
        return all;
    }

private:
    double between(double least, double most)
    {
        return least + (most - least) * static_cast<double>(random_() % 100'001) / 100'000.0;
    }
    bool chance(double share) { return between(0, 1) < share; }

    // Returns the position at the share `t` of the axis, and `beside_mm` beside it, positive on the
    // left.
    Vec3 place(double t, double beside_mm) const
    {
        double const turn = bow_ * t;
        double const bent = std::fabs(bow_) < 1e-6 ? t : std::sin(turn) / bow_;
        double const drift = std::fabs(bow_) < 1e-6 ? 0 : (1 - std::cos(turn)) / bow_;
        return { height_mm_ * drift - beside_mm * std::cos(turn),
                 height_mm_ * bent + beside_mm * std::sin(turn), 0 };
    }

    std::vector<Vec3> stem() const
    {
        std::vector<Vec3> points;
        for (int i = 0; i <= 120; ++i)
            points.push_back(place(i / 120.0, 0));
        return points;
    }

    double width_mm(Role side, double t) const
    {
        double const wide_mm = side == Role::Left ? width_left_mm_ : -width_right_mm_;
        double const foot = from_foot_ ? std::sin(kPi / 2 * std::clamp(t / 0.2, 0.0, 1.0)) : 1;
        return wide_mm * foot * (1 - closing_ * t * t) * (0.75 + 0.25 * std::sin(3 * t));
    }

    void add_boundary(std::vector<Meant>& lines, Role side)
    {
        double const from = between(-0.05, 0.12);
        double const to = between(0.9, 1.08);
        std::vector<Vec3> points;
        for (int i = 0; i <= 100; ++i) {
            double const t = from + (to - from) * i / 100;
            points.push_back(place(t, width_mm(side, t)));
        }
        lines.push_back({ side, trembling(points) });
    }

    std::vector<Vec3> half(double t, Role side, double rise, double gap_mm)
    {
        std::vector<Vec3> points;
        double const reach_mm = width_mm(side, t) * between(0.85, 1.3);
        double const from_mm = side == Role::Left ? gap_mm : -gap_mm;
        for (int i = 0; i <= 40; ++i) {
            double const share = i / 40.0;
            points.push_back(place(t + rise * share, from_mm + (reach_mm - from_mm) * share));
        }
        return points;
    }

    void add_inclinations(std::vector<Meant>& lines)
    {
        int const count = static_cast<int>(random_() % 3) + 2;
        for (int i = 0; i < count; ++i) {
            double const t = 0.08 + 0.84 * (i + between(0.2, 0.8)) / count;
            double const rise = between(-0.1, 0.35);
            auto left = half(t, Role::Left, rise, 0);
            auto const right = half(t, Role::Right, rise * between(0.7, 1.3), 0);
            if (chance(0.12)) {
                lines.push_back({ Role::HalfInclination,
                                  trembling(half(t, chance(0.5) ? Role::Left : Role::Right, rise,
                                                 between(0, 2))) });
                continue;
            }
            std::reverse(left.begin(), left.end());
            left.insert(left.end(), right.begin() + 1, right.end());
            lines.push_back({ Role::Inclination, trembling(left) });
        }
    }

    std::vector<Vec3> trembling(std::vector<Vec3> points)
    {
        double phase = between(0, 6.28);
        double const step = between(0.3, 0.9);
        for (auto& point : points) {
            point += tremor_mm_ * Vec3(std::sin(phase), std::cos(1.3 * phase), 0);
            phase += step;
        }
        return points;
    }

    std::mt19937 random_;
    double height_mm_;
    double bow_;
    double width_left_mm_;
    double width_right_mm_;
    double closing_;
    bool from_foot_;
    double tremor_mm_;
};

} // namespace tractus::lines
