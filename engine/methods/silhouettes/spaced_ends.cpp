#include "engine/methods/silhouettes/spaced_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

// Position of a spaced branch's end on the straight line from its base to the outline, 0 to 1.
constexpr double kEndsAt = 0.85;
// Maximum distance by which a branch may leave the outline, as a share of the outline's diagonal.
constexpr double kMaxOut = 0.01;
// Minimum length of a branch, as a share of the outline's diagonal; the trunk would hide shorter
// ones.
constexpr double kMinSpacedLength = 0.015;

Vec2 trunk_direction(std::span<Vec2 const> trunk, std::size_t sample)
{
    auto const next = std::min(sample + 1, trunk.size() - 1);
    return direction_of(trunk[next] - trunk[sample > 0 ? sample - 1 : 0]);
}

// Records which samples of an outline have an owner: a bump, a drawn branch or an end of the trunk.
class Ownership {
public:
    explicit Ownership(std::size_t samples)
        : is_owned_(samples, false)
    {
    }

    void take(Arc const& arc)
    {
        for (std::size_t i = arc.first;; i = (i + 1) % is_owned_.size()) {
            is_owned_[i] = true;
            if (i == arc.last)
                return;
        }
    }

    // Marks about `width` samples around the given one as owned.
    void take_around(std::size_t sample, double width)
    {
        auto const n = is_owned_.size();
        auto const half = std::min(static_cast<std::size_t>(std::lround(width / 2)), n / 2 - 1);
        take({ static_cast<std::uint32_t>((sample + n - half) % n),
               static_cast<std::uint32_t>((sample + half) % n) });
    }

    // A run of consecutive samples without an owner.
    struct Stretch {
        std::size_t first;
        std::size_t count;
    };
    std::vector<Stretch> free_stretches() const
    {
        auto const n = is_owned_.size();
        auto const owned = std::find(is_owned_.begin(), is_owned_.end(), true);
        auto const start = static_cast<std::size_t>(owned - is_owned_.begin()) % n;
        std::vector<Stretch> stretches;
        for (std::size_t k = 0; k < n; ++k) {
            auto const i = (start + k) % n;
            if (is_owned_[i])
                continue;
            if (stretches.empty() || k == 0 || is_owned_[(i + n - 1) % n])
                stretches.push_back({ i, 0 });
            ++stretches.back().count;
        }
        return stretches;
    }

private:
    std::vector<bool> is_owned_;
};

std::size_t nearest_sample(std::span<Vec2 const> outline, Vec2 const& point)
{
    auto const nearest
        = std::min_element(outline.begin(), outline.end(), [&](Vec2 const& a, Vec2 const& b) {
              return (a - point).squaredNorm() < (b - point).squaredNorm();
          });
    return static_cast<std::size_t>(nearest - outline.begin());
}

// The part of a bump's arc up to `width` samples from its tip on both sides, extended to include
// `least`.
Arc around_tip(std::span<Vec2 const> outline, Bump const& bump, std::size_t width, Arc const& least)
{
    auto const n = outline.size();
    auto const place = [&](std::size_t sample) { return (sample + n - bump.arc.first) % n; };
    auto const whole = place(bump.arc.last);
    auto const middle = std::min(place(nearest_sample(outline, bump.tip)), whole);
    auto const low = std::min(place(least.first), middle - std::min(middle, width));
    auto const high = std::max(place(least.last), std::min(whole, middle + width));
    return { static_cast<std::uint32_t>((bump.arc.first + low) % n),
             static_cast<std::uint32_t>((bump.arc.first + high) % n) };
}

class Divider {
public:
    explicit Divider(CrownToDivide const& crown)
        : crown_(crown)
        , trunk_(crown.search.trunk)
        , run_(crown.search.bases)
        , limit_(kMaxOut * box_of(crown.outline).diagonal())
    {
    }

    std::vector<SpacedBranch> run()
    {
        if (crown_.has >= crown_.branches)
            return {};
        std::array<std::vector<Part>, 2> sides;
        for (auto const& arc : parts()) {
            auto const part = part_of(arc);
            sides[part.side == Side::Right].push_back(part);
        }
        std::vector<SpacedBranch> result;
        for (auto& side : sides) {
            spread_bases(side);
            for (auto const& part : side)
                if (auto branch = branch_to_part(part))
                    result.push_back(*std::move(branch));
        }
        return result;
    }

private:
    // A part of the outline, its middle sample, and the trunk sample from which its branch starts.
    struct Part {
        Arc arc;
        std::size_t middle;
        std::size_t base;
        Side side;
    };

