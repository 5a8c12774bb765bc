#include "engine/methods/silhouettes/outline.h"

#include "engine/base/random.h"
#include "engine/methods/silhouettes/loops.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr std::size_t kMinPoints = 8;
// Largest gap between the ends of a closed stroke, as a share of its length.
constexpr double kWidestGap = 0.25;
// Largest gap between strokes that are joined, as a share of the drawing's diagonal.
constexpr double kWidestJoin = 0.1;
// Minimum length of a branch, as a share of the drawing's diagonal.
constexpr double kShortestBranch = 1e-2;
// Add a note if more than this share of the outline's area was left out.
constexpr double kWarnShare = 0.1;
// Height of the default trunk, as a share of the outline's height.
constexpr double kTrunkHeight = 0.85;
// Maximum number of outline points when searching for crossings.
constexpr std::size_t kMaxCorners = 1024;

Result<void> check_points(Drawing const& drawing)
{
    std::size_t count = 0;
    bool finite = true;
    auto const look_at = [&](std::vector<Vec2> const& stroke) {
        count += stroke.size();
        for (auto const& p : stroke)
            finite = finite && p.allFinite() && p.norm() < 1e9;
    };
    look_at(drawing.trunk);
    for (auto const* const strokes : { &drawing.outline, &drawing.branches })
        for (auto const& stroke : *strokes)
            look_at(stroke);
    for (auto const& touch : drawing.touches)
        look_at({ touch.place });
    if (count > kMaxDrawnPoints)
        return fail(
            Fault::User,
            fmt::format("the drawing has {} points: give at most {}", count, kMaxDrawnPoints));
    if (!finite)
        return fail(Fault::User, "a number of the drawing is too large: give millimetres");
    return {};
}

std::vector<Vec2> without_repeats(std::vector<Vec2> const& points)
{
    std::vector<Vec2> kept;
    for (auto const& point : points)
        if (kept.empty() || (point - kept.back()).norm() > 1e-9)
            kept.push_back(point);
    return kept;
}

// The normalised frame of a CleanDrawing, before coordinates are rounded.
Similarity frame_of(Drawing const& drawing)
{
    Similarity frame;
    Vec2 up = Vec2::UnitY();
    frame.from = drawing.outline.front().front();
    if (!drawing.trunk.empty()) {
        frame.from = drawing.trunk.front();
        up = direction_of(drawing.trunk.back() - drawing.trunk.front());
    }
    frame.turn = { up.y(), up.x() };
    std::vector<Vec2> all;
    for (auto const& stroke : drawing.outline)
        for (auto const& point : stroke)
            all.push_back(frame.vector(point - frame.from));
    frame.turn /= std::max(box_of(all).diagonal(), 1e-9);
    return frame;
}

// Transforms, rounds, and then shifts points by a few ten-millionths. Without the shift, coincident
// or collinear points could cross without the crossing being detected.
std::vector<Vec2> in_frame(std::vector<Vec2> const& points, Similarity const& frame)
{
    constexpr double kSteps = 1 << 30;
    constexpr double kApart = 1e-7;
    Random random({ .seed = 0x511, .stream = static_cast<std::uint32_t>(points.size()) });
    auto result = without_repeats(frame.points(points));
    for (auto& point : result) {
        point = (point * kSteps).array().round() / kSteps;
        point.x() += random.uniform(-kApart, kApart);
        point.y() += random.uniform(-kApart, kApart);
    }
    return result;
}

