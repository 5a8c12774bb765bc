#include "engine/methods/silhouettes/trunk_reach.h"

#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/outline.h"

#include <algorithm>

namespace tractus::silhouette {

// Direction of the trunk's last quarter; the very end of a stroke is unreliable.
static Vec2 tip_direction(std::span<Vec2 const> trunk)
{
    constexpr double kLast = 0.25;
    Line const line({ trunk.begin(), trunk.end() });
    return direction_of(trunk.back() - line.at(1 - kLast));
}

static double extent(std::span<Vec2 const> outline, Vec2 const& along)
{
    double low = 1e300;
    double high = -1e300;
    for (auto const& point : outline) {
        low = std::min(low, point.dot(along));
        high = std::max(high, point.dot(along));
    }
    return high - low;
}

std::optional<double> extension_into_crown(std::span<Vec2 const> trunk,
                                           std::vector<Vec2> const& outline)
{
    return extension_into_crown(trunk, std::vector<std::vector<Vec2>> { outline });
}

std::optional<double> extension_into_crown(std::span<Vec2 const> trunk,
                                           std::vector<std::vector<Vec2>> const& strokes)
{
    constexpr double kFarthest_mm = 6;
    constexpr double kOfLength = 0.15;
    // Maximum length of the straight way from the tip to the crown, as a multiple of the tip's
    // maximum distance from the crown: the way can meet the crown obliquely.
    constexpr double kOblique = 2;
    // Minimum length of the straight line inside the crown, as a share of the crown's extent in the
    // line's direction.
    constexpr double kThrough = 0.5;
    // The extension ends at this share of the straight line inside the crown.
    constexpr double kOn = 0.85;
    // Offset past the line's first intersection with the outline, as a share of the outline's
    // diagonal.
    constexpr double kBeyond = 1e-6;
    if (trunk.size() < 2)
        return std::nullopt;
    auto const clean = clean_drawing({ strokes, { trunk.begin(), trunk.end() } });
    if (!clean)
        return std::nullopt;
    auto const crown = clean->to_sheet.points(clean->outline);
    if (std::any_of(trunk.begin(), trunk.end(),
                    [&](Vec2 const& point) { return is_inside(crown, point); }))
        return std::nullopt;
    double const most = std::min(kFarthest_mm, kOfLength * length_of(trunk));
    if (distance_to_outline(crown, trunk.back()) > most)
        return std::nullopt;
    Vec2 const ahead = tip_direction(trunk);
    auto const to_crown = ray_distance_to_outline(crown, trunk.back(), ahead);
    if (!to_crown || *to_crown > kOblique * most)
        return std::nullopt;
    double const in = *to_crown + kBeyond * box_of(crown).diagonal();
    auto const through = ray_distance_to_outline(crown, trunk.back() + in * ahead, ahead);
    if (!through || *through < kThrough * extent(crown, ahead))
        return std::nullopt;
    return in + kOn * *through;
}

void go_on(std::vector<Vec2>& trunk, double by)
{
    trunk.emplace_back(trunk.back() + by * tip_direction(trunk));
}

} // namespace tractus::silhouette
