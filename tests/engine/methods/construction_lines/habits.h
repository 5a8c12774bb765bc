#pragma once

#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "tests/engine/methods/drawn_by_hand.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace tractus::lines {

// Drawing habits of illustrators that the reader of sketches has to understand.
enum class Habit {
    None,
    Hooks,
    StemInPieces,
    // The top of the stem is redrawn to one side, over 15 to 25 mm but at most an eighth of the
    // stem.
    StemRedrawn,
    BoundaryInTwo,
    BoundaryInFour,
    BoundaryPart, // The middle of a boundary is redrawn, up to 8 mm further out.
    Restated,     // A line is drawn twice.
    Outline,      // Both boundaries are drawn in one closed stroke.
    OpenOutline,  // Both boundaries are drawn in one stroke from base to base.
    HalvesApart,  // The halves of inclination lines begin up to 7 mm beside the stem.
    AnyOrder,     // The stem is not drawn first.
    TipToBase,    // The stem is drawn from its top.
    Crown,        // Boundaries are drawn only around the crown, as for a palm.
    Overshoot,    // Lines extend further than intended.
};
constexpr std::array kHabitNames { "none",
                                   "hooks at both ends",
                                   "stem in three pieces",
                                   "stem drawn anew, its top aside",
                                   "boundary in two pieces",
                                   "boundary in four pieces",
                                   "middle of a boundary further out",
                                   "a line drawn again",
                                   "closed outline",
                                   "outline open at the foot",
                                   "half slopes off the stem",
                                   "any order, stem not first",
                                   "stem from tip to base",
                                   "boundaries around the crown alone",
                                   "overshoot" };
constexpr std::size_t kHabitCount = kHabitNames.size();

// True if the same sketch can show both habits.
inline bool go_together(Habit a, Habit b)
{
    auto const group = [](Habit habit) {
        switch (habit) {
        case Habit::StemInPieces:
        case Habit::StemRedrawn:
            return 1;
        case Habit::BoundaryInTwo:
        case Habit::BoundaryInFour:
        case Habit::BoundaryPart:
        case Habit::Outline:
        case Habit::OpenOutline:
        case Habit::Crown:
            return 2;
        default:
            return 0;
        }
    };
    return a != b && (group(a) == 0 || group(a) != group(b));
}

struct DrawnStroke {
    std::vector<Vec3> points;
    Role role = Role::Stem;
};

struct DrawnSketch {
    std::vector<DrawnStroke> strokes;
    LineSketch meant {}; // The intended sketch, without the numbers of nodes.
    double tremor_mm = 0;
};

// Draws a sketch as an illustrator with given habits. Half of the illustrators are left-handed;
// their drawing is mirrored.
class HabitualIllustrator {
public:
    HabitualIllustrator(std::uint64_t seed, double height_mm, double tremor_mm,
                        std::vector<Habit> habits)
        : hand_(seed)
        , habits_(std::move(habits))
        , height_mm_(height_mm)
        , tremor_mm_(tremor_mm)
    {
        bow_ = hand_.between(-0.8, 0.8);
        tilt_ = hand_.between(-0.2, 0.2);
        wide_left_ = hand_.between(0.2, 0.4);
        wide_right_ = hand_.between(0.2, 0.4);
        closing_ = hand_.between(0.4, 0.95);
        from_ = has(Habit::Crown) ? hand_.between(0.6, 0.78) : hand_.between(-0.03, 0.08);
        to_ = hand_.between(0.98, 1.06);
        is_mirrored_ = hand_.chance(0.5);
    }

