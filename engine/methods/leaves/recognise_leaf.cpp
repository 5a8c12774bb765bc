#include "engine/methods/leaves/drawing_plane.h"
#include "engine/methods/leaves/find_leaflets.h"
#include "engine/methods/leaves/find_outline.h"
#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace tractus::leaf {

std::string_view name_of(StrokeRole role)
{
    switch (role) {
    case StrokeRole::Outline:
        return "margin";
    case StrokeRole::Midrib:
        return "midrib";
    case StrokeRole::MainVein:
        return "main vein";
    case StrokeRole::SideVein:
        return "side vein";
    case StrokeRole::Stalk:
        return "stalk";
    case StrokeRole::Rachis:
        return "rachis";
    case StrokeRole::FinerVein:
        break;
    }
    return "finer vein";
}

namespace {

constexpr std::size_t kMaxStrokes = 300;
constexpr double kMinStroke_mm = 2;
constexpr double kStep_mm = 0.5;

class VeinRecogniser {
public:
    VeinRecogniser(std::vector<std::vector<Vec3>> lines,
                   std::vector<std::vector<Vec3>> const& drawn)
        : lines_(std::move(lines))
        , drawn_(drawn)
        , plane_(lines_)
    {
        for (auto const& line : lines_) {
            flat_.emplace_back();
            for (auto const& point : line)
                flat_.back().push_back(plane_.flat(point));
        }
        roles_.resize(lines_.size());
    }

    Result<RecognisedLeaf> recognise()
    {
        outline_ = TRY(find_outline(flat_));
        for (auto const stroke : outline_.strokes)
            roles_[stroke] = StrokeRole::Outline;
        close_ring();
        find_stalk();
        TRY(find_midrib());
        orient_midrib();
        find_mains();
        TRY(find_sides());
        return result();
    }

private:
    // Maximum imbalance() of a stroke that is a midrib.
    static constexpr double kMaxImbalance = 0.5;

    struct Attached {
        double distance = std::numeric_limits<double>::infinity();
        std::size_t parent = 0;
        // True if the stroke was drawn towards the parent: its end, not its beginning, is there.
        bool by_its_end = false;
    };

    bool is_free(std::size_t stroke) const { return !roles_[stroke]; }

    // Describes a stroke, for messages, by its number and its starting point.
    std::string name_stroke(std::size_t stroke) const
    {
        auto const& at = drawn_[stroke].front();
        return fmt::format("stroke {}, which begins at ({:.0f}, {:.0f}, {:.0f}) mm", stroke + 1,
                           at.x(), at.y(), at.z());
    }

    // Makes the closed outline `ring_`. If only one half was drawn, its mirror image closes it.
    void close_ring()
    {
        for (auto const& [stroke, point] : outline_.line)
            ring_.push_back(flat_[stroke][point]);
        if (outline_.edge == RecognisedLeaf::Edge::OneHalf) {
            Vec2 const from = ring_.front();
            Vec2 const axis = (ring_.back() - from).normalized();
            for (std::size_t i = ring_.size() - 1; i-- > 1;) {
                Vec2 const at = ring_[i] - from;
                ring_.push_back(from + 2 * at.dot(axis) * axis - at);
            }
        }
        extent_ = extent_of(ring_);
    }

    double tolerance_mm() const { return std::max(3.0, 0.035 * extent_); }

    // Finds the stalk: a stroke that lies outside the outline and has one end on it.
    void find_stalk()
    {
        for (std::size_t i = 0; i < flat_.size() && !stalk_; ++i) {
            if (!is_free(i) || outline_.midrib == i)
                continue;
            auto const inside = std::ranges::count_if(
                flat_[i], [&](Vec2 const& at) { return is_inside(ring_, at); });
            auto const away = [&](Vec2 const& at) { return distance_to_ring(at); };
            double const nearest = std::min(away(flat_[i].front()), away(flat_[i].back()));
            double const farthest = std::max(away(flat_[i].front()), away(flat_[i].back()));
            if (double(inside) < 0.3 * double(flat_[i].size()) && nearest < tolerance_mm()
                && farthest > tolerance_mm())
                stalk_ = i;
        }
        if (stalk_)
            roles_[*stalk_] = StrokeRole::Stalk;
    }

