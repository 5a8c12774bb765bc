#include "engine/methods/silhouettes/sibling_style.h"

#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/styled_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace tractus::silhouette {

namespace {

// Maximum number of children of a branch that follows a sibling's style.
constexpr double kMaxOfSibling = 60;

Side other(Side side)
{
    return side == Side::Left ? Side::Right : Side::Left;
}

double angle_deg(Vec2 const& a, Vec2 const& b)
{
    return degrees(std::fabs(std::atan2(cross(a, b), a.dot(b))));
}

// The chord from which a branch's angle is measured (kAngleOver).
Vec2 start_of(Branch const& branch)
{
    Line const line(branch.line(17));
    return line.at(kAngleOver) - line.at(0);
}

// Hash of a branch's name (FNV-1a), as a seed that does not depend on other branches.
std::uint32_t number_for(std::string_view name)
{
    std::uint32_t hash = 2166136261u;
    for (auto const letter : name)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
    return hash;
}

BranchingAngles angles_of(ParentStyle const& style)
{
    std::vector<BranchingAngles::Sample> samples;
    for (auto const& child : style.children)
        samples.push_back({ child.u, child.angle_deg });
    return BranchingAngles(std::move(samples), kAngleOver);
}

// Blends the styles of the two sources on either side of a sibling.
class Mixed {
public:
    Mixed(std::span<ParentStyle const> sources, double t)
        : below_(&sources.front())
        , above_(&sources.back())
    {
        for (auto const& source : sources)
            if (source.t <= t)
                below_ = &source;
        for (auto source = sources.rbegin(); source != sources.rend(); ++source)
            if (source->t >= t)
                above_ = &*source;
        double const apart = above_->t - below_->t;
        share_ = apart > 0 ? std::clamp((t - below_->t) / apart, 0.0, 1.0) : 0;
        angles_.emplace(angles_of(*below_), angles_of(*above_));
    }