// Appends the second stroke to the first. `ends` gives the ends that meet: of the first stroke its
// end if bit 0 is set, otherwise its beginning; of the second stroke likewise by bit 1.
std::vector<Vec2> joined(std::vector<Vec2> first, std::vector<Vec2> second, unsigned ends)
{
    if ((ends & 1U) == 0)
        std::reverse(first.begin(), first.end());
    if ((ends & 2U) != 0)
        std::reverse(second.begin(), second.end());
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

// Joins strokes, nearest ends first. The longest result is the outline.
std::vector<Vec2> join_strokes(std::vector<std::vector<Vec2>> strokes,
                               std::vector<std::string>& notes)
{
    while (strokes.size() > 1) {
        double least = kWidestJoin;
        std::size_t first = 0;
        std::size_t second = 0;
        unsigned ends = 0;
        for (std::size_t i = 0; i < strokes.size(); ++i)
            for (std::size_t j = i + 1; j < strokes.size(); ++j)
                for (unsigned e = 0; e < 4; ++e) {
                    auto const& a = (e & 1U) != 0 ? strokes[i].back() : strokes[i].front();
                    auto const& b = (e & 2U) != 0 ? strokes[j].back() : strokes[j].front();
                    if ((a - b).norm() < least) {
                        least = (a - b).norm();
                        first = i, second = j, ends = e;
                    }
                }
        if (second == 0)
            break;
        strokes[first] = joined(std::move(strokes[first]), std::move(strokes[second]), ends);
        strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(second));
    }
    auto const longest
        = std::max_element(strokes.begin(), strokes.end(), [](auto const& a, auto const& b) {
              return length_of(a) < length_of(b);
          });
    if (strokes.size() > 1)
        notes.push_back(fmt::format("{} strokes of the outline are left out: their ends are not "
                                    "near the others'",
                                    strokes.size() - 1));
    return std::move(*longest);
}

// Joins strokes to one outline and closes it.
Result<std::vector<Vec2>> close_outline(std::vector<std::vector<Vec2>> strokes,
                                        std::vector<std::string>& notes)
{
    auto stroke = without_repeats(join_strokes(std::move(strokes), notes));
    if (stroke.size() < kMinPoints)
        return fail(Fault::User,
                    fmt::format("the outline has {} points: draw it larger, with {} or more",
                                stroke.size(), kMinPoints));
    if (stroke.size() > kMaxCorners)
        stroke = resampled_line(stroke, kMaxCorners);
    auto trimmed = without_overshoot(stroke);
    double const gap = (trimmed.back() - trimmed.front()).norm();
    if (gap > kWidestGap * length_of(trimmed))
        return fail(Fault::User, "the outline is open: end it near its beginning");
    if (gap <= 1e-9)
        trimmed.pop_back();
    return trimmed;
}

std::vector<Vec2> smoothed(std::vector<Vec2> const& outline, double deviation)
{
    if (!(deviation > 0))
        return outline;
    auto const n = static_cast<int>(outline.size());
    int const reach = static_cast<int>(3 * deviation) + 1;
    std::vector<Vec2> result(outline.size(), Vec2::Zero());
    double sum = 0;
    for (int k = -reach; k <= reach; ++k)
        sum += std::exp(-0.5 * k * k / (deviation * deviation));
    for (int i = 0; i < n; ++i)
        for (int k = -reach; k <= reach; ++k)
            result[static_cast<std::size_t>(i)] += std::exp(-0.5 * k * k / (deviation * deviation))
                / sum * outline[static_cast<std::size_t>(((i + k) % n + n) % n)];
    return result;
}

// Makes the sample farthest from the trunk's base the first. The samples then do not depend on
// where the stroke began, also for a mirrored outline.
void begin_at_farthest(std::vector<Vec2>& outline)
{
    auto const farthest
        = std::max_element(outline.begin(), outline.end(), [](Vec2 const& a, Vec2 const& b) {
              return a.squaredNorm() < b.squaredNorm();
          });
    std::rotate(outline.begin(), farthest, outline.end());
}

