#include "engine/methods/construction_lines/join_lines.h"

#include "engine/methods/construction_lines/hand_line.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cmath>

namespace tractus::lines {

namespace {

std::vector<Vec2> on_sheet(Polyline const& line)
{
    std::vector<Vec2> points;
    for (auto const& point : line)
        points.emplace_back(point.head<2>());
    return points;
}

Polyline backwards(Polyline const& line)
{
    return { line.rbegin(), line.rend() };
}

// part_before() returns the part of the line up to an arc length measured on the sheet; part_from()
// returns the rest.
Polyline part_before(Polyline const& line, DrawnLine const& seen, double at_mm)
{
    auto const place = seen.place(at_mm);
    Polyline part(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(place.piece) + 1);
    part.push_back(line[place.piece] + place.share * (line[place.piece + 1] - line[place.piece]));
    return part;
}

Polyline part_from(Polyline const& line, DrawnLine const& seen, double at_mm)
{
    return backwards(part_before(backwards(line), DrawnLine(on_sheet(backwards(line))),
                                 seen.length_mm() - at_mm));
}

struct Range {
    double low = 0;
    double high = 0;
};

Range range_of(Polyline const& line, StemAxis const& axis)
{
    Range range { axis.place(line.front().head<2>()).along,
                  axis.place(line.front().head<2>()).along };
    for (auto const& point : line) {
        double const along = axis.place(point.head<2>()).along;
        range.low = std::min(range.low, along);
        range.high = std::max(range.high, along);
    }
    return range;
}

} // namespace

Junction junction_of(Polyline const& first, Polyline const& second, double most_gap_mm)
{
    constexpr double kMaxTurn_deg = 45;
    Junction best;
    for (bool const end_of_first : { true, false })
        for (bool const end_of_second : { true, false }) {
            auto const one = end_of_first ? backwards(first) : first;
            auto const other = end_of_second ? backwards(second) : second;
            Vec2 const gap = (other.front() - one.front()).head<2>();
            // The direction in which the first line would continue.
            Vec2 const way = -start_direction(one);
            Vec2 const on = start_direction(other);
            double const turn_deg = degrees(std::acos(std::clamp(way.dot(on), -1.0, 1.0)));
            // A sideways offset costs extra: pieces of one line may overlap or leave a gap, but
            // lines side by side are separate lines.
            double const aside_mm = std::fabs(cross(way, gap));
            double const quality = 1 - std::hypot(gap.norm() / most_gap_mm, turn_deg / kMaxTurn_deg)
                - 0.5 * aside_mm / most_gap_mm;
            if (quality > best.quality)
                best = { quality, end_of_first, end_of_second };
        }
    return best;
}

Polyline joined(Polyline const& first, Polyline const& second, Junction const& at)
{
    // If the lines overlap, the first is cut where the second begins beside it.
    auto const head = at.at_end_of_first ? first : backwards(first);
    auto const tail = at.at_end_of_second ? backwards(second) : second;
    DrawnLine const seen(on_sheet(head));
    double const from_mm = seen.nearest_mm(tail.front().head<2>());
    auto line = part_before(head, seen, std::max(from_mm, 0.5 * seen.length_mm()));
    line.insert(line.end(), tail.begin(), tail.end());
    line = without_repeats(line);
    return at.at_end_of_first ? line : backwards(line);
}

Polyline rising(Polyline line, StemAxis const& axis)
{
    double const climb
        = axis.place(line.back().head<2>()).along - axis.place(line.front().head<2>()).along;
    if (climb < 0)
        std::reverse(line.begin(), line.end());
    return line;
}

Polyline merge_correction(Polyline const& line, Polyline const& over, StemAxis const& axis)
{
    // Two lines are pieces of one line if their overlap along the axis is below this share of the
    // shorter line.
    constexpr double kSmallOverlap = 0.35;
    // An end of the old line that the correction does not meet is dropped, unless it extends beyond
    // the correction by more than this, in stem lengths.
    constexpr double kRestatedShare = 0.2;
    double const meets_mm = std::max(0.04 * axis.length_mm(), 2.5);
    auto const old = range_of(line, axis);
    auto const now = range_of(over, axis);
    double const overlap = std::min(old.high, now.high) - std::max(old.low, now.low);
    double const shorter = std::min(old.high - old.low, now.high - now.low);
    bool const are_pieces = overlap < kSmallOverlap * shorter;
    DrawnLine const seen(on_sheet(line));
    double const from_mm = seen.nearest_mm(over.front().head<2>());
    double const to_mm = std::max(from_mm, seen.nearest_mm(over.back().head<2>()));
    auto const is_near = [&](Vec3 const& end, double at_mm) {
        return (seen.point(at_mm) - end.head<2>()).norm() <= meets_mm;
    };
    auto const stays = [&](double left, double left_mm, Vec3 const& end, double at_mm) {
        if (left_mm <= 0 || left <= 0.01)
            return false;
        return are_pieces || is_near(end, at_mm) || left > kRestatedShare;
    };
    Polyline result;
    if (stays(now.low - old.low, from_mm, over.front(), from_mm))
        result = part_before(line, seen, from_mm);
    result.insert(result.end(), over.begin(), over.end());
    if (stays(old.high - now.high, seen.length_mm() - to_mm, over.back(), to_mm)) {
        auto const rest = part_from(line, seen, to_mm);
        result.insert(result.end(), rest.begin(), rest.end());
    }
    return without_repeats(result);
}

} // namespace tractus::lines