    // A number interpolated between both sources by the sibling's position along the trunk.
    template<typename Number> double mean(Number const& number) const
    {
        double const low = number(*below_);
        return low + share_ * (number(*above_) - low);
    }
    double angle_deg(double u) const
    {
        double const low = angles_->first.at_deg(u);
        return low + share_ * (angles_->second.at_deg(u) - low);
    }
    ParentStyle const& nearest() const { return share_ < 0.5 ? *below_ : *above_; }

private:
    ParentStyle const* below_;
    ParentStyle const* above_;
    double share_ = 0;
    std::optional<std::pair<BranchingAngles, BranchingAngles>> angles_;
};

std::vector<double> places_on(double length, Mixed const& style, std::uint64_t seed,
                              std::uint32_t number)
{
    double const first = style.mean([](ParentStyle const& one) { return one.unbranched(); });
    double const last = style.mean([](ParentStyle const& one) { return one.last(); });
    double const spacing = style.mean([](ParentStyle const& one) { return one.spacing; });
    double const deviation = style.mean([](ParentStyle const& one) { return one.deviation; });
    if (!(spacing > 0) || !(last > first))
        return { first };
    double const steps
        = std::clamp(std::round((last - first) * length / spacing), 1.0, kMaxOfSibling - 1);
    BranchStyle const places { .children = steps + 1,
                               .unbranched = first,
                               .spacing = (last - first) / steps,
                               .unevenness = std::min(deviation / spacing, kMaxUneven) };
    return StyledPlaces(places, Pattern::Even, seed, 1).next({ .number = number });
}

// Sides for `count` children. From the base on, the share of children on the left follows that of
// the source's children.
std::vector<Side> sides_for(std::size_t count, ParentStyle const& source)
{
    auto const n = source.children.size();
    std::vector<double> left_of_first { 0 };
    for (auto const& child : source.children)
        left_of_first.push_back(left_of_first.back() + (child.branch.path.side == Side::Left));
    std::vector<Side> sides;
    double left = 0;
    for (std::size_t k = 0; k < count; ++k) {
        double const so_far = static_cast<double>((k + 1) * n) / static_cast<double>(count);
        auto const whole = std::min(static_cast<std::size_t>(so_far), n - 1);
        double const wanted = left_of_first[whole]
            + (so_far - static_cast<double>(whole))
                * (left_of_first[whole + 1] - left_of_first[whole]);
        double const share = static_cast<double>(count) / static_cast<double>(n);
        bool const is_left = left + 0.5 <= wanted * share + 1e-9;
        left += is_left;
        sides.push_back(is_left ? Side::Left : Side::Right);
    }
    return sides;
}

// Index of the source's child nearest to position `u`, on the given side if there is one.
std::size_t nearest_child(ParentStyle const& source, double u, Side side)
{
    std::size_t best = 0;
    std::pair least(true, 1e300);
    for (std::size_t i = 0; i < source.children.size(); ++i) {
        auto const& child = source.children[i];
        std::pair const rank(child.branch.path.side != side, std::fabs(child.u - u));
        if (rank < least) {
            least = rank;
            best = i;
        }
    }
    return best;
}

// Scales the similarity, between a third and one and a half times `usual`, so that at most a tenth
// of the child's crown is outside the outline.
Similarity fitted(Similarity way, Branch const& child, std::vector<Vec2> const& outline,
                  double usual)
{
    constexpr double kLargest = 1.5;
    constexpr double kMin = 1.0 / 3;
    Vec2 const unit = way.turn;
    double low = kMin * usual;
    double high = kLargest * usual;
    for (int i = 0; i < 8; ++i) {
        double const middle = (low + high) / 2;
        way.turn = middle * unit;
        std::size_t outside = 0;
        std::size_t tried = 0;
        for (std::size_t c = 0; c < child.crown.size(); c += 2, ++tried)
            outside += !is_inside(outline, way.point(child.crown[c]));
        (10 * outside <= tried ? low : high) = middle;
    }
    way.turn = low * unit;
    return way;
}

// A copy of a source's child, placed on a sibling at position `u`.
Branch copied(Branch const& child, Similarity const& way, Side side, double u)
{
    Branch copy { .origin = Branch::Origin::Copy, .path = child.path };
    copy.path.curve = way.cubic(child.path.curve);
    copy.path.side = side;
    copy.path.t = u;
    copy.path.trunk_sample = static_cast<std::size_t>(
        std::lround(std::clamp(u, 0.0, 1.0) * static_cast<double>(kTrunkSamples - 1)));
    copy.path.length *= way.turn.norm();
    copy.crown = way.points(child.crown);
    copy.stroke = way.points(child.stroke);
    if (child.leaf)
        copy.leaf = moved(*child.leaf, way);
    copy.cone_deg = child.cone_deg;
    return copy;
}

// The similarity from an earlier copy of a child to a later one.
Similarity between(Branch const& one, Branch const& another)
{
    Vec2 const from = one.path.curve.end - one.path.curve.base;
    Vec2 const to = another.path.curve.end - another.path.curve.base;
    bool const mirrors = one.path.side != another.path.side;
    return { .from = one.path.curve.base,
             .to = another.path.curve.base,
             .turn = turn_between(from, to, mirrors) / std::max(from.squaredNorm(), 1e-300),
             .mirrors = mirrors };
}

} // namespace

double ParentStyle::mean_angle_deg() const
{
    double sum = 0;
    for (auto const& child : children)
        sum += child.angle_deg;
    return sum / static_cast<double>(std::max<std::size_t>(children.size(), 1));
}

ParentStyle parent_style(Branch const& parent, BranchingSystem const& system)
{
    Line const line(system.whole_trunk());
    ParentStyle style { .t = parent.path.t,
                        .side = parent.path.side,
                        .length = line.length(),
                        .is_of_own_outline = system.is_of_own_outline };
    for (auto const& branch : system.branches) {
        if (branch.origin == Branch::Origin::Apex)
            continue;
        auto const& own = branch.model ? system.branches[*branch.model] : branch;
        Vec2 const start = branch.model ? branch.from_model.vector(start_of(own)) : start_of(own);
        double const u = line.place_of(branch.path.curve.base);
        auto child = branch;
        if (branch.model) // The copy's model will not exist in the sibling's system.
            child.stroke = branch.from_model.points(own.stroke);
        child.model.reset();
        style.children.push_back({ u, angle_deg(line.direction(u), start), std::move(child) });
    }
    std::stable_sort(style.children.begin(), style.children.end(),
                     [](auto const& a, auto const& b) { return a.u < b.u; });
    auto const n = style.children.size();
    if (n < 2)
        return style;
    style.spacing = (style.last() - style.unbranched()) * style.length / static_cast<double>(n - 1);
    double squares = 0;
    for (std::size_t i = 1; i < n; ++i)
        squares += std::pow(
            (style.children[i].u - style.children[i - 1].u) * style.length - style.spacing, 2);
    style.deviation = std::sqrt(squares / static_cast<double>(n - 1));
    return style;
}

