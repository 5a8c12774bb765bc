#include "engine/methods/leaves/find_leaflets.h"

#include "engine/methods/leaves/drawing_plane.h"
#include "engine/methods/leaves/flat_line.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <utility>

namespace tractus::leaf {

namespace {

// True if a stroke encloses an area as a leaflet's outline does.
bool is_closed_leaflet(FlatLine const& line)
{
    // Largest gap between the ends, as a share of the line's extent.
    constexpr double kMaxGap = 0.15;
    // Smallest area, as a share of the square of the line's extent: leaflets may be narrow.
    constexpr double kMinArea = 0.04;
    double const extent = extent_of(line);
    return (line.back() - line.front()).norm() < kMaxGap * extent
        && std::abs(area_of(line)) > kMinArea * extent * extent;
}

Vec2 mean_point_of(FlatLine const& ring)
{
    Vec2 sum = Vec2::Zero();
    for (auto const& at : ring)
        sum += at;
    return sum / double(ring.size());
}

double distance_between(FlatLine const& line, FlatLine const& ring)
{
    double least = std::numeric_limits<double>::infinity();
    for (auto const& at : ring)
        least = std::min(least, nearest_on(line, at).distance);
    return least;
}

// Directions of the larger and the smaller principal axis of the area within a closed line, and how
// many times as long the area is as it is wide.
struct Principal {
    Vec2 centroid = Vec2::Zero();
    Vec2 along = Vec2::UnitX();
    double slenderness = 1;
};

Principal principal_of(FlatLine const& ring)
{
    double area = 0;
    Vec2 first = Vec2::Zero();
    double xx = 0;
    double xy = 0;
    double yy = 0;
    Vec2 const origin = mean_point_of(ring);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2 const a = ring[i] - origin;
        Vec2 const b = ring[(i + 1) % ring.size()] - origin;
        double const twice = a.x() * b.y() - a.y() * b.x();
        area += twice / 2;
        first += twice / 6 * (a + b);
        xx += twice / 12 * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
        yy += twice / 12 * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y());
        xy += twice / 24 * (2 * a.x() * a.y() + a.x() * b.y() + b.x() * a.y() + 2 * b.x() * b.y());
    }
    Vec2 const center = first / area;
    xx = xx / area - center.x() * center.x();
    yy = yy / area - center.y() * center.y();
    xy = xy / area - center.x() * center.y();
    double const angle = 0.5 * std::atan2(2 * xy, xx - yy);
    double const half = std::hypot(0.5 * (xx - yy), xy);
    double const mean = 0.5 * (xx + yy);
    return { origin + center,
             { std::cos(angle), std::sin(angle) },
             std::sqrt((mean + half) / std::max(mean - half, 1e-12)) };
}

class LeafletFinder {
public:
    explicit LeafletFinder(std::vector<std::vector<Vec3>> const& strokes)
        : strokes_(strokes)
        , plane_(strokes)
    {
        for (auto const& stroke : strokes) {
            flat_.emplace_back();
            for (auto const& point : stroke)
                flat_.back().push_back(plane_.flat(point));
        }
    }

    Result<FoundLeaflets> find()
    {
        find_outlines();
        if (outlines_.size() < 2)
            return FoundLeaflets {};
        find_veins();
        TRY(find_rachis());
        orient_rachis();
        for (std::size_t i = 0; i < outlines_.size(); ++i)
            found_.leaflets.push_back(leaflet(i));
        return std::move(found_);
    }

private:
    // Finds closed strokes beside each other. Those that are inside of, or lie over, a larger one
    // are left out, and those of less than a hundredth of the largest one's area.
    void find_outlines()
    {
        constexpr double kSecond = 0.2;
        constexpr double kSmallest = 0.01;
        std::vector<std::pair<double, std::size_t>> closed;
        for (std::size_t i = 0; i < flat_.size(); ++i)
            if (is_closed_leaflet(flat_[i]))
                closed.emplace_back(std::abs(area_of(flat_[i])), i);
        std::ranges::sort(closed, [](auto const& a, auto const& b) {
            return a.first != b.first ? a.first > b.first : a.second < b.second;
        });
        for (auto const& each : closed) {
            auto const area = each.first;
            auto const stroke = each.second;
            bool const is_beside = std::ranges::none_of(outlines_, [&](std::size_t other) {
                return is_inside(flat_[other], mean_point_of(flat_[stroke]))
                    || is_inside(flat_[stroke], mean_point_of(flat_[other]));
            });
            double const least
                = closed.front().first * (outlines_.size() < 2 ? kSecond : kSmallest);
            if (is_beside && (outlines_.empty() || area > least))
                outlines_.push_back(stroke);
        }
        std::ranges::sort(outlines_);
        veins_.resize(outlines_.size());
    }

    bool is_outline(std::size_t stroke) const
    {
        return std::ranges::find(outlines_, stroke) != outlines_.end();
    }

    // Assigns each stroke to the leaflet in which most of it lies.
    void find_veins()
    {
        constexpr double kInside = 0.6;
        for (std::size_t i = 0; i < flat_.size(); ++i) {
            if (is_outline(i))
                continue;
            bool is_vein = false;
            for (std::size_t k = 0; k < outlines_.size() && !is_vein; ++k) {
                auto const inside = std::ranges::count_if(
                    flat_[i], [&](Vec2 const& at) { return is_inside(flat_[outlines_[k]], at); });
                is_vein = double(inside) > kInside * double(flat_[i].size());
                if (is_vein)
                    veins_[k].push_back(i);
            }
            if (!is_vein)
                outside_.push_back(i);
        }
    }

