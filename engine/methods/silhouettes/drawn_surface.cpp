#include "engine/methods/silhouettes/drawn_surface.h"

#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/monotone_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr double kAzimuthStep_deg = 360.0 / kAzimuths;

// Cap that closes the crown's profile beyond the profile's last known point. The square of the
// distance from the trunk continues as a parabola down to 0, so spheres, cones and shapes in
// between close exactly.
class Cap {
public:
    // `squares`: squared distances from the trunk at the profile's last point, and one and two
    // steps before that point. `height`: height of the cap; by default it ends where the parabola
    // reaches 0.
    Cap(std::array<double, 3> const& squares, double step, std::optional<double> height)
        : square_(std::max(squares[0], 1e-12))
    {
        double const radius = std::sqrt(square_);
        double curved = 0;
        if (step > 0) {
            curved = (squares[2] - 2 * squares[1] + squares[0]) / (2 * step * step);
            slope_ = (squares[0] - squares[1]) / step + curved * step;
        }
        // Minimum height of a cap, as a share of the last point's distance from the trunk.
        constexpr double kLowest = 0.3;
        // Height of a cap if the profile does not narrow towards its end, as a share of the last
        // point's distance from the trunk.
        constexpr double kFlat = 0.4;
        height_ = height.value_or(std::clamp(end_of(curved, kFlat * radius), kLowest * radius,
                                             std::max(radius, 1.5 * step)));
    }

    double height() const { return height_; }

    // Distance from the trunk at height `x` beyond the profile's last point, as a share of the
    // distance at the last point.
    double share(double x) const
    {
        double const curved = -(square_ + slope_ * height_) / (height_ * height_);
        return std::sqrt(std::max(0.0, square_ + slope_ * x + curved * x * x) / square_);
    }

private:
    // Height at which the parabola first reaches 0; `otherwise` if it does not.
    double end_of(double curved, double otherwise) const
    {
        if (std::fabs(curved) < 1e-12 * square_)
            return slope_ < 0 ? -square_ / slope_ : otherwise;
        double const inside = slope_ * slope_ - 4 * curved * square_;
        double const root = std::sqrt(std::max(0.0, inside));
        if (inside < -0.05 * slope_ * slope_ || (curved > 0 && slope_ >= 0))
            return otherwise;
        double const end = (-slope_ - root) / (2 * curved);
        return end > 0 ? end : otherwise;
    }

    double square_;
    double slope_ = 0;
    double height_;
};

// Distance from the trunk by height at one azimuth, known from height `low` to height `high`.
struct Profile {
    MonotoneCurve curve;
    double low;
    double high;
};

// Merges points (height, distance from the trunk) whose heights differ by at most `apart`.
std::vector<Vec2> merged_places(std::vector<Vec2> places, double apart)
{
    std::sort(places.begin(), places.end(),
              [](Vec2 const& a, Vec2 const& b) { return a.x() < b.x(); });
    std::vector<Vec2> result;
    std::size_t taken = 0; // Number of points merged into the last point of `result`.
    for (auto const& place : places) {
        if (!result.empty() && place.x() - result.back().x() <= apart) {
            ++taken;
            result.back() += (place - result.back()) / static_cast<double>(taken);
            continue;
        }
        result.push_back(place);
        taken = 1;
    }
    return result;
}

// Heights at which profiles end: at each profile's own first and last point, or at the same heights
// for all azimuths. Even is for climbing lines, which end at a different height at each azimuth.
enum class Ends { AsTheyAre, Even };

std::vector<Profile> profiles_of(Crossings const& crossings, double low, double high, Ends ends)
{
    // Heights closer than this share of the crown's height are merged.
    constexpr double kApart = 0.02;
    std::vector<Profile> profiles;
    for (auto const& places : crossings) {
        MonotoneCurve curve(merged_places(places, kApart * (high - low)));
        double const first = ends == Ends::Even ? low : curve.points().front().x();
        double const last = ends == Ends::Even ? high : curve.points().back().x();
        profiles.push_back({ std::move(curve), first, last });
    }
    return profiles;
}