    DrawnSketch draw()
    {
        DrawnSketch sketch { .strokes = {}, .tremor_mm = tremor_mm_ };
        auto stem = draw_stem(sketch);
        // Groups of strokes. The strokes of a group are drawn one after the other.
        std::vector<std::vector<DrawnStroke>> rest;
        draw_boundaries(sketch, rest);
        draw_inclinations(sketch, rest);
        if (has(Habit::Restated))
            rest.push_back({ restated(any_whole_line(rest)) });
        arrange(sketch, std::move(stem), std::move(rest));
        for (auto& stroke : sketch.strokes)
            finish(stroke);
        if (is_mirrored_)
            mirror(sketch);
        return sketch;
    }

private:
    bool has(Habit habit) const
    {
        return std::find(habits_.begin(), habits_.end(), habit) != habits_.end();
    }

    // Arguments are shares of the height; `beside` is positive on the left.
    Vec3 place(double t, double beside) const
    {
        double const turn = bow_ * t;
        double const small = 1e-6;
        double const bent = std::fabs(bow_) < small ? t : std::sin(turn) / bow_;
        double const drift = std::fabs(bow_) < small ? 0 : (1 - std::cos(turn)) / bow_;
        Vec3 const upright(drift - beside * std::cos(turn), bent + beside * std::sin(turn), 0);
        return height_mm_
            * Vec3(upright.x() * std::cos(tilt_) - upright.y() * std::sin(tilt_),
                   upright.x() * std::sin(tilt_) + upright.y() * std::cos(tilt_), 0);
    }

    template<typename At> static std::vector<Vec3> along(double from, double to, At at)
    {
        std::vector<Vec3> points;
        for (int i = 0; i <= 120; ++i)
            points.push_back(at(from + (to - from) * i / 120));
        return points;
    }

    std::vector<DrawnStroke> as_strokes(std::vector<std::vector<Vec3>> const& lines, Role role)
    {
        std::vector<DrawnStroke> strokes;
        for (auto const& line : lines)
            strokes.push_back({ line, role });
        return strokes;
    }

    std::vector<DrawnStroke> draw_stem(DrawnSketch& sketch)
    {
        auto const line = along(0, 1, [&](double t) { return place(t, 0); });
        sketch.meant.stem = line;
        if (has(Habit::StemInPieces))
            return as_strokes(hand_.pieces(line, 3), Role::Stem);
        if (!has(Habit::StemRedrawn))
            return { { line, Role::Stem } };
        double const aside
            = std::min(0.125, hand_.between(15, 25) / height_mm_) * (hand_.chance(0.5) ? 1 : -1);
        auto const first = along(0, 1, [&](double t) { return place(t, aside * t * t); });
        return { { first, Role::Stem }, { line, Role::Stem } };
    }

    double width(Role side, double t) const
    {
        double const wide = side == Role::Left ? wide_left_ : -wide_right_;
        double const share = std::clamp((t - from_) / (to_ - from_), 0.0, 1.0);
        double const foot = has(Habit::Crown) || has(Habit::Outline)
            ? std::sin(kPi / 2 * std::clamp(share / 0.2, 0.0, 1.0))
            : 1;
        return wide * std::max(foot, 0.1) * (1 - closing_ * share * share);
    }

    std::vector<Vec3> boundary(Role side)
    {
        return along(from_, to_, [&](double t) { return place(t, width(side, t)); });
    }

    static std::vector<Vec2> flat(std::vector<Vec3> const& line)
    {
        std::vector<Vec2> points;
        for (auto const& point : line)
            points.emplace_back(point.head<2>());
        return points;
    }