    // Number of outline samples per branch, if the outline is divided evenly.
    double spacing() const
    {
        return static_cast<double>(crown_.outline.size()) / static_cast<double>(crown_.branches);
    }

    // The part of the outline that belongs to a bump's own branch alone: the whole arc of the bump,
    // or kMaxParts times spacing() around its tip if the arc is longer.
    Arc kept_by_lateral(Bump const& bump) const
    {
        constexpr double kMaxParts = 3;
        auto const n = crown_.outline.size();
        auto const tip = static_cast<std::uint32_t>(nearest_sample(crown_.outline, bump.tip));
        auto const width = static_cast<std::size_t>(std::lround(kMaxParts / 2 * spacing()));
        if (bump.arc.inner_count(n) <= 2 * width)
            return bump.arc;
        return around_tip(crown_.outline, bump, width, { tip, tip });
    }

    Ownership owners() const
    {
        Ownership owners(crown_.outline.size());
        bool has_foot = false;
        for (auto const& bump : crown_.bumps) {
            has_foot = has_foot || bump.role == Role::Foot;
            owners.take(bump.role == Role::Lateral
                            ? kept_by_lateral(bump)
                            : kept_by_trunk(crown_.outline, bump, crown_.branches));
        }
        // The trunk owns the outline where it enters, if there is no foot bump, and straight ahead
        // of its end.
        if (!has_foot && run_.first > 0)
            owners.take_around(nearest_sample(crown_.outline, trunk_[run_.first]), spacing());
        auto const ahead = ray_distance_to_outline(crown_.outline, trunk_[run_.last],
                                                   trunk_direction(trunk_, run_.last));
        if (ahead)
            owners.take_around(
                nearest_sample(crown_.outline,
                               trunk_[run_.last] + *ahead * trunk_direction(trunk_, run_.last)),
                spacing());
        for (auto const& end : crown_.drawn_ends)
            owners.take_around(nearest_sample(crown_.outline, end), spacing());
        return owners;
    }

    // Divides the stretches without an owner into even parts, each about spacing() samples long.
    // There are at most as many parts as the crown lacks branches.
    std::vector<Arc> parts() const
    {
        auto const stretches = owners().free_stretches();
        double free = 0;
        for (auto const& stretch : stretches)
            free += static_cast<double>(stretch.count);
        double const lacks = static_cast<double>(crown_.branches - crown_.has);
        // Minimum length of a part, as a share of spacing(). On a smooth outline all parts are
        // shorter than spacing(), since the trunk's ends own some of the outline.
        constexpr double kNarrowest = 0.8;
        double const width = std::max(kNarrowest * spacing(), free / lacks);
        std::vector<Arc> arcs;
        auto const n = crown_.outline.size();
        for (auto const& stretch : stretches) {
            auto const count
                = static_cast<std::size_t>(std::lround(static_cast<double>(stretch.count) / width));
            for (std::size_t i = 0; i < count; ++i) {
                auto const first = stretch.first + i * (stretch.count - 1) / count;
                auto const last = stretch.first + (i + 1) * (stretch.count - 1) / count;
                if (last > first + 1)
                    arcs.push_back({ static_cast<std::uint32_t>(first % n),
                                     static_cast<std::uint32_t>(last % n) });
            }
        }
        if (arcs.size() > crown_.branches - crown_.has)
            arcs.resize(crown_.branches - crown_.has);
        return arcs;
    }

    Part part_of(Arc const& arc) const
    {
        auto const n = crown_.outline.size();
        auto const count = (arc.last + n - arc.first) % n;
        Part part { arc, (arc.first + count / 2) % n, run_.first, Side::Left };
        Vec2 const to = crown_.outline[part.middle];
        double least = std::numeric_limits<double>::infinity();
        for (auto k = run_.first; k <= run_.last; ++k) {
            Vec2 const along = trunk_direction(trunk_, k);
            Vec2 const way = to - trunk_[k];
            double const angle_deg = degrees(std::atan2(cross(along, way), along.dot(way)));
            double const t = static_cast<double>(k) / static_cast<double>(trunk_.size() - 1);
            double const off
                = std::fabs(std::fabs(angle_deg) - crown_.search.angles.at_deg(std::min(t, 1.0)));
            if (off < least) {
                least = off;
                part.base = k;
                part.side = angle_deg > 0 ? Side::Left : Side::Right;
            }
        }
        return part;
    }