    double distance_to_ring(Vec2 const& at) const
    {
        return std::min(nearest_on(ring_, at).distance,
                        nearest_on(std::vector { ring_.back(), ring_.front() }, at).distance);
    }

    // True if the stroke with the index `other` begins or ends on `line`.
    bool touches(std::size_t other, FlatLine const& line) const
    {
        return std::min(nearest_on(line, flat_[other].front()).distance,
                        nearest_on(line, flat_[other].back()).distance)
            < tolerance_mm();
    }

    // Score of a stroke as a midrib: high if it is long, divides the leaf into equal halves and
    // touches many veins.
    double midrib_score(std::size_t stroke) const
    {
        double touching = 0;
        double others = 0;
        for (std::size_t i = 0; i < flat_.size(); ++i)
            if (i != stroke && is_free(i)) {
                ++others;
                touching += touches(i, flat_[stroke]) ? 1 : 0;
            }
        return (others > 0 ? touching / others : 0) - 2 * imbalance(stroke)
            + 0.5 * length_of(flat_[stroke]) / extent_;
    }

    // Returns the difference between the leaf's areas on the two sides of a stroke, as a share of
    // the whole area. The areas are divided by the straight line through the stroke's ends. If they
    // differ too much for a midrib and the stroke reaches from margin to margin, they are divided
    // by the stroke itself.
    double imbalance(std::size_t stroke) const
    {
        auto const& line = flat_[stroke];
        double const straight
            = std::abs(2 * area_share_left_of(ring_, line.front(), line.back()) - 1);
        return straight < kMaxImbalance || !spans_leaf(line) ? straight
                                                             : std::abs(2 * share_along(line) - 1);
    }

    // True if a line reaches from margin to margin.
    bool spans_leaf(FlatLine const& line) const
    {
        auto const reaches = [&](Vec2 const& at) {
            return !is_inside(ring_, at) || distance_to_ring(at) < 2 * tolerance_mm();
        };
        return reaches(line.front()) && reaches(line.back());
    }

    // Share of the leaf's area on one side of a line from margin to margin, however the line bends.
    double share_along(FlatLine const& line) const
    {
        double const from = nearest_on(ring_, line.front()).along;
        double const to = nearest_on(ring_, line.back()).along;
        auto const n = ring_.size();
        auto const first = static_cast<std::size_t>(std::ceil(from)) % n;
        auto const last = static_cast<std::size_t>(std::ceil(to)) % n;
        FlatLine side;
        for (auto i = first; i != last; i = (i + 1) % n)
            side.push_back(ring_[i]);
        side.insert(side.end(), line.rbegin(), line.rend());
        double const whole = std::abs(area_of(ring_));
        return whole > 0 ? std::min(1.0, std::abs(area_of(side)) / whole) : 0;
    }

    Result<void> find_midrib()
    {
        // Smallest length of a midrib, as a share of the outline's extent.
        constexpr double kMinLength = 0.35;
        auto found = outline_.midrib;
        double best = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < flat_.size() && !outline_.midrib; ++i)
            if (is_free(i) && length_of(flat_[i]) > kMinLength * extent_
                && imbalance(i) < kMaxImbalance && midrib_score(i) > best) {
                best = midrib_score(i);
                found = i;
            }
        if (!found)
            return fail(Fault::User,
                        "there is no midrib: draw the vein that halves the leaf, from the stalk to "
                        "the tip");
        midrib_ = *found;
        roles_[midrib_] = StrokeRole::Midrib;
        return {};
    }

