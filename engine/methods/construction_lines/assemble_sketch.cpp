#include "engine/methods/construction_lines/assemble_sketch.h"

#include "engine/methods/construction_lines/hand_line.h"
#include "engine/methods/construction_lines/lie_to_stem.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace tractus::lines {

namespace {

std::vector<Vec2> on_paper(Polyline const& line)
{
    std::vector<Vec2> points;
    for (auto const& point : line)
        points.emplace_back(point.head<2>());
    return points;
}

// A line composed of one or more strokes.
struct MadeLine {
    Polyline line;
    std::vector<std::size_t> strokes; // Indices of the strokes of the line, in drawing order.
};

// The part of a composed line that one stroke contributes.
struct Drawn {
    std::size_t stroke = 0;
    Polyline line;
};

// An inclination line from its left end to its right end, or one half of it from the stem outwards.
struct Across {
    enum class Reach { Both, Left, Right };
    Reach reach = Reach::Both;
    double at = 0; // Position of the crossing with the stem, as a share of the stem's length.
    MadeLine made;
};

// Returns the part of a stroke, drawn around the top of the stem, that lies on one side of the stem
// (1: left, -1: right): the longest run of consecutive points on that side.
Polyline run_on_side(Polyline points, StemAxis const& axis, double side)
{
    // Largest gap between the ends of a closed stroke, as a share of its length.
    constexpr double kClosed = 0.15;
    auto const is_there
        = [&](Vec3 const& point) { return axis.place(point.head<2>()).beside * side > 0; };
    bool const is_closed
        = (points.front() - points.back()).norm() < kClosed * polyline_length_mm(points);
    // A closed stroke is made to begin on the other side, so that its ends do not divide a run.
    if (is_closed) {
        auto const other = std::find_if_not(points.begin(), points.end(), is_there);
        std::rotate(points.begin(), other, points.end());
    }
    Polyline best;
    Polyline run;
    for (std::size_t i = 0; i <= points.size(); ++i) {
        if (i < points.size() && is_there(points[i])) {
            run.push_back(points[i]);
            continue;
        }
        if (run.size() >= 2 && (best.empty() || polyline_length_mm(run) > polyline_length_mm(best)))
            best = run;
        run.clear();
    }
    return best;
}

// Removes the ends of a boundary that reach across the stem.
Polyline on_side(Polyline const& line, StemAxis const& axis, double side)
{
    auto const is_over
        = [&](Vec3 const& point) { return axis.place(point.head<2>()).beside * side <= 0; };
    auto const first = std::find_if_not(line.begin(), line.end(), is_over);
    auto const last = std::find_if_not(line.rbegin(), line.rend(), is_over).base();
    return last - first >= 2 ? Polyline(first, last) : line;
}

class Assembly {
public:
    Assembly(std::span<Polyline const> lines, std::span<StrokeToExplain const> strokes,
             StemCandidate const& stem, std::span<Part const> parts)
        : lines_(lines)
        , strokes_(strokes)
        , parts_(parts)
        , candidate_(stem)
        , axis_(resample(stem.line, kAxisPoints))
    {
        result_.strokes.resize(lines.size());
    }

    Explanation assemble()
    {
        make_stem();
        make_side(Part::Left, 1, result_.sketch.left);
        make_side(Part::Right, -1, result_.sketch.right);
        make_inclinations();
        for (std::size_t i = 0; i < parts_.size(); ++i)
            name(i);
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (strokes_[i].assigned == Role::Around)
                result_.sketch.around.push_back(lines_[i]);
        check_lines();
        return std::move(result_);
    }

private:
    static constexpr std::size_t kAxisPoints = 120;

    // Composes a line of several strokes, each drawn over the ones before it.
    MadeLine made_of(std::vector<Drawn> const& drawn)
    {
        MadeLine made { .line = drawn.front().line, .strokes = { drawn.front().stroke } };
        for (std::size_t i = 1; i < drawn.size(); ++i) {
            auto const over = merge_correction(made.line, drawn[i].line, axis_);
            if (over.size() == without_repeats(drawn[i].line).size())
                for (auto const stroke : made.strokes)
                    result_.strokes[stroke].is_replaced = true;
            made.line = over;
            made.strokes.push_back(drawn[i].stroke);
        }
        for (std::size_t i = 1; i < made.strokes.size(); ++i)
            result_.strokes[made.strokes[i]].of = made.strokes[0];
        return made;
    }