    // Distance within which a leaflet is borne by a line, in millimetres.
    double reach_of(std::size_t outline) const
    {
        constexpr double kReach = 0.35; // As a share of the leaflet's extent.
        return std::max(5.0, kReach * extent_of(flat_[outline]));
    }

    // The rachis is the stroke outside of leaflets to which most leaflets are near; the longest one
    // of these.
    Result<void> find_rachis()
    {
        std::pair<std::size_t, double> best { 0, 0 };
        for (auto const i : outside_) {
            auto const near = std::ranges::count_if(outlines_, [&](std::size_t outline) {
                return distance_between(flat_[i], flat_[outline]) < reach_of(outline);
            });
            std::pair const score { static_cast<std::size_t>(near), length_of(flat_[i]) };
            if (near == 0 || score <= best)
                continue;
            best = score;
            found_.rachis = i;
        }
        if (best.first == 0)
            return fail(Fault::User,
                        fmt::format("strokes {} and {} are both closed, and no line bears them: "
                                    "draw the rachis, the line along which leaflets stand, or one "
                                    "blade by itself",
                                    outlines_[0] + 1, outlines_[1] + 1));
        for (auto const i : outside_)
            if (i != found_.rachis)
                found_.stalks.push_back(i);
        return {};
    }

    Vec2 nearest_on_rachis(std::size_t outline) const
    {
        auto const& line = flat_[found_.rachis];
        double least = std::numeric_limits<double>::infinity();
        double along = 0;
        for (auto const& at : flat_[outline])
            if (auto const near = nearest_on(line, at); near.distance < least) {
                least = near.distance;
                along = near.along;
            }
        return place_at(line, along);
    }

    // Leaflets lean towards the end of the rachis.
    void orient_rachis()
    {
        auto const& line = flat_[found_.rachis];
        double forward = 0;
        for (auto const outline : outlines_) {
            Vec2 const foot = nearest_on_rachis(outline);
            double const along = nearest_on(line, foot).along;
            auto const last = double(line.size() - 1);
            Vec2 const way = place_at(line, std::min(last, along + 2))
                - place_at(line, std::max(0.0, along - 2));
            Vec2 const lean = mean_point_of(flat_[outline]) - foot;
            forward += way.dot(lean) / std::max(way.norm() * lean.norm(), 1e-12);
        }
        found_.rachis_line = strokes_[found_.rachis];
        if (forward < 0)
            std::ranges::reverse(found_.rachis_line);
    }

    // Ends of a leaflet's axis of symmetry, the one on the rachis' side first. Of a leaflet that is
    // about as wide as long, the axis is the one that points to the rachis.
    std::pair<Vec2, Vec2> ends_of_axis(std::size_t outline) const
    {
        constexpr double kSlender = 1.25;
        auto const& ring = flat_[outline];
        auto const [centroid, along, slenderness] = principal_of(ring);
        Vec2 const to_rachis = nearest_on_rachis(outline) - centroid;
        Vec2 const across(-along.y(), along.x());
        bool const is_across = slenderness < kSlender
            && std::abs(across.dot(to_rachis)) > std::abs(along.dot(to_rachis));
        Vec2 way = is_across ? across : along;
        if (way.dot(to_rachis) > 0)
            way = -way;
        double low = 0;
        double high = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Vec2 const a = ring[i] - centroid;
            Vec2 const b = ring[(i + 1) % ring.size()] - centroid;
            double const beside_a = way.x() * a.y() - way.y() * a.x();
            double const beside_b = way.x() * b.y() - way.y() * b.x();
            if ((beside_a > 0) == (beside_b > 0))
                continue;
            double const at = (a + beside_a / (beside_a - beside_b) * (b - a)).dot(way);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        return { centroid + low * way, centroid + high * way };
    }

    Vec3 in_space(Vec2 const& at) const
    {
        return plane_.center + at.x() * plane_.right + at.y() * plane_.up;
    }

    Leaflet leaflet(std::size_t i) const
    {
        constexpr int kPieces = 40;
        constexpr double kLongStalk = 0.12; // As a share of the leaflet's extent.
        auto const [base, tip] = ends_of_axis(outlines_[i]);
        Leaflet made { .outline = outlines_[i], .veins = veins_[i] };
        Vec2 const out = (base - tip).normalized()
            * std::max(7.0, kLongStalk * extent_of(flat_[outlines_[i]]));
        for (int k = 0; k <= kPieces; ++k) {
            double const share = double(k) / kPieces;
            made.axis.push_back(in_space(base + share * (tip - base)));
            made.stalk.push_back(in_space(base + share * out));
        }
        return made;
    }

    std::vector<std::vector<Vec3>> const& strokes_;
    DrawingPlane plane_;
    std::vector<FlatLine> flat_;
    std::vector<std::size_t> outlines_;
    std::vector<std::vector<std::size_t>> veins_; // Strokes in each of the outlines.
    std::vector<std::size_t> outside_;            // Strokes in no leaflet.
    FoundLeaflets found_;
};

} // namespace

Result<FoundLeaflets> find_leaflets(std::vector<std::vector<Vec3>> const& strokes)
{
    return LeafletFinder(strokes).find();
}

} // namespace tractus::leaf