Result<std::vector<Vec2>> simple_outline(std::vector<Vec2> const& closed,
                                         OutlineOptions const& options, double unit_mm,
                                         std::vector<std::string>& notes)
{
    auto loop = largest_loop(closed);
    if (!(loop.area > 0) || loop.area * unit_mm * unit_mm < options.min_area_mm2)
        return fail(Fault::User,
                    fmt::format("the outline encloses {:.1f} mm²: draw it larger",
                                loop.area * unit_mm * unit_mm));
    double const left_out = 1 - loop.area / loop.area_of_all;
    if (left_out > kWarnShare)
        notes.push_back(fmt::format("the outline crosses itself: its largest loop counts, {:.0f} % "
                                    "of the area are left out",
                                    100 * left_out));
    if (signed_area(loop.outline) < 0)
        std::reverse(loop.outline.begin(), loop.outline.end());
    begin_at_farthest(loop.outline);
    auto outline
        = smoothed(resampled_outline(loop.outline, options.samples), options.smoothing_samples);
    if (crosses_itself(outline))
        outline = largest_loop(outline).outline;
    if (outline.size() < kMinPoints)
        return fail(Fault::User, "the outline crosses itself everywhere: draw it once around");
    if (signed_area(outline) < 0) // Smoothing can invert the orientation of a sliver.
        std::reverse(outline.begin(), outline.end());
    return outline;
}

Vec2 centroid_of(std::span<Vec2 const> outline)
{
    Vec2 sum = Vec2::Zero();
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        auto const& a = outline[i];
        auto const& b = outline[(i + 1) % outline.size()];
        sum += cross(a, b) * (a + b);
        twice += cross(a, b);
    }
    return sum / (3 * twice);
}

std::vector<Vec2> guessed_trunk(std::span<Vec2 const> outline)
{
    double const x = centroid_of(outline).x();
    auto const box = box_of(outline);
    double low = box.high.y();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        auto const& a = outline[i];
        auto const& b = outline[(i + 1) % outline.size()];
        if ((a.x() <= x) != (b.x() <= x))
            low = std::min(low, a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
    }
    double const top = box.low.y() + kTrunkHeight * (box.high.y() - box.low.y());
    return { Vec2(x, low), Vec2(x, std::max(top, low + 0.05)) };
}

Similarity inverse(Similarity const& frame)
{
    Vec2 const back = Vec2(frame.turn.x(), -frame.turn.y()) / frame.turn.squaredNorm();
    return { .from = frame.to, .to = frame.from, .turn = back };
}

} // namespace

bool is_closed_stroke(std::span<Vec2 const> stroke)
{
    return stroke.size() > 2
        && (stroke.back() - stroke.front()).norm() <= kWidestGap * length_of(stroke);
}

Result<CleanDrawing> clean_drawing(Drawing const& drawing, OutlineOptions const& options)
{
    TRY(check_points(drawing));
    Drawing drawn { {}, drawing.trunk, {} };
    for (auto const& stroke : drawing.outline)
        if (!stroke.empty())
            drawn.outline.push_back(stroke);
    if (drawn.outline.empty())
        return fail(Fault::User, "the outline is missing: draw it around the crown");
    auto const frame = frame_of(drawn);
    CleanDrawing result;
    result.to_sheet = inverse(frame);
    for (auto& stroke : drawn.outline)
        stroke = in_frame(stroke, frame);
    auto trunk = in_frame(drawn.trunk, frame);
    auto const closed = TRY(close_outline(std::move(drawn.outline), result.notes));
    result.outline
        = TRY(simple_outline(closed, options, result.to_sheet.turn.norm(), result.notes));
    if (drawing.trunk.empty()) {
        trunk = guessed_trunk(result.outline);
        result.notes.emplace_back("there is no trunk: one under the middle of the crown is taken");
    }
    if (trunk.size() < 2 || length_of(trunk) < 1e-3)
        return fail(Fault::User,
                    "the trunk is only a dot: draw it from the foot upwards, or leave it out");
    result.trunk = resampled_line(trunk, kTrunkSamples);
    for (auto const& stroke : drawing.branches) {
        auto branch = in_frame(stroke, frame);
        if (branch.size() < 2 || length_of(branch) < kShortestBranch)
            return fail(Fault::User,
                        "a branch is only a dot: draw it from the trunk to where it ends");
        result.branches.push_back(std::move(branch));
    }
    for (auto touch : drawing.touches)
        if (touch.branch.empty()) {
            touch.place = in_frame({ touch.place }, frame).front();
            result.touches.push_back(std::move(touch));
        }
    return result;
}

} // namespace tractus::silhouette