    void make_stem()
    {
        auto made = corrected_stem(candidate_, lines_, parts_);
        for (auto const stroke : made.replaced)
            result_.strokes[stroke].is_replaced = true;
        auto const first = *std::min_element(made.strokes.begin(), made.strokes.end());
        for (auto const stroke : made.strokes)
            if (stroke != first)
                result_.strokes[stroke].of = first;
        auto const& newest = lines_[made.strokes.back()];
        result_.strokes[first].is_drawn_reversed = axis_.place(newest.back().head<2>()).along
            < axis_.place(newest.front().head<2>()).along;
        axis_ = StemAxis(resample(made.line, kAxisPoints));
        result_.sketch.stem = std::move(made.line);
    }

    void make_side(Part part, double side, std::vector<Vec2>& boundary)
    {
        std::vector<Drawn> drawn;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (parts_[i] == part)
                drawn.push_back({ i, rising(lines_[i], axis_) });
            if (parts_[i] != Part::Outline)
                continue;
            auto const run = run_on_side(lines_[i], axis_, side);
            if (run.size() >= 2)
                drawn.push_back({ i, rising(run, axis_) });
        }
        if (!drawn.empty())
            boundary = on_paper(on_side(made_of(drawn).line, axis_, side));
    }

    // Returns the position on the stem where a line is nearest to it, as a share of the stem's
    // length.
    double at_stem(Polyline const& line) const
    {
        auto const foot
            = std::min_element(line.begin(), line.end(), [&](Vec3 const& a, Vec3 const& b) {
                  return std::fabs(axis_.place(a.head<2>()).beside)
                      < std::fabs(axis_.place(b.head<2>()).beside);
              });
        return axis_.place(foot->head<2>()).along;
    }

    double beside(Vec3 const& point) const { return axis_.place(point.head<2>()).beside; }

    Across across_of(std::size_t stroke) const
    {
        Across across { .made = { .line = lines_[stroke], .strokes = { stroke } } };
        auto& line = across.made.line;
        if (parts_[stroke] == Part::Inclination) {
            if (beside(line.front()) < beside(line.back()))
                std::reverse(line.begin(), line.end());
            across.at = at_stem(line);
            return across;
        }
        if (std::fabs(beside(line.front())) > std::fabs(beside(line.back())))
            std::reverse(line.begin(), line.end());
        double const side = beside(line.back()) > 0 ? 1 : -1;
        across.reach = side > 0 ? Across::Reach::Left : Across::Reach::Right;
        auto const outside = std::find_if(line.begin(), line.end() - 2, [&](Vec3 const& point) {
            return beside(point) * side > 0;
        });
        line.erase(line.begin(), outside);
        across.at = foot_of(line);
        return across;
    }

    // Returns the position on the stem at which a half line would begin if it were extended to the
    // stem; half lines may begin beside the stem.
    double foot_of(Polyline const& half) const
    {
        auto const near = axis_.place(half.front().head<2>());
        Vec2 const way = start_direction(half);
        Vec2 const tangent = axis_.tangent(near.along);
        double const out = std::fabs(cross(tangent, way));
        double const gap = std::fabs(near.beside);
        double const foot = near.along - gap * tangent.dot(way) / std::max(out, 0.3);
        return std::clamp(foot, 0.0, 1.0);
    }

    static bool is_half(Across const& across) { return across.reach != Across::Reach::Both; }

    // True if two inclination lines are so close that the second is the first one drawn again.
    bool are_same(Across const& a, Across const& b) const
    {
        // Tolerance for lines drawn again: this share of the line's length, plus half a millimetre.
        constexpr double kApart = 0.05;
        if (a.reach != b.reach)
            return false;
        double const most_mm = kApart * polyline_length_mm(b.made.line) + 0.5;
        auto const are_near = [&](Vec3 const& one, Vec3 const& other) {
            return (one - other).head<2>().norm() < most_mm;
        };
        return std::fabs(a.at - b.at) * axis_.length_mm() < most_mm
            && are_near(a.made.line.back(), b.made.line.back())
            && are_near(a.made.line.front(), b.made.line.front());
    }

    void add_stroke(std::vector<Across>& all, std::size_t stroke)
    {
        auto across = across_of(stroke);
        for (auto& other : all) {
            if (!are_same(across, other))
                continue;
            for (auto const earlier : other.made.strokes)
                result_.strokes[earlier].is_replaced = true;
            result_.strokes[stroke].of = other.made.strokes.front();
            across.made.strokes = other.made.strokes;
            across.made.strokes.push_back(stroke);
            other = std::move(across);
            return;
        }
        all.push_back(std::move(across));
    }

