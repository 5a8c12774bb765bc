#include "engine/methods/construction_lines/explain_sketch.h"

#include "engine/methods/construction_lines/assemble_sketch.h"
#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/hand_line.h"
#include "engine/methods/construction_lines/stem_candidates.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::lines {

namespace {

// Number of points to which each stroke is resampled before it is interpreted.
constexpr std::size_t kComparedPoints = 60;
constexpr double kCorrectionCost = 0.2;

DrawnLine resampled_line(Polyline const& line)
{
    std::vector<Vec2> points;
    for (auto const& point : resample(line, kComparedPoints))
        points.emplace_back(point.head<2>());
    auto distinct = without_repeats(points);
    if (distinct.size() < 2)
        distinct = { line.front().head<2>(), line.back().head<2>() };
    return DrawnLine(std::move(distinct));
}

Part part_of(Role role)
{
    switch (role) {
    case Role::Stem:
        return Part::Stem;
    case Role::Left:
        return Part::Left;
    case Role::Right:
        return Part::Right;
    case Role::Inclination:
        return Part::Inclination;
    case Role::HalfInclination:
        return Part::Half;
    case Role::Outline:
        return Part::Outline;
    case Role::Unsure:
    case Role::Around: // A boundary in space is not a line on the sheet.
        break;
    }
    return Part::Nothing;
}

// A reading of the sketch for a given stem: it assigns a Part to each stroke.
class SketchReading {
public:
    SketchReading(std::span<Polyline const> lines, std::span<StrokeToExplain const> strokes,
                  StemCandidate const& stem)
        : lines_(lines)
        , strokes_(strokes)
        , stem_(stem)
        , axis_(resample(stem.line, kComparedPoints))
        , parts_(lines.size(), Part::Nothing)
    {
        for (auto const& line : lines)
            lies_.push_back(position_along_axis(resampled_line(line), axis_));
        for (auto const& lie : lies_)
            alone_.push_back(part_costs(lie, axis_.length_mm()));
        for (std::size_t i = 0; i < lines.size(); ++i)
            settle_known(i);
        junctions_.resize(lines.size() * lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                junctions_[i * lines.size() + k] = junctions_[k * lines.size() + i]
                    = junction_of(lines[i], lines[k], 0.08 * axis_.length_mm()).quality;
    }

    // Chooses the cheapest Part for one stroke after another, repeatedly, until no stroke changes,
    // at most kMaxPasses times.
    void settle()
    {
        constexpr int kMaxPasses = 6;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            parts_[i] = cheapest(i, false);
        for (int round = 0; round < kMaxPasses; ++round) {
            auto const before = parts_;
            for (std::size_t i = 0; i < parts_.size(); ++i)
                parts_[i] = cheapest(i, true);
            if (parts_ == before)
                break;
        }
    }

    double cost() const
    {
        double sum = stem_.cost;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            sum += cost_of(i, parts_[i], true);
        return sum + missing_cost();
    }

    std::vector<Part> const& parts() const { return parts_; }
    StemAxis const& axis() const { return axis_; }

    // Finds the most likely alternative: the stroke, and the new Part for it, that increase the
    // cost least.
    std::optional<std::pair<std::size_t, Part>> second_best_roles() const
    {
        std::optional<std::pair<std::size_t, Part>> best;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (is_stem(i) || strokes_[i].assigned)
                continue;
            for (std::size_t part = 0; part < kPartCount; ++part) {
                if (static_cast<Part>(part) == parts_[i])
                    continue;
                double const more
                    = cost_of(i, static_cast<Part>(part), true) - cost_of(i, parts_[i], true);
                if (more < least) {
                    least = more;
                    best = { i, static_cast<Part>(part) };
                }
            }
        }
        return best;
    }
    void set(std::size_t stroke, Part part) { parts_[stroke] = part; }

private:
    bool is_stem(std::size_t i) const
    {
        return std::find(stem_.strokes.begin(), stem_.strokes.end(), i) != stem_.strokes.end();
    }

    // Leaves only one possible Part for a stroke of the stem, or whose role the user has set.
    void settle_known(std::size_t i)
    {
        auto const only = [&](Part part) {
            alone_[i].fill(kImpossible);
            alone_[i][static_cast<std::size_t>(part)] = 0;
        };
        if (is_stem(i))
            only(Part::Stem);
        else if (strokes_[i].assigned)
            only(part_of(*strokes_[i].assigned));
    }

    double junction(std::size_t i, std::size_t k) const
    {
        return junctions_[i * lines_.size() + k];
    }

