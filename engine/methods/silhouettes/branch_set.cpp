#include "engine/methods/silhouettes/branch_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

// Largest scale of an added branch relative to the branch that it copies.
constexpr double kLargestAdded = 1.5;
// Largest scale by which a visible branch is stretched as it rotates out of the plane.
constexpr double kMaxTurned = 1.41;
// A visible branch may reach this multiple of the crown surface's distance from the trunk.
constexpr double kOverSurface = 1.02;
constexpr double kOutlined_deg = 10; // Limit of rotation for a branch with a drawn outline, which
                                     // must stay visible in the drawing plane.

// Greatest rotation of a visible branch out of the plane, degrees. `span` is the distance of the
// branch's end from the trunk, `greatest` the greatest such distance. Branches that reach far
// rotate less, so that the outline keeps its shape.
double most_off_deg(double span, double greatest)
{
    constexpr double kShort_deg = 45;
    constexpr double kLong_deg = 20;
    double const share = greatest > 0 ? std::min(1.0, span / greatest) : 0;
    return kShort_deg + (kLong_deg - kShort_deg) * share;
}

struct Scales {
    double low;
    double high;
    double surface; // Factor by which the crown surface's section is widened.
};

// The largest scale, in the range of `scales`, at which the branch's own crown is inside the
// surface of the system's crown.
double largest_inside(BranchSetMaker::Model const& model, Branch const& branch, Similarity way,
                      double theta_deg, Scales scales)
{
    auto section = model.surface.section(theta_deg);
    for (auto& point : section)
        point.x() *= scales.surface;
    Vec2 const unit = way.turn.normalized();
    double const sign = branch.path.side == Side::Left ? -1 : 1;
    auto const is_in = [&](Vec2 const& point) {
        Vec2 at = model.surface.to_trunk(way.point(point));
        at.x() *= sign;
        return is_inside(section, at);
    };
    for (int i = 0; i < 10; ++i) {
        double const middle = (scales.low + scales.high) / 2;
        way.turn = middle * unit;
        // A tenth of the sampled points may be outside, because a crown can touch the surface with
        // a corner.
        std::size_t outside = 0;
        std::size_t tried = 0;
        for (std::size_t c = 0; c < branch.crown.size(); c += 3, ++tried)
            outside += !is_in(branch.crown[c]);
        (10 * outside <= tried ? scales.low : scales.high) = middle;
    }
    return scales.low;
}

// Ratio of the largest size that the branch's crown can have at an azimuth to its largest size on
// its own side of the plane; only used with a drawn surface.
double widening(BranchSetMaker::Model const& model, Branch const& branch, double theta_deg)
{
    constexpr Scales kAny { 0.1, 6, kOverSurface };
    Vec2 const base = branch.path.curve.base;
    Similarity const as_it_is { .from = base, .to = base, .turn = Vec2::UnitX() };
    double const there = largest_inside(model, branch, as_it_is, theta_deg, kAny);
    double const side_deg = branch.path.side == Side::Left ? 180 : 0;
    return there / largest_inside(model, branch, as_it_is, side_deg, kAny);
}

// Sum over heights of squared distances from the trunk at an azimuth, proportional to the volume of
// a thin sector of the crown.
double area_at(CrownSurface const& surface, double theta_deg)
{
    constexpr int kHeights = 16;
    double area = 1e-12;
    for (int k = 1; k < kHeights; ++k) {
        double const r = surface.at(static_cast<double>(k) / kHeights, theta_deg).x();
        area += r * r;
    }
    return area;
}

// Limits the rotation of a branch that ends in the outline to azimuths where the crown is nearly as
// wide as in the plane. Otherwise the outline would look empty.
double most_off_deg_in(CrownSurface const& surface, double theta_deg, double most_deg)
{
    // Minimum area of a sector, as a share of that at theta_deg; corresponds to 0.87 of the width.
    constexpr double kMin = 0.75;
    constexpr double kStep_deg = 4;
    double const least = kMin * area_at(surface, theta_deg);
    double off_deg = 0;
    while (off_deg + kStep_deg <= most_deg
           && area_at(surface, theta_deg + off_deg + kStep_deg) >= least
           && area_at(surface, theta_deg - off_deg - kStep_deg) >= least)
        off_deg += kStep_deg;
    return off_deg + kStep_deg > most_deg ? most_deg : off_deg;
}