    void draw_boundaries(DrawnSketch& sketch, std::vector<std::vector<DrawnStroke>>& rest)
    {
        auto const left = boundary(Role::Left);
        auto const right = boundary(Role::Right);
        sketch.meant.left = flat(left);
        sketch.meant.right = flat(right);
        if (has(Habit::Outline) || has(Habit::OpenOutline)) {
            auto line = left;
            line.insert(line.end(), right.rbegin(), right.rend());
            if (has(Habit::Outline)) {
                line.push_back(line.front());
                auto const at = static_cast<std::ptrdiff_t>(hand_.below(20));
                std::rotate(line.begin(), line.begin() + at, line.end() - 1);
                line.back() = line.front();
            }
            rest.push_back({ { line, Role::Outline } });
            return;
        }
        for (auto const role : { Role::Left, Role::Right }) {
            auto const& line = role == Role::Left ? left : right;
            // Some habits apply to only one of the boundaries.
            auto const is_one = hand_.chance(0.5);
            if (has(Habit::BoundaryInTwo))
                rest.push_back(as_strokes(hand_.pieces(line, 2), role));
            else if (has(Habit::BoundaryInFour) && (is_one || role == Role::Left))
                rest.push_back(as_strokes(hand_.pieces(line, 4), role));
            else
                rest.push_back({ { line, role } });
        }
        if (has(Habit::BoundaryPart)) {
            bool const is_left = hand_.chance(0.5);
            double const out_mm = std::min(8.0, 0.08 * height_mm_);
            auto const& line = is_left ? left : right;
            double const from = hand_.between(0.2, 0.4);
            double const to = from + hand_.between(0.25, 0.4);
            auto const part = Hand::part_aside(line, from, to, is_left ? out_mm : -out_mm);
            rest.push_back({ { part, is_left ? Role::Left : Role::Right } });
            auto& meant = is_left ? sketch.meant.left : sketch.meant.right;
            meant = flat(replaced(line, part, from, to));
        }
    }

    static std::vector<Vec3> replaced(std::vector<Vec3> const& line, std::vector<Vec3> const& part,
                                      double from, double to)
    {
        ArcLength const all(line);
        auto result = along(0, from, [&](double t) { return all.at(t); });
        result.insert(result.end(), part.begin(), part.end());
        auto const tail = along(to, 1, [&](double t) { return all.at(t); });
        result.insert(result.end(), tail.begin(), tail.end());
        return result;
    }

    std::vector<Vec3> half(double t, Role side, double rise, double reach, double gap)
    {
        double const sign = side == Role::Left ? 1 : -1;
        double const out = sign * std::fabs(width(side, std::min(t + rise, 0.95))) * reach;
        return along(gap, 1, [&](double share) { return place(t + rise * share, out * share); });
    }

    void draw_inclinations(DrawnSketch& sketch, std::vector<std::vector<DrawnStroke>>& rest)
    {
        std::size_t const count = 2 + hand_.below(3);
        double const low = std::max(from_ + 0.02, 0.05);
        for (std::size_t i = 0; i < count; ++i) {
            double const t = low
                + (0.93 - low) * (static_cast<double>(i) + hand_.between(0.3, 0.7))
                    / static_cast<double>(count);
            double const narrow = std::fabs(std::min(width(Role::Left, std::min(t, 0.95)),
                                                     -width(Role::Right, std::min(t, 0.95))));
            double const rise
                = std::min((has(Habit::Crown) ? 0.4 : 1) * hand_.between(0, 0.28), 1.2 * narrow);
            double const reach = hand_.between(1.05, 1.35);
            auto const part
                = [&](Role side, double gap) { return half(t, side, rise, reach, gap); };
            auto whole = part(Role::Left, 0);
            std::reverse(whole.begin(), whole.end());
            auto const right = part(Role::Right, 0);
            whole.insert(whole.end(), right.begin() + 1, right.end());
            sketch.meant.inclinations.push_back(flat(whole));
            if (!has(Habit::HalvesApart)) {
                rest.push_back({ { whole, Role::Inclination } });
                continue;
            }
            auto const gap = [&](Role side) {
                double const out = std::fabs(width(side, std::min(t + rise, 0.95))) * reach;
                return std::min({ hand_.between(2, 7) / height_mm_, 0.07, 0.4 * out }) / out;
            };
            rest.push_back({ { part(Role::Left, gap(Role::Left)), Role::HalfInclination },
                             { part(Role::Right, gap(Role::Right)), Role::HalfInclination } });
        }
    }