    // Number of points of a line before it first enters the outline.
    std::size_t points_outside(FlatLine const& line) const
    {
        auto const first
            = std::ranges::find_if(line, [&](Vec2 const& at) { return is_inside(ring_, at); });
        return first == line.end() ? 0 : static_cast<std::size_t>(first - line.begin());
    }

    std::size_t strokes_ending_at(Vec2 const& place) const
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < flat_.size(); ++i)
            if (is_free(i)
                && std::min((flat_[i].front() - place).norm(), (flat_[i].back() - place).norm())
                    < hub_radius_mm())
                ++count;
        return count;
    }

    double hub_radius_mm() const { return std::max(2.0, 0.025 * extent_); }

    // Returns the sum of the side veins' leans: positive if they lean towards the end of the midrib
    // `rib`, negative if towards its beginning.
    double lean_forward(FlatLine const& rib) const
    {
        double sum = 0;
        Vec2 const along = (rib.back() - rib.front()).normalized();
        for (std::size_t i = 0; i < flat_.size(); ++i) {
            if (!is_free(i))
                continue;
            auto const& line = flat_[i];
            bool const begins_here
                = nearest_on(rib, line.front()).distance < nearest_on(rib, line.back()).distance;
            double const lean = (line.back() - line.front()).normalized().dot(along);
            sum += begins_here ? lean : -lean;
        }
        return sum;
    }

    // Reverses the midrib if necessary, so that it runs from base to tip.
    void orient_midrib()
    {
        auto const& rib = flat_[midrib_];
        FlatLine const reversed(rib.rbegin(), rib.rend());
        double const step = length_of(rib) / double(rib.size() - 1);
        double const before = step * double(points_outside(rib));
        double const behind = step * double(points_outside(reversed));
        auto const place_of = [&](FlatLine const& line) { return line[points_outside(line)]; };
        auto const hub_before = strokes_ending_at(place_of(rib));
        auto const hub_behind = strokes_ending_at(place_of(reversed));
        double const lean = lean_forward(rib);
        bool is_reversed = false;
        if (stalk_) {
            is_reversed = touches(*stalk_, { rib.back() }) && !touches(*stalk_, { rib.front() });
        } else if (std::abs(before - behind) > tolerance_mm()) {
            is_reversed = behind > before;
        } else if (std::max(hub_before, hub_behind) >= 2 && hub_before != hub_behind) {
            is_reversed = hub_behind > hub_before;
        } else if (std::abs(lean) > 0.3) {
            is_reversed = lean < 0;
        }
        if (is_reversed)
            reverse(midrib_);
        hub_ = find_hub();
    }

    void reverse(std::size_t stroke)
    {
        std::ranges::reverse(flat_[stroke]);
        std::ranges::reverse(lines_[stroke]);
    }

    // Finds the hub, the place where the main veins meet: where the midrib enters the blade or, if
    // at least three veins begin together a little above that point, there.
    Vec2 find_hub() const
    {
        auto const& rib = flat_[midrib_];
        Vec2 const base = rib[points_outside(rib)];
        Vec2 sum = Vec2::Zero();
        double count = 0;
        for (std::size_t i = 0; i < flat_.size(); ++i)
            if (is_free(i))
                for (auto const& end : { flat_[i].front(), flat_[i].back() })
                    if ((end - base).norm() < 0.1 * extent_
                        && nearest_on(rib, end).distance < hub_radius_mm()
                        && strokes_ending_at(end) >= 3) {
                        sum += end;
                        ++count;
                    }
        return count > 0 ? Vec2(sum / count) : base;
    }

    void find_mains()
    {
        mains_.push_back({ .stroke = midrib_, .parent = 0, .line = lines_[midrib_] });
        for (std::size_t i = 0; i < flat_.size(); ++i) {
            if (!is_free(i))
                continue;
            double const begin = (flat_[i].front() - hub_).norm();
            double const end = (flat_[i].back() - hub_).norm();
            if (std::min(begin, end) > hub_radius_mm())
                continue;
            if (end < begin)
                reverse(i);
            roles_[i] = StrokeRole::MainVein;
            mains_.push_back({ .stroke = i, .parent = mains_.size(), .line = lines_[i] });
        }
    }

    Attached attached(std::size_t stroke, std::vector<RecognisedLeaf::Vein> const& parents) const
    {
        Attached best;
        for (std::size_t k = 0; k < parents.size(); ++k)
            for (bool const by_end : { false, true }) {
                auto const& end = by_end ? flat_[stroke].back() : flat_[stroke].front();
                double const distance = nearest_on(flat_[parents[k].stroke], end).distance;
                if (distance < best.distance)
                    best = { distance, k, by_end };
            }
        return best;
    }

    Result<void> find_sides()
    {
        for (std::size_t i = 0; i < flat_.size(); ++i) {
            if (!is_free(i))
                continue;
            auto const on = attached(i, mains_);
            if (on.distance > tolerance_mm())
                continue;
            if (on.by_its_end)
                reverse(i);
            roles_[i] = StrokeRole::SideVein;
            sides_.push_back({ .stroke = i, .parent = on.parent, .line = lines_[i] });
        }
        for (std::size_t i = 0; i < flat_.size(); ++i) {
            if (!is_free(i))
                continue;
            if (attached(i, sides_).distance > tolerance_mm())
                return fail(Fault::User,
                            fmt::format("{}, begins on no vein: draw veins from the midrib or "
                                        "another main vein on",
                                        name_stroke(i)));
            roles_[i] = StrokeRole::FinerVein;
        }
        return {};
    }

    RecognisedLeaf result() const
    {
        RecognisedLeaf made { .edge = outline_.edge, .normal = plane_.normal };
        for (auto const& role : roles_)
            made.roles.push_back(*role);
        for (auto const& [stroke, point] : outline_.line)
            made.outline.push_back(lines_[stroke][point]);
        bool const is_downwards = made.edge == RecognisedLeaf::Edge::OneHalf
            && (made.outline.front() - mains_[0].line.front()).norm()
                > (made.outline.back() - mains_[0].line.front()).norm();
        if (is_downwards)
            std::ranges::reverse(made.outline);
        made.mains = mains_;
        made.sides = sides_;
        if (stalk_)
            made.stalk = lines_[*stalk_];
        return made;
    }

    std::vector<std::vector<Vec3>> lines_;
    std::vector<std::vector<Vec3>> const& drawn_;
    DrawingPlane plane_;
    std::vector<FlatLine> flat_;
    std::vector<std::optional<StrokeRole>> roles_;
    FoundOutline outline_;
    FlatLine ring_;
    double extent_ = 0;
    std::optional<std::size_t> stalk_;
    std::size_t midrib_ = 0;
    Vec2 hub_ = Vec2::Zero();
    std::vector<RecognisedLeaf::Vein> mains_;
    std::vector<RecognisedLeaf::Vein> sides_;
};