    void add_piece(std::vector<Across>& all, std::size_t stroke)
    {
        Across* nearest = nullptr;
        Junction best;
        for (auto& other : all) {
            auto const junction
                = junction_of(other.made.line, lines_[stroke], 0.08 * axis_.length_mm());
            if (junction.quality > best.quality) {
                best = junction;
                nearest = &other;
            }
        }
        if (!nearest)
            return;
        nearest->made.line = joined(nearest->made.line, lines_[stroke], best);
        nearest->made.strokes.push_back(stroke);
        result_.strokes[stroke].of = nearest->made.strokes.front();
        pieces_.push_back(
            { stroke, is_half(*nearest) ? Role::HalfInclination : Role::Inclination });
    }

    void make_inclinations()
    {
        std::vector<Across> all;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (parts_[i] == Part::Inclination || parts_[i] == Part::Half)
                add_stroke(all, i);
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (parts_[i] == Part::Piece)
                add_piece(all, i);
        bring_together(all);
    }

    // Finds, among `all`, the half line on the other side of the stem that complements the half
    // line `across`. If `across` is a whole line, finds a half line that replaces one half of it.
    static std::vector<Across>::iterator nearest_half(std::vector<Across>& all,
                                                      Across const& across)
    {
        constexpr double kSamePlace = 0.1;
        auto nearest = all.end();
        double least = is_half(across) ? kSamePlace : kSamePlace / 3;
        for (auto each = all.begin(); each != all.end(); ++each) {
            double const off = std::fabs(each->at - across.at);
            if (!is_half(*each) || each->reach == across.reach || off > least)
                continue;
            least = off;
            nearest = each;
        }
        return nearest;
    }

    // Joins half lines that begin near the same position on opposite sides of the stem. A half line
    // drawn where a whole line exists replaces that half of it.
    void bring_together(std::vector<Across> all)
    {
        while (!all.empty()) {
            auto across = std::move(all.front());
            all.erase(all.begin());
            auto const other = nearest_half(all, across);
            if (other == all.end()) {
                put(across, is_half(across) ? from_stem(across) : whole(across));
                continue;
            }
            bool const is_left = other->reach == Across::Reach::Left;
            auto half = other->made.line;
            auto rest = is_half(across)
                ? across.made.line
                : half_of(across.made.line, is_left ? Across::Reach::Right : Across::Reach::Left);
            auto& left = is_left ? half : rest;
            auto& right = is_left ? rest : half;
            Polyline line(left.rbegin(), left.rend());
            // The two halves begin at slightly different places on the stem, because the hand is
            // not exact.
            if (is_half(across))
                across.at = (across.at + other->at) / 2;
            Vec2 const foot = axis_.point(across.at);
            line.emplace_back(foot.x(), foot.y(), 0);
            line.insert(line.end(), right.begin(), right.end());
            if (!is_half(across))
                result_.strokes[other->made.strokes.front()].of = across.made.strokes.front();
            put(across, line);
            all.erase(other);
        }
    }

    // Returns one half of an inclination line, ordered from the stem outwards.
    Polyline half_of(Polyline const& line, Across::Reach reach) const
    {
        double const side = reach == Across::Reach::Left ? 1 : -1;
        Polyline half;
        for (auto const& point : line)
            if (beside(point) * side > 0)
                half.push_back(point);
        if (side > 0)
            std::reverse(half.begin(), half.end());
        return half;
    }

    // Makes an inclination line cross the stem only once. If it crosses several times, its points
    // on the left come first, then those on the right.
    Polyline whole(Across const& across) const
    {
        int changes = 0;
        double side = 0;
        for (auto const& point : across.made.line) {
            double const now = beside(point);
            changes += side * now < 0 ? 1 : 0;
            side = now == 0 ? side : now;
        }
        if (changes < 2)
            return across.made.line;
        auto const left = half_of(across.made.line, Across::Reach::Left);
        auto const right = half_of(across.made.line, Across::Reach::Right);
        Polyline line(left.rbegin(), left.rend());
        line.insert(line.end(), right.begin(), right.end());
        return line;
    }

    // Extends a half line slightly beyond the stem, so that it crosses the stem.
    Polyline from_stem(Across const& half) const
    {
        double const side = half.reach == Across::Reach::Left ? 1 : -1;
        Vec2 const tangent = axis_.tangent(half.at);
        Vec2 const left(-tangent.y(), tangent.x());
        Vec2 const over = axis_.point(half.at) - side * (kMinHalf / 2) * axis_.length_mm() * left;
        Polyline line { Vec3(over.x(), over.y(), 0) };
        line.insert(line.end(), half.made.line.begin(), half.made.line.end());
        return line;
    }