    // Sorts the parts of one side of the trunk by the bases of their branches, and moves bases
    // apart that are too close to each other.
    void spread_bases(std::vector<Part>& parts) const
    {
        if (parts.empty())
            return;
        std::sort(parts.begin(), parts.end(), [&](Part const& a, Part const& b) {
            return std::pair(a.base, height(a)) < std::pair(b.base, height(b));
        });
        // Minimum distance between bases, as a share of their mean distance.
        constexpr double kMinGap = 0.4;
        auto const run = run_.last - run_.first;
        auto const gap = static_cast<std::size_t>(kMinGap * static_cast<double>(run)
                                                  / static_cast<double>(parts.size()));
        for (std::size_t i = parts.size() - 1; i-- > 0;) {
            auto const most = parts[i + 1].base - std::min(gap, parts[i + 1].base - run_.first);
            parts[i].base = std::min(parts[i].base, most);
        }
        for (std::size_t i = 1; i < parts.size(); ++i)
            parts[i].base = std::min(run_.last, std::max(parts[i].base, parts[i - 1].base + gap));
    }

    double height(Part const& part) const
    {
        return crown_.outline[part.middle].dot(direction_of(trunk_.back() - trunk_.front()));
    }

    std::optional<SpacedBranch> branch_to_part(Part const& part) const
    {
        Vec2 const to = crown_.outline[part.middle];
        Vec2 const base = trunk_[part.base];
        double const rise = crown_.search.angles.rise();
        Vec2 const way = to - base;
        BranchEnd const end { .end = base + kEndsAt * way,
                              .tangent = direction_of(
                                  direction_of(way) + rise * trunk_direction(trunk_, part.base)) };
        auto path = branch_from(crown_.search, part.base, end);
        path.outside = excursion(crown_.outline, path.curve.points(17));
        if (path.outside > limit_ || !is_inside(crown_.outline, end.end))
            path = infer_branch(crown_.search, { inner_end(to), end.tangent });
        if (path.outside > limit_ || path.length < kMinSpacedLength * limit_ / kMaxOut)
            return std::nullopt;
        SpacedBranch branch { .path = path };
        branch.part = described(part.arc, path.curve, to);
        branch.number = static_cast<std::size_t>(
            std::lround(4 * static_cast<double>(part.middle) / spacing()));
        return branch;
    }

    // A point inside the outline near the outline sample `at`, towards the trunk.
    Vec2 inner_end(Vec2 const& at) const
    {
        auto const nearest
            = nearest_sample(trunk_.subspan(run_.first, run_.last - run_.first + 1), at);
        Vec2 const inwards = trunk_[run_.first + nearest] - at;
        return at + (1 - kEndsAt) * inwards;
    }

    // The part of the outline in which a branch ends, described as a bump. Its radius is such that
    // the cone at the branch's base contains the part.
    Bump described(Arc const& arc, Cubic const& curve, Vec2 const& tip) const
    {
        auto bump = describe_bump(crown_.outline, arc, arc, 0);
        Vec2 const axis = curve.end - curve.base;
        double open_deg = 0;
        for (auto const i : { arc.first, arc.last }) {
            Vec2 const way = crown_.outline[i] - curve.base;
            open_deg = std::max(open_deg,
                                degrees(std::fabs(std::atan2(cross(axis, way), axis.dot(way)))));
        }
        bump.end = curve.end;
        bump.tip = tip;
        bump.radius = std::clamp((2 * open_deg - 20) / 90, 0.02, 1.0) * axis.norm();
        return bump;
    }

    CrownToDivide const& crown_;
    std::span<Vec2 const> trunk_;
    Run run_;
    double limit_;
};

} // namespace

std::vector<SpacedBranch> spaced_branches(CrownToDivide const& crown)
{
    return Divider(crown).run();
}

Arc kept_by_trunk(std::span<Vec2 const> outline, Bump const& bump, std::size_t branches)
{
    auto const width = outline.size() / std::max<std::size_t>(branches, 1) / 2 + 1;
    return around_tip(outline, bump, width, bump.cap);
}

} // namespace tractus::silhouette