// Mean squared distance from the trunk over all azimuths, at a share of each azimuth's known range
// of heights.
double mean_square(std::vector<Profile> const& profiles, double share)
{
    double sum = 0;
    for (auto const& profile : profiles) {
        double const radius
            = std::max(0.0, profile.curve.at(profile.low + share * (profile.high - profile.low)));
        sum += radius * radius;
    }
    return sum / static_cast<double>(profiles.size());
}

// Heights of the crown's lowest and highest point, if an outline gives them.
struct CrownRange {
    std::optional<double> low;
    std::optional<double> high;
};

// Builds the surface through all profiles, with a cap at its lower and its upper end.
class SurfaceBuilder {
public:
    SurfaceBuilder(std::vector<Profile> profiles, std::size_t lines, CrownRange const& range)
        : profiles_(std::move(profiles))
    {
        for (auto const& profile : profiles_) {
            low_ += profile.low / static_cast<double>(profiles_.size());
            high_ += profile.high / static_cast<double>(profiles_.size());
        }
        double const share = lines < 3 ? 1.0 : 1.0 / static_cast<double>(lines - 1);
        double const step = lines < 2 ? 0 : share * (high_ - low_);
        bottom_ = cap(step, share, 0, range.low ? std::optional(low_ - *range.low) : std::nullopt);
        top_ = cap(step, share, 1, range.high ? std::optional(*range.high - high_) : std::nullopt);
    }

    std::vector<Meridian> meridians() const
    {
        std::vector<Meridian> result;
        for (std::size_t azimuth = 0; azimuth < profiles_.size(); ++azimuth)
            result.push_back(
                { static_cast<double>(azimuth) * kAzimuthStep_deg, curve(profiles_[azimuth]) });
        return result;
    }

private:
    std::optional<Cap> cap(double step, double share, double end,
                           std::optional<double> height) const
    {
        auto const at = [&](int steps) {
            return mean_square(profiles_, std::fabs(end - std::min(1.0, steps * share)));
        };
        bool const has_three = share <= 0.5;
        double const last = at(0);
        double const before = at(1);
        // If the squared distance at the end is at most this share of the next one, the crown
        // already ends in a point and needs no cap.
        constexpr double kFlat = 1e-6;
        if (last <= kFlat * std::max({ last, before, 1e-12 }))
            return std::nullopt;
        if (height && *height <= 0)
            return std::nullopt;
        return Cap({ last, before, has_three ? at(2) : 2 * before - last }, step, height);
    }

    std::vector<Vec2> curve(Profile const& profile) const
    {
        constexpr int kInCap = 16;
        constexpr int kBetween = 96;
        std::vector<Vec2> points;
        double const first = std::max(0.0, profile.curve.at(profile.low));
        double const last = std::max(0.0, profile.curve.at(profile.high));
        double const bottom = low_ - (bottom_ ? bottom_->height() : 0);
        double const top = high_ + (top_ ? top_->height() : 0);
        points.emplace_back(0, std::min(bottom, profile.low));
        // Samples become denser towards the crown's lower end, where the surface closes quickly.
        for (int i = 1; bottom_ && i < kInCap; ++i) {
            double const x = std::cos(kPi / 2 * i / kInCap);
            points.emplace_back(first * bottom_->share(x * bottom_->height()),
                                profile.low + x * (points.front().y() - profile.low));
        }
        for (int i = 0; i <= kBetween; ++i) {
            double const h = profile.low + (profile.high - profile.low) * i / kBetween;
            points.emplace_back(std::max(0.0, profile.curve.at(h)), h);
        }
        double const end = std::max(top, profile.high);
        for (int i = kInCap - 1; top_ && i > 0; --i) {
            double const x = std::cos(kPi / 2 * i / kInCap);
            points.emplace_back(last * top_->share(x * top_->height()),
                                profile.high + x * (end - profile.high));
        }
        points.emplace_back(0, end);
        return resampled_line(points, CrownSurface::kPoints);
    }