    DrawnStroke any_whole_line(std::vector<std::vector<DrawnStroke>> const& rest)
    {
        std::vector<DrawnStroke> whole;
        for (std::size_t i = 0; i < rest.size(); ++i)
            if (rest[i].size() == 1 && !(has(Habit::BoundaryPart) && i == 2))
                whole.push_back(rest[i].front());
        return whole.empty() ? rest.back().front() : whole[hand_.below(whole.size())];
    }

    DrawnStroke restated(DrawnStroke stroke)
    {
        Vec3 const off(hand_.between(-0.008, 0.008), hand_.between(-0.008, 0.008), 0);
        for (auto& point : stroke.points)
            point += height_mm_ * off;
        return stroke;
    }

    // Arranges the strokes in the order in which they are drawn. A correction comes after the
    // stroke that it corrects.
    void arrange(DrawnSketch& sketch, std::vector<DrawnStroke> stem,
                 std::vector<std::vector<DrawnStroke>> rest)
    {
        std::vector<std::vector<DrawnStroke>> corrections;
        if (has(Habit::BoundaryPart)) { // The correction comes after both boundaries.
            corrections.push_back(rest[2]);
            rest.erase(rest.begin() + 2);
        }
        if (has(Habit::Restated)) {
            corrections.push_back(rest.back());
            rest.pop_back();
        }
        hand_.shuffle(rest);
        if (has(Habit::AnyOrder))
            rest.insert(rest.begin() + 1 + static_cast<std::ptrdiff_t>(hand_.below(rest.size())),
                        stem);
        // The stem is redrawn last, when the illustrator sees it with the other lines.
        else if (has(Habit::StemRedrawn)) {
            rest.insert(rest.begin(), { stem[0] });
            rest.push_back({ stem[1] });
        } else
            rest.insert(rest.begin(), stem);
        rest.insert(rest.end(), corrections.begin(), corrections.end());
        for (auto const& group : rest)
            sketch.strokes.insert(sketch.strokes.end(), group.begin(), group.end());
    }

    void finish(DrawnStroke& stroke)
    {
        bool const is_stem = stroke.role == Role::Stem;
        if (has(Habit::Overshoot) && !is_stem && stroke.role != Role::Outline)
            overshoot(stroke.points);
        if (is_stem ? has(Habit::TipToBase) : hand_.chance(0.5))
            std::reverse(stroke.points.begin(), stroke.points.end());
        stroke.points = hand_.draw(stroke.points, tremor_mm_);
        if (has(Habit::Hooks))
            hand_.add_hooks(stroke.points, 0.5, std::min(3.0, 0.05 * height_mm_));
    }

    void overshoot(std::vector<Vec3>& line)
    {
        for (int end = 0; end < 2; ++end) {
            Vec3 const way = (line.back() - line[line.size() - 6]).normalized();
            line.push_back(line.back() + hand_.between(0, 0.03) * height_mm_ * way);
            std::reverse(line.begin(), line.end());
        }
    }

    static void mirror(DrawnSketch& sketch)
    {
        auto const mirror_role = [](Role role) {
            if (role == Role::Left)
                return Role::Right;
            return role == Role::Right ? Role::Left : role;
        };
        for (auto& stroke : sketch.strokes) {
            stroke.role = mirror_role(stroke.role);
            for (auto& point : stroke.points)
                point.x() = -point.x();
        }
        for (auto& point : sketch.meant.stem)
            point.x() = -point.x();
        std::swap(sketch.meant.left, sketch.meant.right);
        for (auto* const line : { &sketch.meant.left, &sketch.meant.right })
            for (auto& point : *line)
                point.x() = -point.x();
        for (auto& line : sketch.meant.inclinations)
            for (auto& point : line)
                point.x() = -point.x();
    }

    Hand hand_;
    std::vector<Habit> habits_;
    double height_mm_;
    double tremor_mm_;
    double bow_ = 0;
    double tilt_ = 0;
    double wide_left_ = 0;
    double wide_right_ = 0;
    double closing_ = 0;
    double from_ = 0;
    double to_ = 1;
    bool is_mirrored_ = false;
};

} // namespace tractus::lines
