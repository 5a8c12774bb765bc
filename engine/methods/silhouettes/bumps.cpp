#include "engine/methods/silhouettes/bumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tractus::silhouette {

namespace {

// Calls use(point) for each outline point strictly inside an arc.
template<typename Use> void for_inner_points(std::span<Vec2 const> outline, Arc arc, Use&& use)
{
    auto const n = outline.size();
    for (auto i = (arc.first + 1) % n; i != arc.last; i = (i + 1) % n)
        use(outline[i]);
}

// Removes weak limbs of a chordal axis until all remaining limbs are bumps.
class Pruner {
public:
    Pruner(ChordalAxis const& axis, BumpThresholds const& thresholds)
        : axis_(axis)
        , thresholds_(thresholds)
        , diagonal_(box_of(axis.outline()).diagonal())
        , alive_(axis.triangles().size())
        , strength_(axis.triangles().size(), { -1, -1, -1 })
    {
        for (std::uint32_t k = 0; k < alive_.size(); ++k)
            for (std::uint32_t e = 0; e < 3; ++e)
                alive_[k][e] = axis.triangles()[k].beyond[e] != kNoTriangle;
    }

    struct Limb {
        Chord chord;
        double strength = 0;
    };

    std::vector<Limb> run()
    {
        while (true) {
            auto limbs = find_limbs();
            auto const weakest
                = std::min_element(limbs.begin(), limbs.end(), [](Limb const& a, Limb const& b) {
                      return a.strength < b.strength;
                  });
            if (weakest == limbs.end() || weakest->strength >= 1)
                return limbs;
            alive_[weakest->chord.triangle][weakest->chord.edge] = false;
        }
    }

private:
    int count(std::uint32_t triangle) const
    {
        auto const& chords = alive_[triangle];
        return chords[0] + chords[1] + chords[2];
    }

    // True if no junction triangle lies beyond the chord.
    bool is_limb(Chord chord) const
    {
        while (true) {
            auto const back = axis_.reversed(chord);
            auto const chords = count(back.triangle);
            if (chords != 2)
                return chords == 1;
            std::uint32_t edge = 0;
            while (edge == back.edge || !alive_[back.triangle][edge])
                ++edge;
            chord = { back.triangle, edge };
        }
    }

    std::vector<Limb> find_limbs()
    {
        std::vector<Limb> limbs;
        for (std::uint32_t k = 0; k < alive_.size(); ++k) {
            if (count(k) != 3)
                continue;
            for (std::uint32_t e = 0; e < 3; ++e)
                if (is_limb({ k, e }))
                    limbs.push_back({ { k, e }, strength({ k, e }) });
        }
        return limbs;
    }

    double strength(Chord chord)
    {
        auto& known = strength_[chord.triangle][chord.edge];
        if (known < 0) {
            double const least = std::max(thresholds_.rise_of_diagonal * diagonal_,
                                          thresholds_.rise_of_chord * axis_.length_of(chord));
            known = std::max(axis_.rise(chord), 0.0) / least;
        }
        return known;
    }