void take_style(BranchingSystem& system, Branch const& parent, std::span<ParentStyle const> sources,
                std::uint64_t seed)
{
    Mixed const style(sources, parent.path.t);
    auto const& source = style.nearest();
    Line const line(system.whole_trunk());
    auto const places = places_on(line.length(), style, seed, number_for(name_of(parent)));
    auto const sides = sides_for(places.size(), source);
    double const usual = line.length() / source.length;
    bool const is_mirrored = parent.path.side != source.side;
    std::vector<Branch> branches;
    // Index of the first copy of each source child.
    std::map<std::size_t, std::size_t> first_of;
    for (std::size_t k = 0; k < places.size(); ++k) {
        double const u = places[k];
        auto const number = nearest_child(source, u, sides[k]);
        auto const& child = source.children[number].branch;
        auto const side = is_mirrored ? other(sides[k]) : sides[k];
        bool const mirrors = child.path.side != side;
        Vec2 const start = turned(line.direction(u), sign_of(side) * radians(style.angle_deg(u)));
        Similarity const way { .from = child.path.curve.base,
                               .to = line.at(u),
                               .turn = turn_between(direction_of(start_of(child)), start, mirrors),
                               .mirrors = mirrors };
        auto copy = copied(child, fitted(way, child, system.outline, usual), side, u);
        copy.number = 2 * k + (side == Side::Right ? 1 : 0);
        auto const [first, is_new] = first_of.emplace(number, k);
        if (!is_new) {
            copy.model = first->second;
            copy.from_model = between(branches[first->second], copy);
        }
        branches.push_back(std::move(copy));
    }
    if (system.has_apex_branch()) {
        branches.push_back(system.branches.back());
        auto const count = branches.size();
        if (count > 1 && branches[count - 2].leaf)
            take_leaf(branches.back(), branches[count - 2], system.outline);
    }
    system.branches = std::move(branches);
    system.coverage_after = coverage_of(system);
    system.is_of_own_outline = source.is_of_own_outline;
    system.is_in_siblings_style = true;
}

void take_leaf(Branch& branch, Branch const& source, std::span<Vec2 const> outline)
{
    constexpr int kTries = 8;
    // Ratio of the scales of successive tries; after all of them the scale is about a third.
    constexpr double kSmaller = 0.87;
    auto const& leaf = *source.leaf;
    auto way = between(source, branch);
    way.from = leaf.base;
    way.to = Line(branch.line(17)).at(leaf.stalk);
    way.turn *= std::min(1.0, 1 / std::max(way.turn.norm(), 1e-300));
    auto crown = way.points(source.crown);
    for (int i = 0; i < kTries; ++i) {
        auto const outside = std::count_if(crown.begin(), crown.end(), [&](Vec2 const& point) {
            return !is_inside(outline, point);
        });
        if (10 * static_cast<std::size_t>(outside) <= crown.size())
            break;
        way.turn *= kSmaller;
        crown = way.points(source.crown);
    }
    branch.leaf = moved(leaf, way);
    branch.crown = std::move(crown);
    branch.model.reset();
    branch.from_model = {};
}

void spread_leaves(BranchingSystem& system, std::function<bool(Branch const&)> const& may)
{
    std::vector<Branch> examples;
    for (auto const& branch : system.branches)
        if (branch.style_to != StyleScope::None)
            examples.push_back(branch);
    auto const is_leaf = [](Branch const& branch) { return branch.leaf.has_value(); };
    if (std::none_of(examples.begin(), examples.end(), is_leaf))
        return;
    for (auto& branch : system.branches) {
        if (branch.is_refined() || !may(branch))
            continue;
        auto const nearest
            = std::min_element(examples.begin(), examples.end(), [&](auto const& a, auto const& b) {
                  return std::fabs(a.path.t - branch.path.t) < std::fabs(b.path.t - branch.path.t);
              });
        if (nearest->leaf)
            take_leaf(branch, *nearest, system.outline);
    }
    system.coverage_after = coverage_of(system);
}

bool has_only_leaves(BranchingSystem const& system)
{
    return !system.branches.empty()
        && std::all_of(system.branches.begin(), system.branches.end(),
                       [](Branch const& branch) { return branch.leaf.has_value(); });
}

} // namespace tractus::silhouette
