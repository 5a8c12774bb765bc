#include "engine/methods/silhouettes/bump_touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

// Maximum distances of a touch from a bump's arc and from the joint between two bumps, as shares of
// the outline's diagonal.
constexpr double kNearBump = 0.04;
constexpr double kNearJoint = 0.08;

// A bump must have at least this many outline samples to be split.
constexpr std::size_t kMinSteps = 8;

std::vector<Vec2> points_between(std::span<Vec2 const> outline, std::uint32_t first,
                                 std::uint32_t last)
{
    std::vector<Vec2> points { outline[first] };
    for (auto i = first; i != last;) {
        i = static_cast<std::uint32_t>((i + 1) % outline.size());
        points.push_back(outline[i]);
    }
    return points;
}

// True if the point is near the bump's end: in a circle with the radius of the cap, or half of the
// cap's chord if that is less. In a lobe, the end can be outside the bump, on the inner side of its
// chord.
bool is_around_end(Bump const& bump, std::span<Vec2 const> outline, Vec2 const& place)
{
    double const half = (outline[bump.cap.last] - outline[bump.cap.first]).norm() / 2;
    return (place - bump.end).norm() <= std::min(half, bump.radius);
}

// Position of a touch relative to a bump, the best match first.
enum class Where { In, AroundEnd, Beside };

std::optional<std::size_t> split_bump(std::span<Bump const> bumps, std::span<Vec2 const> outline,
                                      Vec2 const& place)
{
    double const near = kNearBump * box_of(outline).diagonal();
    std::optional<std::size_t> best;
    std::pair least(Where::Beside, 1e300);
    for (std::size_t i = 0; i < bumps.size(); ++i) {
        auto const arc = points_between(outline, bumps[i].arc.first, bumps[i].arc.last);
        double const far = distance_to_line(place, arc);
        auto const where = is_inside(arc, place)      ? Where::In
            : is_around_end(bumps[i], outline, place) ? Where::AroundEnd
                                                      : Where::Beside;
        if (arc.size() <= kMinSteps || (where == Where::Beside && far > near))
            continue;
        if (std::pair const rank(where, far); rank < least) {
            least = rank;
            best = i;
        }
    }
    return best;
}

// Index of the next bump along the outline.
std::size_t after(std::span<Bump const> bumps, std::size_t bump)
{
    return (bump + 1) % bumps.size();
}

std::optional<std::size_t> first_of_joined(std::span<Bump const> bumps,
                                           std::span<Vec2 const> outline, Vec2 const& place)
{
    if (bumps.size() < 2)
        return std::nullopt;
    double least = kNearJoint * box_of(outline).diagonal();
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < bumps.size(); ++i) {
        auto const between
            = points_between(outline, bumps[i].arc.last, bumps[after(bumps, i)].arc.first);
        double const far = distance_to_line(place, between);
        if (far >= least)
            continue;
        least = far;
        best = i;
    }
    return best;
}

Vec2 chord_middle(std::span<Vec2 const> outline, Arc const& arc)
{
    return (outline[arc.first] + outline[arc.last]) / 2;
}

// Moves the bump's end towards the middle of its chord: a branch must end inside the outline, not
// on it.
void pull_inside(Bump& bump, std::span<Vec2 const> outline)
{
    constexpr int kSteps = 8;
    // Minimum distance of the end from the outline, as a share of the bump's radius.
    constexpr double kMin = 0.1;
    Vec2 const from = bump.end;
    Vec2 const to = chord_middle(outline, bump.arc);
    for (int i = 1; i <= kSteps; ++i) {
        if (is_inside(outline, bump.end)
            && distance_to_outline(outline, bump.end) >= kMin * bump.radius)
            return;
        bump.end = from + (to - from) * (static_cast<double>(i) / kSteps);
    }
}

// Makes a bump from its arc. The arc is narrowed evenly from both ends until the half disc over its
// ends contains the rest, which is the cap.
Bump bump_on(std::span<Vec2 const> outline, Arc const& arc, double strength)
{
    auto const n = static_cast<std::uint32_t>(outline.size());
    auto cap = arc;
    while (cap.inner_count(n) > 3 && !contains_cap(outline, cap))
        cap = { (cap.first + 1) % n, (cap.last + n - 1) % n };
    auto bump = describe_bump(outline, arc, cap, strength);
    pull_inside(bump, outline);
    return bump;
}