// Redistributes azimuths in proportion to the crown's volume there, so that wide sectors get more
// branches. In a round crown nothing changes.
class SpreadByArea {
public:
    explicit SpreadByArea(CrownSurface const& surface)
    {
        for (std::size_t i = 0; i < kSteps; ++i)
            sums_[i + 1]
                = sums_[i] + area_at(surface, (static_cast<double>(i) + 0.5) * 360 / kSteps);
    }

    double theta_deg(double evenly_deg) const
    {
        double const wanted = evenly_deg / 360 * sums_.back();
        auto const next = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, wanted);
        auto const i = static_cast<std::size_t>(next - sums_.begin()) - 1;
        double const share = (wanted - sums_[i]) / (sums_[i + 1] - sums_[i]);
        double const theta_deg = (static_cast<double>(i) + share) * 360 / kSteps;
        return theta_deg < 360 ? theta_deg : 0;
    }

private:
    static constexpr std::size_t kSteps = 72;
    std::array<double, kSteps + 1> sums_ {};
};

} // namespace

CrownSurface BranchSetMaker::surface_of(std::size_t index) const
{
    auto const& system = skeleton_.systems[index];
    return index == 0 && !skeleton_.surface.empty() ? CrownSurface(skeleton_.surface, system.trunk)
                                                    : CrownSurface(system.outline, system.trunk);
}

BranchSet BranchSetMaker::make(std::size_t index, LevelOptions const& options) const
{
    auto const& system = skeleton_.systems[index];
    BranchSet branch_set { .parent = Line(system.whole_trunk()), .branches = {} };
    auto const surface = surface_of(index);
    auto const drawn = drawn_places(branch_set.parent, surface, system);
    double first_u = 1;
    for (auto const& place : drawn)
        first_u = std::min(first_u, place.u);
    auto const added
        = static_cast<std::size_t>(std::lround(options.added * static_cast<double>(drawn.size())));
    auto const arrangement = arrange(
        drawn,
        { .pattern = options.pattern,
          .count = drawn.size() + added,
          .first_u = first_u,
          .proposals = options.proposals,
          .nodes = options.nodes },
        { .seed = options_.seed, .stream = 2, .substream = static_cast<std::uint32_t>(index) });
    Model const model { system, surface, drawn };
    // Where nodes are kept whole, a node keeps all of its branches even if the crown leaves hardly
    // any room for them.
    bool const is_whole
        = options.nodes == ArrangementOptions::Nodes::Whole && options.pattern != Pattern::Even;
    auto const smaller = is_whole ? Lean::Smaller::Least : Lean::Smaller::LeftOut;
    // Redistributes azimuths; used only without a pattern, because patterns keep their angles.
    std::optional<SpreadByArea> spread;
    if (surface.is_drawn() && options.pattern == Pattern::Even)
        spread.emplace(surface);
    for (std::size_t i = 0; i < arrangement.places.size(); ++i) {
        auto place = arrangement.places[i];
        if (i < drawn.size()) {
            place_in_plane(branch_set, model, i, place);
            continue;
        }
        if (spread)
            place.theta_deg = spread->theta_deg(place.theta_deg);
        if (auto const nearest = nearest_drawn(model, place))
            place_added_branch(branch_set, model, place, *nearest,
                               lean_of(system.branches[*nearest], place, smaller));
    }
    finish(branch_set, system);
    return branch_set;
}

// Adds the apex branch, if there is one, and sorts the branches by u.
void BranchSetMaker::finish(BranchSet& branch_set, BranchingSystem const& system)
{
    if (system.has_apex_branch())
        branch_set.branches.push_back({ system.branches.size() - 1, "apex", 1, 0, {} });
    std::stable_sort(
        branch_set.branches.begin(), branch_set.branches.end(),
        [](PositionedBranch const& a, PositionedBranch const& b) { return a.u < b.u; });
}