    // Cost of reading a stroke as a boundary on this side in view of the side's other boundaries: 0
    // if there is none, negative if the stroke continues one, positive if it overlaps one.
    double beside_others(std::size_t i, Part side) const
    {
        double best_junction = 0;
        double clash = 0;
        // A stroke that corrects part of a boundary usually leaves the boundary and meets it again;
        // a loose stroke does neither.
        bool is_loose = false;
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            if (k == i)
                continue;
            if (parts_[k] == side)
                best_junction = std::max(best_junction, junction(i, k));
            if (parts_[k] == side || parts_[k] == Part::Outline) {
                double const overlap = std::min(lies_[i].highest, lies_[k].highest)
                    - std::max(lies_[i].lowest, lies_[k].lowest);
                clash = std::max(clash, overlap);
                double const range = lies_[i].highest - lies_[i].lowest;
                is_loose = is_loose
                    || (range < 0.5 * (lies_[k].highest - lies_[k].lowest) && overlap > 0.7 * range
                        && !meets(lies_[i].first(), lies_[k]) && !meets(lies_[i].last(), lies_[k]));
            }
        }
        // A second boundary on one side is less likely if its stroke does not look like a
        // correction of the first.
        return 0.35 * std::clamp(clash / 0.5, 0.0, 1.0) + (is_loose ? 0.8 : 0)
            - (0.8 + 2 * small_piece(lies_[i])) * best_junction;
    }

    static bool meets(StemAxis::Place const& end, StrokePosition const& line)
    {
        constexpr double kNear = 0.08;
        return std::any_of(line.places.begin(), line.places.end(), [&](StemAxis::Place const& at) {
            return std::hypot(at.along - end.along, at.beside - end.beside) < kNear;
        });
    }

    double other_half(std::size_t i) const
    {
        auto const foot = [&](std::size_t k) {
            auto const& lie = lies_[k];
            return std::fabs(lie.first().beside) < std::fabs(lie.last().beside) ? lie.first()
                                                                                : lie.last();
        };
        for (std::size_t k = 0; k < parts_.size(); ++k)
            if (k != i && parts_[k] == Part::Half
                && (lies_[i].left_share > 0.5) != (lies_[k].left_share > 0.5)
                && std::fabs(foot(i).along - foot(k).along) < 0.1)
                return -0.15;
        return 0;
    }

    // Cost of reading a stroke as Part::Piece: as the continuation of an inclination line, or of
    // half of one, at an end.
    double piece_cost(std::size_t i) const
    {
        double best = 0;
        for (std::size_t k = 0; k < parts_.size(); ++k)
            if (k != i && (parts_[k] == Part::Inclination || parts_[k] == Part::Half))
                best = std::max(best, junction(i, k));
        return best > 0 ? 0.25 + 1.3 * (1 - best) : kImpossible;
    }

    double cost_of(std::size_t i, Part part, bool with_others) const
    {
        if (strokes_[i].assigned && alone_[i][static_cast<std::size_t>(part)] == 0)
            return 0;
        if (part == Part::Piece)
            return with_others && !is_stem(i) && !strokes_[i].assigned ? piece_cost(i)
                                                                       : kImpossible;
        double cost = alone_[i][static_cast<std::size_t>(part)];
        if (!with_others)
            return cost;
        if (part == Part::Left || part == Part::Right)
            cost += beside_others(i, part);
        if (part == Part::Half)
            cost += other_half(i);
        return cost;
    }

    Part cheapest(std::size_t i, bool with_others) const
    {
        auto best = Part::Nothing;
        double least = cost_of(i, Part::Nothing, with_others);
        for (std::size_t part = 0; part < kPartCount; ++part) {
            double const cost = cost_of(i, static_cast<Part>(part), with_others);
            if (cost < least) {
                least = cost;
                best = static_cast<Part>(part);
            }
        }
        return best;
    }

    // Cost of missing boundaries; a complete sketch has boundaries on both sides of the stem.
    double missing_cost() const
    {
        auto const has = [&](Part part) {
            return std::find(parts_.begin(), parts_.end(), part) != parts_.end();
        };
        if (has(Part::Outline) || (has(Part::Left) && has(Part::Right)))
            return 0;
        return has(Part::Left) || has(Part::Right) ? 0.3 : 0.5;
    }

    std::span<Polyline const> lines_;
    std::span<StrokeToExplain const> strokes_;
    StemCandidate const& stem_;
    StemAxis axis_;
    std::vector<StrokePosition> lies_;
    std::vector<PartCosts> alone_;
    std::vector<double> junctions_;
    std::vector<Part> parts_;
};

Polyline cleaned(StrokeToExplain const& stroke)
{
    if (stroke.is_clean)
        return stroke.points;
    if (!stroke.is_by_hand || is_drawn_by_hand(stroke.points))
        return clean_hand_line(stroke.points);
    auto line = without_repeats(capture_line(stroke.points));
    return line.size() < 2 ? stroke.points : line;
}