// Recognises one leaflet. Strokes without which it is no leaf, a midrib and a stalk on the side of
// the rachis, are added if they were not drawn. If the lines in it are no veins, only its outline
// counts.
Result<RecognisedLeaf> recognise_leaflet(std::vector<std::vector<Vec3>> const& lines,
                                         Leaflet const& leaflet, bool with_veins)
{
    std::vector<std::size_t> strokes { leaflet.outline };
    if (with_veins)
        strokes.insert(strokes.end(), leaflet.veins.begin(), leaflet.veins.end());
    std::vector<std::vector<Vec3>> own;
    for (auto const stroke : strokes)
        own.push_back(lines[stroke]);
    own.push_back(leaflet.stalk);
    auto const drawn = own;
    auto seen = VeinRecogniser(own, drawn).recognise();
    if (!seen) {
        own.push_back(leaflet.axis);
        auto const guessed = own;
        seen = VeinRecogniser(own, guessed).recognise();
    }
    if (!seen)
        return seen;
    // The added midrib counts as a part of the outline's stroke.
    auto const stroke_of = [&](std::size_t number) {
        return number < strokes.size() ? strokes[number] : leaflet.outline;
    };
    for (auto* const veins : { &seen->mains, &seen->sides })
        for (auto& vein : *veins)
            vein.stroke = stroke_of(vein.stroke);
    seen->roles.resize(strokes.size());
    seen->stalk.clear();
    return seen;
}