// Positions of all branches visible in the plane except the apex.
std::vector<DrawnPlace> BranchSetMaker::drawn_places(Line const& parent,
                                                     CrownSurface const& surface,
                                                     BranchingSystem const& system)
{
    std::array<double, 2> greatest {};
    auto const span = [&](Branch const& branch) {
        return std::fabs(surface.to_trunk(branch.path.curve.end).x());
    };
    auto const flat = system.branches.size() - (system.has_apex_branch() ? 1 : 0);
    for (std::size_t i = 0; i < flat; ++i) {
        auto const& branch = system.branches[i];
        auto& most = greatest[branch.path.side == Side::Left];
        most = std::max(most, span(branch));
    }
    std::vector<DrawnPlace> drawn;
    for (std::size_t i = 0; i < flat; ++i) {
        auto const& branch = system.branches[i];
        bool const is_left = branch.path.side == Side::Left;
        double off_deg = most_off_deg(span(branch), greatest[is_left]);
        if (branch.is_stroke() || !branch.own_branches.empty())
            off_deg = 0; // Branches drawn as strokes stay in the plane of the drawing.
        else if (branch.is_outlined())
            off_deg = kOutlined_deg;
        if (surface.is_drawn())
            off_deg = most_off_deg_in(surface, is_left ? 180 : 0, off_deg);
        drawn.push_back({ .u = parent.place_of(branch.path.curve.base),
                          .theta_deg = is_left ? 180.0 : 0.0,
                          .most_off_deg = off_deg,
                          .keeps_u = branch.is_user_drawn() });
    }
    return drawn;
}

// Adds a visible branch with its base at the position `moves_to` along the parent.
void BranchSetMaker::stand(BranchSet& branch_set, Model const& model, std::size_t i,
                           Place const& place, double moves_to)
{
    auto const& branch = model.system.branches[i];
    Vec2 const base = branch.path.curve.base;
    double const off = radians(place.theta_deg - model.drawn[i].theta_deg);
    double const longer = std::min(kMaxTurned, 1 / std::max(0.1, std::cos(off)));
    Similarity way { .from = base, .to = base, .turn = Vec2(longer, 0) };
    Vec2 as_it_is = Vec2::UnitX();
    if (moves_to != place.u) {
        // The branch's end stays where it is, on the outline.
        way = similarity_to_end(branch, branch_set.parent.at(moves_to));
        as_it_is = way.turn;
        way.turn *= longer;
    }
    bool const may_change
        = model.surface.is_drawn() && !branch.is_stroke() && branch.own_branches.empty();
    if (may_change) {
        double const size = as_it_is.norm();
        double const wider = widening(model, branch, place.theta_deg);
        way.turn = largest_inside(model, branch, way, place.theta_deg,
                                  { std::min(1.0, wider) * size, std::max(longer, wider) * size,
                                    kOverSurface })
            * direction_of(as_it_is);
    } else if (longer > 1) {
        double const size = as_it_is.norm();
        way.turn = largest_inside(model, branch, way, place.theta_deg,
                                  { size, longer * size, kOverSurface })
            * direction_of(as_it_is);
    }
    branch_set.branches.push_back({ i, name_of(branch), moves_to, place.theta_deg, way });
}

// Adds a visible branch that may have moved to a node. The branch's end stays where it is, unless
// that would change its length or direction too much; then it is placed like an added branch.
void BranchSetMaker::place_in_plane(BranchSet& branch_set, Model const& model, std::size_t i,
                                    Place const& place) const
{
    constexpr double kMaxStretched = 1.3;
    constexpr double kMaxTurned_deg = 25;
    auto const& branch = model.system.branches[i];
    double const as_inferred = model.drawn[i].u;
    auto const way = similarity_to_end(branch, branch_set.parent.at(place.u));
    double const size = way.turn.norm();
    double const turned_deg = degrees(std::fabs(std::atan2(way.turn.y(), way.turn.x())));
    bool const keeps_end = place.u == as_inferred
        || (size < kMaxStretched && 1 < kMaxStretched * size && turned_deg < kMaxTurned_deg);
    if (keeps_end) {
        stand(branch_set, model, i, { as_inferred, place.theta_deg }, place.u);
        return;
    }
    place_added_branch(branch_set, model, place, i, lean_of(branch, place, Lean::Smaller::Least));
    branch_set.branches.back().name = name_of(branch);
}