    std::vector<Profile> profiles_;
    double low_ = 0; // Mean height of the profiles' lower ends.
    double high_ = 0;
    std::optional<Cap> bottom_;
    std::optional<Cap> top_;
};

double apart_deg(double a_deg, double b_deg)
{
    double const off_deg = a_deg - b_deg;
    return std::fabs(off_deg - 360 * std::round(off_deg / 360));
}

// Blends meridians towards the halves of outlines. At its own azimuth a half replaces the meridian;
// its influence ends at the next half's azimuth or after 45 degrees.
void pull(std::vector<Meridian>& meridians, std::vector<Meridian> const& halves)
{
    constexpr double kWidest_deg = 45;
    auto const as_it_was = meridians;
    for (auto const& half : halves) {
        double reach_deg = kWidest_deg;
        for (auto const& other : halves)
            if (&other != &half)
                reach_deg = std::min(reach_deg, apart_deg(half.theta_deg, other.theta_deg));
        for (std::size_t m = 0; m < meridians.size(); ++m) {
            double const off_deg = apart_deg(meridians[m].theta_deg, half.theta_deg);
            if (off_deg >= reach_deg)
                continue;
            double const c = std::cos(kPi / 2 * off_deg / reach_deg);
            for (std::size_t i = 0; i < half.curve.size(); ++i)
                meridians[m].curve[i] += c * c * (half.curve[i] - as_it_was[m].curve[i]);
        }
    }
}

// Prepares an outline in a vertical plane (clean_drawing()). The result is in the trunk's frame, as
// (distance along the plane, height).
Result<std::vector<Vec2>> clean_side(CrownLine const& side, TrunkFrame const& trunk,
                                     double theta_deg)
{
    Vec2 const along(std::cos(radians(theta_deg)), std::sin(radians(theta_deg)));
    std::vector<Vec2> flat;
    for (auto const& point : side) {
        Vec3 const at = trunk.of(point);
        flat.emplace_back(along.dot(at.head<2>()), at.z());
    }
    auto const box = box_of(flat);
    auto const clean = TRY(clean_drawing(
        { { flat }, { Vec2(0, box.low.y()), Vec2(0, std::max(box.high.y(), box.low.y() + 1)) } }));
    if (box.low.x() >= 0 || box.high.x() <= 0)
        return fail(Fault::User,
                    "an outline of the crown lies beside the trunk: draw it around that");
    return clean.to_sheet.points(clean.outline);
}

double top_of(std::vector<Vec2> const& outline)
{
    return box_of(outline).high.y();
}

// A trunk of length 1 for a drawing that has none: upright from `foot` or, by default, from a point
// below the crown.
std::vector<Vec2> upright_trunk(std::vector<CrownLine> const& lines,
                                std::optional<Vec2> const& foot)
{
    constexpr double kBare = 0.25;
    Vec2 low(0, 1e300);
    double high = -1e300;
    for (auto const& line : lines)
        for (auto const& point : line) {
            low.x() += point.x() / static_cast<double>(line.size() * lines.size());
            low.y() = std::min(low.y(), point.y());
            high = std::max(high, point.y());
        }
    Vec2 const begin = foot.value_or(Vec2(low.x(), low.y() - kBare * (high - low.y())));
    return { begin, begin + Vec2(0, 1) };
}