// The outline sample, strictly inside the arc, at which a touch splits the arc.
std::uint32_t split_sample(std::span<Vec2 const> outline, Bump const& bump, Vec2 const& place)
{
    constexpr double kMinPart = 0.2;
    // A touch nearer to the ray's origin than this share of the bump's height gives no clear
    // direction.
    constexpr double kTooNear = 0.25;
    // Minimum distance of the ray's origin from the bump's tip, as a multiple of the distance from
    // the tip to the bump's end.
    constexpr double kMinOriginDistance = 1.5;
    Vec2 const back = chord_middle(outline, bump.arc) - bump.tip;
    Vec2 const from = bump.tip
        + std::max(back.norm(), kMinOriginDistance * (bump.end - bump.tip).norm())
            * direction_of(back, -bump.tangent);
    Vec2 const to_tip = bump.tip - from;
    Vec2 way = place - from;
    if (way.norm() < kTooNear * to_tip.norm() || way.dot(to_tip) <= 0)
        way = to_tip;
    auto const n = static_cast<std::uint32_t>(outline.size());
    auto const steps = (bump.arc.last + n - bump.arc.first) % n;
    auto const least = static_cast<std::uint32_t>(std::ceil(kMinPart * static_cast<double>(steps)));
    auto best = least;
    double most = -2;
    for (auto i = least; i <= steps - least; ++i) {
        Vec2 const ray = outline[(bump.arc.first + i) % n] - from;
        double const along = direction_of(ray).dot(direction_of(way));
        if (along > most) {
            most = along;
            best = i;
        }
    }
    return (bump.arc.first + best) % n;
}

void split(std::vector<Bump>& bumps, std::span<Vec2 const> outline, std::size_t i,
           Vec2 const& place)
{
    auto const whole = bumps[i];
    auto const middle = split_sample(outline, whole, place);
    bumps[i] = bump_on(outline, { whole.arc.first, middle }, whole.strength);
    bumps.insert(bumps.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                 bump_on(outline, { middle, whole.arc.last }, whole.strength));
}

// Merges two bumps: the arc covers both and the outline between them; the new end is between the
// two ends.
Bump joined(std::span<Vec2 const> outline, Bump const& first, Bump const& second)
{
    auto bump = describe_bump(outline, { first.arc.first, second.arc.last },
                              { first.cap.first, second.cap.last },
                              std::max(first.strength, second.strength));
    double const both = first.radius + second.radius;
    bump.end = (first.radius * first.end + second.radius * second.end) / both;
    bump.radius = (second.end - first.end).norm() / 2 + std::max(first.radius, second.radius);
    bump.tangent = direction_of(first.tangent + second.tangent, bump.tangent);
    bool const first_is_tip
        = (first.tip - bump.end).dot(bump.tangent) >= (second.tip - bump.end).dot(bump.tangent);
    bump.tip = first_is_tip ? first.tip : second.tip;
    pull_inside(bump, outline);
    return bump;
}

void join(std::vector<Bump>& bumps, std::span<Vec2 const> outline, std::size_t i)
{
    auto const j = after(bumps, i);
    bumps[i] = joined(outline, bumps[i], bumps[j]);
    bumps.erase(bumps.begin() + static_cast<std::ptrdiff_t>(j));
}

void sort_by_arc(std::vector<Bump>& bumps)
{
    std::sort(bumps.begin(), bumps.end(),
              [](Bump const& a, Bump const& b) { return a.arc.first < b.arc.first; });
}

// Index of the earlier touch that a new one undoes, if any.
std::optional<std::size_t> taken_back(BranchingSystem const& system, std::size_t bump,
                                      std::span<BumpTouch const> touches, BumpTouch const& touch)
{
    auto const made_by = system.bumps[bump].touch;
    if (!made_by || touches[*made_by].kind == touch.kind)
        return std::nullopt;
    if (touch.kind == BumpTouch::Kind::Join)
        return system.bumps[after(system.bumps, bump)].touch == made_by ? made_by : std::nullopt;
    double const far = (touches[*made_by].place - touch.place).norm();
    return far <= kNearJoint * box_of(system.outline).diagonal() ? made_by : std::nullopt;
}

} // namespace