    // Adds an inclination line to the sketch. A line that passes just above the stem's top or just
    // below its foot is moved onto the stem.
    void put(Across const& across, Polyline line)
    {
        double const off = across.at - std::clamp(across.at, 0.002, 0.998);
        Vec2 const shift = -off * axis_.length_mm() * axis_.tangent(across.at);
        for (auto& point : line)
            point.head<2>() += shift;
        result_.sketch.inclinations.push_back(without_repeats(on_paper(line)));
        result_.inclination_strokes.push_back(across.made.strokes.front());
        across_.push_back(across.made.strokes);
    }

    void name(std::size_t i)
    {
        constexpr std::array kRoles {
            Role::Stem,    Role::Left,   Role::Right, Role::Inclination, Role::HalfInclination,
            Role::Outline, Role::Unsure, Role::Unsure
        };
        auto& stroke = result_.strokes[i];
        stroke.role = kRoles[static_cast<std::size_t>(parts_[i])];
        for (auto const& [piece, role] : pieces_)
            if (piece == i)
                stroke.role = role;
        if (strokes_[i].assigned == Role::Around)
            stroke.role = Role::Around;
        if (stroke.role == Role::Unsure)
            stroke.reason = strokes_[i].assigned == Role::Unsure
                ? "somebody has said that it is no line of the sketch"
                : explain_no_role(lie_of(DrawnLine(on_paper(lines_[i])),
                                         DrawnLine(on_paper(result_.sketch.stem))));
    }

    // Explains why the sketch gives no plant if the inclination line with the index `without` is
    // left out; empty if it gives one.
    std::string refusal(std::optional<std::size_t> without) const
    {
        auto tried = result_.sketch;
        if (without)
            tried.inclinations.erase(tried.inclinations.begin()
                                     + static_cast<std::ptrdiff_t>(*without));
        tried.nodes_above.assign(std::max<std::size_t>(1, tried.inclinations.size()), 1);
        auto const measured = measure_sketch(tried, Missing::Guessed);
        return measured ? "" : measured.error().message;
    }

    void leave_out(std::size_t line, std::string const& reason)
    {
        for (auto const stroke : across_[line])
            result_.strokes[stroke] = { .role = Role::Unsure, .reason = reason };
        auto const at = static_cast<std::ptrdiff_t>(line);
        result_.sketch.inclinations.erase(result_.sketch.inclinations.begin() + at);
        result_.inclination_strokes.erase(result_.inclination_strokes.begin() + at);
        across_.erase(across_.begin() + at);
    }

    void leave_out(Part part, std::vector<Vec2>& boundary, std::string const& reason)
    {
        boundary.clear();
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (parts_[i] == part)
                result_.strokes[i] = { .role = Role::Unsure, .reason = reason };
    }

    // Leaves out lines until the sketch gives a plant: an inclination line without which it gives
    // one, or else the last inclination line. Once no inclination line is left, boundaries are left
    // out.
    void check_lines()
    {
        auto& sketch = result_.sketch;
        while (true) {
            auto const reason = refusal(std::nullopt);
            if (reason.empty())
                return;
            if (sketch.inclinations.empty()) {
                leave_out(Part::Left, sketch.left, reason);
                leave_out(Part::Right, sketch.right, reason);
                leave_out(Part::Outline, sketch.left, reason);
                return;
            }
            std::size_t line = sketch.inclinations.size() - 1;
            for (std::size_t i = 0; i < sketch.inclinations.size(); ++i)
                if (refusal(i).empty())
                    line = i;
            leave_out(line, reason);
        }
    }

    std::span<Polyline const> lines_;
    std::span<StrokeToExplain const> strokes_;
    std::span<Part const> parts_;
    StemCandidate const& candidate_;
    StemAxis axis_;
    Explanation result_ { .strokes = {} };
    std::vector<std::pair<std::size_t, Role>> pieces_;
    // For each inclination line of the sketch, the indices of its strokes.
    std::vector<std::vector<std::size_t>> across_;
};

} // namespace

Explanation assemble_sketch(std::span<Polyline const> lines,
                            std::span<StrokeToExplain const> strokes, StemCandidate const& stem,
                            std::span<Part const> parts)
{
    return Assembly(lines, strokes, stem, parts).assemble();
}

} // namespace tractus::lines