    ChordalAxis const& axis_;
    BumpThresholds thresholds_;
    double diagonal_;
    // For each edge of each triangle: false if it is a chord whose limb has been removed.
    std::vector<std::array<bool, 3>> alive_;
    // Cache of limb strengths; negative: not computed yet.
    std::vector<std::array<double, 3>> strength_;
};

// The first chord, from `base` outwards, whose half disc contains the outline beyond it.
Chord end_chord(ChordalAxis const& axis, Chord base)
{
    auto const points = axis.outline().size();
    while (!contains_cap(axis.outline(), axis.beyond(base))) {
        auto const next = axis.onward(base);
        if (next.empty())
            break;
        base = *std::max_element(next.begin(), next.end(), [&](Chord const& a, Chord const& b) {
            return axis.beyond(a).inner_count(points) < axis.beyond(b).inner_count(points);
        });
    }
    return base;
}

// The cap of an arc. Chords narrow evenly from both ends of the arc; the cap is beyond the first
// one whose half disc contains the outline beyond it.
Arc even_cap(std::span<Vec2 const> outline, Arc arc)
{
    // Points of the arc may be outside the half disc by this share of its radius.
    constexpr double kTremor = 0.02;
    constexpr std::size_t kMinInner = 3;
    auto const n = static_cast<std::uint32_t>(outline.size());
    while (arc.inner_count(n) > kMinInner && !contains_cap(outline, arc, kTremor))
        arc = { (arc.first + 1) % n, (arc.last + n - 1) % n };
    return arc;
}

Bump bump_beyond(ChordalAxis const& axis, Chord const& base, double strength,
                 BumpThresholds::Ends ends)
{
    auto const arc = axis.beyond(base);
    auto const cap = ends == BumpThresholds::Ends::Even ? even_cap(axis.outline(), arc)
                                                        : axis.beyond(end_chord(axis, base));
    return describe_bump(axis.outline(), arc, cap, strength);
}

// The two ends of an outline without junctions: the parts beyond its longest chord on either side.
std::vector<Bump> spindle_ends(ChordalAxis const& axis, BumpThresholds::Ends ends)
{
    std::optional<Chord> longest;
    for (std::uint32_t k = 0; k < axis.triangles().size(); ++k)
        for (std::uint32_t e = 0; e < 3; ++e)
            if (axis.triangles()[k].beyond[e] != kNoTriangle
                && (!longest || axis.length_of({ k, e }) > axis.length_of(*longest)))
                longest = Chord { k, e };
    if (!longest)
        return {};
    return { bump_beyond(axis, *longest, 0, ends),
             bump_beyond(axis, axis.reversed(*longest), 0, ends) };
}

} // namespace

bool contains_cap(std::span<Vec2 const> outline, Arc const& arc, double tolerance)
{
    Vec2 const middle = (outline[arc.first] + outline[arc.last]) / 2;
    double const reach = (outline[arc.last] - outline[arc.first]).norm() / 2 * (1 + tolerance);
    bool holds = true;
    for_inner_points(outline, arc, [&](Vec2 const& point) {
        holds = holds && (point - middle).squaredNorm() <= reach * reach;
    });
    return holds;
}

Bump describe_bump(std::span<Vec2 const> outline, Arc const& arc, Arc const& cap, double strength)
{
    auto const& a = outline[cap.first];
    auto const& b = outline[cap.last];
    double const half = (b - a).norm() / 2;
    Vec2 const middle = (a + b) / 2;
    Vec2 const outwards = direction_of(Vec2((b - a).y(), -(b - a).x()));
    Bump bump { .arc = arc,
                .cap = cap,
                .end = middle,
                .tangent = outwards,
                .radius = half,
                .tip = a,
                .strength = strength };
    double height = 0;
    Vec2 sum = a + b;
    double count = 2;
    for_inner_points(outline, bump.cap, [&](Vec2 const& point) {
        height = std::max(height, (point - middle).dot(outwards));
        sum += point;
        count += 1;
    });
    if (height < half && height > 0)
        bump.radius = std::min((half * half + height * height) / (2 * height), 4 * half);
    Vec2 const way = sum / count - middle;
    if (way.norm() > 1e-9)
        bump.tangent = direction_of(way);
    double farthest = -std::numeric_limits<double>::infinity();
    for_inner_points(outline, bump.cap, [&](Vec2 const& point) {
        double const far = (point - middle).dot(bump.tangent);
        if (far > farthest) {
            farthest = far;
            bump.tip = point;
        }
    });
    return bump;
}

std::vector<Bump> find_bumps(ChordalAxis const& axis, BumpThresholds const& thresholds)
{
    std::vector<Bump> bumps;
    for (auto const& limb : Pruner(axis, thresholds).run())
        bumps.push_back(bump_beyond(axis, limb.chord, limb.strength, thresholds.ends));
    if (bumps.empty())
        bumps = spindle_ends(axis, thresholds.ends);
    std::sort(bumps.begin(), bumps.end(),
              [](Bump const& a, Bump const& b) { return a.arc.first < b.arc.first; });
    return bumps;
}

} // namespace tractus::silhouette