BranchSetMaker::Lean BranchSetMaker::lean_of(Branch const& branch, Place const& place,
                                             Lean::Smaller smaller) const
{
    return { .from = branch.path.curve.base_tangent,
             .angle_deg = options_.angles.at_deg(place.u),
             .smaller = smaller };
}

void BranchSetMaker::place_added_branch(BranchSet& branch_set, Model const& model,
                                        Place const& place, std::size_t nearest, Lean const& lean)
{
    auto const& branch = model.system.branches[nearest];
    Vec2 const along = branch_set.parent.direction(place.u);
    Vec2 const start = turned(along, sign_of(branch.path.side) * radians(lean.angle_deg));
    Vec2 const from = direction_of(lean.from);
    Vec2 const unit(start.dot(from), cross(from, start));
    Similarity way { .from = branch.path.curve.base,
                     .to = branch_set.parent.at(place.u),
                     .turn = unit };
    double largest = kLargestAdded;
    if (model.surface.is_drawn())
        largest *= std::max(1.0, widening(model, branch, place.theta_deg));
    double size = largest_inside(model, branch, way, place.theta_deg, { 0, largest, 1 });
    if (size < lean.least && lean.smaller == Lean::Smaller::LeftOut)
        return;
    size = std::max(size, lean.least);
    way.turn = size * unit;
    branch_set.branches.push_back(
        { nearest, name_of_added_branch(branch_set, place), place.u, place.theta_deg, way });
}

// Names an added branch after its rounded position. A change redistributes all added branches; the
// one that is then at this position gets this name.
std::string BranchSetMaker::name_of_added_branch(BranchSet const& branch_set, Place const& place)
{
    constexpr double kSteps = 12; // Resolution of the names, along the parent and around it.
    auto const name = fmt::format("a{}.{}", std::lround(place.u * kSteps),
                                  std::lround(place.theta_deg / 360 * kSteps) % 12);
    auto const taken = [&](std::string const& other) {
        return std::any_of(branch_set.branches.begin(), branch_set.branches.end(),
                           [&](PositionedBranch const& one) { return one.name == other; });
    };
    auto unique = name;
    for (int n = 2; taken(unique); ++n)
        unique = fmt::format("{}.{}", name, n);
    return unique;
}

std::optional<std::size_t> BranchSetMaker::nearest_drawn(Model const& model, Place const& place)
{
    bool const is_right = std::cos(radians(place.theta_deg)) >= 0;
    std::optional<std::size_t> best;
    double least = 1e300;
    for (std::size_t i = 0; i < model.drawn.size(); ++i) {
        bool const same = (model.drawn[i].theta_deg < 90) == is_right;
        double const far = std::fabs(model.drawn[i].u - place.u) + (same ? 0 : 1);
        if (far < least) {
            least = far;
            best = i;
        }
    }
    return best;
}

// The similarity that moves a branch's base to `from` and leaves its end where it is.
Similarity BranchSetMaker::similarity_to_end(Branch const& branch, Vec2 const& from)
{
    auto const& curve = branch.path.curve;
    Vec2 const before = curve.end - curve.base;
    Vec2 const after = curve.end - from;
    Vec2 const turn(before.dot(after), cross(before, after));
    return { .from = curve.base,
             .to = from,
             .turn = turn / std::max(before.squaredNorm(), 1e-300) };
}

std::vector<Vec2> BranchSetMaker::line_of(Branch const& model, std::size_t below) const
{
    return below == kNoSystem ? model.line(9) : skeleton_.systems[below].whole_trunk();
}

} // namespace tractus::silhouette