// The section of the surface with the sheet, counter-clockwise.
std::vector<Vec2> section_with_sheet(CrownSurface const& surface, TrunkFrame const& frame)
{
    constexpr auto kLast = CrownSurface::kPoints - 1;
    std::vector<Vec2> section;
    for (std::size_t i = 0; i <= kLast; ++i)
        section.push_back(frame.to_sheet(surface.at(static_cast<double>(i) / kLast, 0)));
    for (auto i = kLast; i-- > 1;) {
        Vec2 const left = surface.at(static_cast<double>(i) / kLast, 180);
        section.push_back(frame.to_sheet({ -left.x(), left.y() }));
    }
    return section;
}

} // namespace

Result<std::vector<Meridian>> meridians_of(std::vector<CrownLine> const& lines,
                                           TrunkFrame const& trunk,
                                           std::vector<Vec2> const& outline)
{
    Crossings crossings;
    std::vector<Meridian> halves;
    CrownRange range;
    if (!outline.empty()) {
        halves = split_into_meridians(outline, 0);
        range = { box_of(outline).low.y(), top_of(outline) };
    }
    double low = 1e300;
    double high = -1e300;
    std::size_t rings = 0;
    double turns = 0;
    for (auto const& line : lines) {
        auto const kind = TRY(kind_of(line));
        if (kind == CrownLineKind::Side) {
            double const theta_deg = azimuth_deg(line);
            auto const side
                = split_into_meridians(TRY(clean_side(line, trunk, theta_deg)), theta_deg);
            halves.insert(halves.end(), side.begin(), side.end());
            continue;
        }
        for (auto const& point : line) {
            low = std::min(low, trunk.of(point).z());
            high = std::max(high, trunk.of(point).z());
        }
        if (kind == CrownLineKind::Ring) {
            TRY(add_ring(line, trunk, crossings));
            ++rings;
            continue;
        }
        auto const before = crossings[0].size();
        TRY(add_climb(line, trunk, crossings));
        turns += static_cast<double>(crossings[0].size() - before);
    }
    if (rings == 0 && turns == 0)
        return halves;
    auto profiles = profiles_of(crossings, low, high, rings == 0 ? Ends::Even : Ends::AsTheyAre);
    SurfaceBuilder const builder(std::move(profiles), rings + static_cast<std::size_t>(turns),
                                 range);
    auto meridians = builder.meridians();
    pull(meridians, halves);
    return meridians;
}

Result<void> add_surface(Drawing& drawing, std::vector<CrownLine> const& lines,
                         std::optional<Vec2> const& foot)
{
    // Default height of the trunk, as a share of the crown's; the same as for outlines
    // (outline.cpp).
    constexpr double kTrunkHeight = 0.85;
    if (lines.empty())
        return {};
    for (auto const& line : lines)
        TRY(kind_of(line));
    bool const has_outline = !drawing.outline.empty();
    auto trunk = drawing.trunk;
    std::vector<Vec2> outline;
    if (has_outline) {
        auto const clean = TRY(clean_drawing({ drawing.outline, drawing.trunk }));
        outline = clean.to_sheet.points(clean.outline);
        if (trunk.empty())
            trunk = clean.to_sheet.points(clean.trunk);
    } else if (trunk.empty()) {
        trunk = upright_trunk(lines, foot);
    }
    if (trunk.size() < 2 || length_of(trunk) < 1e-3)
        return fail(Fault::User,
                    "the trunk is only a dot: draw it from the foot upwards, or leave it out");
    TrunkFrame const frame(trunk);
    for (auto& point : outline)
        point = frame.of(point);
    CrownSurface const surface(TRY(meridians_of(lines, frame, outline)), trunk);
    if (!has_outline)
        drawing.outline = { section_with_sheet(surface, frame) };
    if (!has_outline && drawing.trunk.empty()) {
        Vec2 const range = surface.heights(0);
        double const end = range.x() + kTrunkHeight * (range.y() - range.x());
        drawing.trunk = { frame.foot(), frame.to_sheet({ 0, std::max(end, 1.0) }) };
    }
    drawing.surface = surface.meridians();
    return {};
}

} // namespace tractus::silhouette