std::optional<std::size_t> touched_bump(std::span<Bump const> bumps, std::span<Vec2 const> outline,
                                        BumpTouch const& touch)
{
    return touch.kind == BumpTouch::Kind::Split ? split_bump(bumps, outline, touch.place)
                                                : first_of_joined(bumps, outline, touch.place);
}

std::size_t take_touches(std::vector<Bump>& bumps, std::span<Vec2 const> outline,
                         std::span<BumpTouch const> touches)
{
    std::size_t taken = 0;
    for (std::size_t number = 0; number < touches.size(); ++number) {
        auto const& touch = touches[number];
        auto const i = touched_bump(bumps, outline, touch);
        if (!i)
            continue;
        ++taken;
        if (touch.kind == BumpTouch::Kind::Split) {
            split(bumps, outline, *i, touch.place);
            bumps[*i].touch = bumps[*i + 1].touch = number;
        } else {
            bumps[*i].touch.reset();
            join(bumps, outline, *i);
            bumps[*i < bumps.size() ? *i : *i - 1].touch = number;
        }
        sort_by_arc(bumps);
    }
    return taken;
}

std::vector<std::size_t> outlined_systems(Skeleton const& skeleton, Search search)
{
    std::vector<std::pair<double, std::size_t>> by_area;
    for (auto const s : skeleton.drawn_systems())
        if (s == 0 || (search == Search::AnyLevel && skeleton.systems[s].is_of_own_outline))
            by_area.emplace_back(std::fabs(signed_area(skeleton.systems[s].outline)), s);
    std::sort(by_area.begin(), by_area.end());
    std::vector<std::size_t> systems;
    for (auto const& [area, s] : by_area)
        systems.push_back(s);
    return systems;
}

Result<TouchedDrawing> touched(Drawing const& drawing, BumpTouch const& touch,
                               SkeletonOptions const& options, Search search)
{
    if (drawing.is_leaf)
        return fail(Fault::User,
                    "the crown is a leaf, in which nothing is inferred: touch it once more as a "
                    "leaf first");
    auto const skeleton = TRY(infer_skeleton(drawing, options));
    for (auto const s : outlined_systems(skeleton, search)) {
        auto const& system = skeleton.systems[s];
        auto const bump = touched_bump(system.bumps, system.outline, touch);
        if (!bump)
            continue;
        // Touches on the outline of `system`, and their indices among all touches of the drawing.
        std::vector<BumpTouch> touches;
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < drawing.touches.size(); ++i)
            if (drawing.touches[i].branch == skeleton.parents[s]) {
                touches.push_back(drawing.touches[i]);
                numbers.push_back(i);
            }
        if (auto const back = taken_back(system, *bump, touches, touch))
            return TouchedDrawing { .taken_back = numbers[*back] };
        return TouchedDrawing { .added = { touch.kind, touch.place, skeleton.parents[s] } };
    }
    return fail(Fault::User,
                touch.kind == BumpTouch::Kind::Split
                    ? "the touch is on no bump of the tree's outlines that is large enough: touch "
                      "one inside, near its edge"
                    : "the touch is not where two bumps meet: touch the outline between them");
}

Result<void> add_touch(Drawing& drawing, BumpTouch const& touch, SkeletonOptions const& options,
                       Search search)
{
    auto const found = TRY(touched(drawing, touch, options, search));
    if (found.taken_back)
        drawing.touches.erase(drawing.touches.begin()
                              + static_cast<std::ptrdiff_t>(*found.taken_back));
    else
        drawing.touches.push_back(found.added);
    return {};
}

std::size_t count_unmatched_touches(Drawing const& drawing, Skeleton const& skeleton)
{
    std::size_t taken = 0;
    for (auto const& system : skeleton.systems)
        taken += system.touches_taken;
    return drawing.touches.size() - taken;
}

} // namespace tractus::silhouette