Result<RecognisedLeaf> recognise_compound(std::vector<std::vector<Vec3>> const& lines,
                                          LeafDrawing const& drawing, FoundLeaflets const& found)
{
    RecognisedLeaf made { .normal = DrawingPlane(lines).normal };
    made.roles.assign(drawing.strokes.size(), StrokeRole::FinerVein);
    made.roles[found.rachis] = StrokeRole::Rachis;
    made.rachis = found.rachis_line;
    for (auto const stalk : found.stalks)
        made.roles[stalk] = StrokeRole::Stalk;
    for (auto const& leaflet : found.leaflets) {
        auto seen = recognise_leaflet(lines, leaflet, true);
        if (!seen)
            seen = recognise_leaflet(lines, leaflet, false);
        if (!seen)
            return fail(Fault::User,
                        fmt::format("stroke {} is no leaflet: {}", leaflet.outline + 1,
                                    seen.error().message));
        made.roles[leaflet.outline] = StrokeRole::Outline;
        for (std::size_t i = 1; i < seen->roles.size(); ++i)
            made.roles[leaflet.veins[i - 1]] = seen->roles[i];
        made.leaflets.push_back(*std::move(seen));
    }
    return made;
}

// Resamples a stroke at even distances. Fails with a user error if its points cannot be used; the
// message contains the stroke's number.
Result<std::vector<Vec3>> even_line(std::vector<Vec3> const& stroke, std::size_t number)
{
    constexpr double kMaxPoints = 4000;
    constexpr double kLongest_mm = 1e5;
    auto const is_usable
        = [](Vec3 const& at) { return at.allFinite() && at.cwiseAbs().maxCoeff() < kLongest_mm; };
    if (stroke.empty() || !std::ranges::all_of(stroke, is_usable))
        return fail(Fault::User,
                    fmt::format("stroke {} has no points, or one that lies nowhere near: give "
                                "millimetres",
                                number));
    auto const points = distinct_points(stroke);
    double const length = points ? polyline_length_mm(*points) : 0;
    if (length < kMinStroke_mm || length > kLongest_mm)
        return fail(Fault::User,
                    fmt::format("stroke {} at ({:.0f}, {:.0f}, {:.0f}) mm is too {}: leave it "
                                "out, or draw it {} mm long and more",
                                number, stroke.front().x(), stroke.front().y(), stroke.front().z(),
                                length < kMinStroke_mm ? "short" : "long", kMinStroke_mm));
    auto const count = std::clamp(length / kStep_mm, 8.0, kMaxPoints);
    return resample(*points, static_cast<std::size_t>(count) + 1);
}

} // namespace

Result<RecognisedLeaf> recognise_leaf(LeafDrawing const& drawing)
{
    if (drawing.strokes.empty() || drawing.strokes.size() > kMaxStrokes)
        return fail(
            Fault::User,
            fmt::format("there are {} strokes: draw an outline, a midrib and side veins, at "
                        "most {} strokes",
                        drawing.strokes.size(), kMaxStrokes));
    std::vector<std::vector<Vec3>> lines;
    for (auto const& stroke : drawing.strokes)
        lines.push_back(TRY(even_line(stroke, lines.size() + 1)));
    if (drawing.may_be_compound) {
        auto const leaflets = TRY(find_leaflets(lines));
        if (!leaflets.empty())
            return recognise_compound(lines, drawing, leaflets);
    }
    return VeinRecogniser(std::move(lines), drawing.strokes).recognise();
}

} // namespace tractus::leaf