struct Read {
    StemCandidate stem;
    std::vector<Part> parts;
    double cost = 0;
};

// Lean of the inclination lines, positive towards the stem's top: the sum of the cosines of the
// angles between their halves and the stem, divided by the square root of the number of halves. 0
// without inclination lines.
double leaning(std::span<Polyline const> lines, Read const& read, StemAxis const& axis)
{
    double sum = 0;
    int halves = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (read.parts[i] != Part::Inclination && read.parts[i] != Part::Half)
            continue;
        auto const foot
            = std::min_element(lines[i].begin(), lines[i].end(), [&](Vec3 const& a, Vec3 const& b) {
                  return std::fabs(axis.place(a.head<2>()).beside)
                      < std::fabs(axis.place(b.head<2>()).beside);
              });
        Vec2 const tangent = axis.tangent(axis.place(foot->head<2>()).along);
        for (auto const& end : { lines[i].front(), lines[i].back() }) {
            Vec2 const way = (end - *foot).head<2>();
            if (way.norm() < 0.03 * axis.length_mm())
                continue;
            sum += tangent.dot(way) / way.norm();
            ++halves;
        }
    }
    return halves > 0 ? sum / std::sqrt(halves) : 0;
}

// True if the stem was probably drawn from its top to its foot. A stem is assumed to grow upwards
// unless its inclination lines lean the other way.
bool is_upside_down(std::span<Polyline const> lines, Read const& read, StemAxis const& axis)
{
    constexpr double kLeaningCounts = 0.8;
    Vec2 const chord = (read.stem.line.back() - read.stem.line.front()).head<2>();
    double const up = chord.y() / std::max(chord.norm(), 1e-9);
    double const score = up + kLeaningCounts * leaning(lines, read, axis);
    return score < -0.05;
}

Read read_with(std::span<Polyline const> lines, std::span<StrokeToExplain const> strokes,
               StemCandidate stem)
{
    Read read { .stem = std::move(stem), .parts = {} };
    auto const settle = [&] {
        SketchReading reading(lines, strokes, read.stem);
        reading.settle();
        read.parts = reading.parts();
        read.cost = reading.cost();
        return is_upside_down(lines, read, reading.axis());
    };
    bool const is_turned_by_hand
        = std::any_of(read.stem.strokes.begin(), read.stem.strokes.end(),
                      [&](std::size_t stroke) { return strokes[stroke].turn_round; });
    if (settle() != is_turned_by_hand) {
        std::reverse(read.stem.line.begin(), read.stem.line.end());
        settle();
    }
    auto corrected = corrected_stem(read.stem, lines, read.parts);
    if (corrected.strokes.size() == read.stem.strokes.size())
        return read;
    // The other strokes are interpreted again, because they were drawn for the corrected stem.
    StemCandidate const whole { corrected.strokes, std::move(corrected.line), read.stem.cost };
    SketchReading reading(lines, strokes, whole);
    reading.settle();
    read.parts = reading.parts();
    read.cost = reading.cost()
        + kCorrectionCost
            * static_cast<double>(corrected.strokes.size() - read.stem.strokes.size());
    return read;
}

// Returns the cheapest reading in which exactly one stroke has another Part than in `read`.
std::optional<Read> second_best_roles(std::span<Polyline const> lines,
                                      std::span<StrokeToExplain const> strokes, Read const& read)
{
    SketchReading reading(lines, strokes, read.stem);
    for (std::size_t i = 0; i < read.parts.size(); ++i)
        reading.set(i, read.parts[i]);
    auto const thought = reading.second_best_roles();
    if (!thought)
        return std::nullopt;
    reading.set(thought->first, thought->second);
    auto second = read;
    second.parts = reading.parts();
    second.cost = reading.cost();
    return second;
}

} // namespace

std::vector<Explanation> explain_sketch(std::span<StrokeToExplain const> strokes)
{
    std::vector<Polyline> lines;
    for (auto const& stroke : strokes)
        lines.push_back(cleaned(stroke));
    std::vector<Read> reads;
    for (auto& candidate : stem_candidates(lines, strokes))
        reads.push_back(read_with(lines, strokes, std::move(candidate)));
    std::stable_sort(reads.begin(), reads.end(),
                     [](Read const& a, Read const& b) { return a.cost < b.cost; });
    if (auto second = second_best_roles(lines, strokes, reads.front()))
        if (reads.size() < 2 || second->cost < reads[1].cost)
            reads.insert(reads.begin() + 1, *std::move(second));
    reads.resize(std::min<std::size_t>(reads.size(), 2));
    std::vector<Explanation> result;
    for (auto const& read : reads) {
        result.push_back(assemble_sketch(lines, strokes, read.stem, read.parts));
        result.back().cost = read.cost;
    }
    return result;
}

} // namespace tractus::lines
