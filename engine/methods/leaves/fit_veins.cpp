#include "engine/methods/leaves/fit_veins.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tractus::leaf {

namespace {

// Smallest distance between knots, as a share of the main vein's length. A knot itself is 0.008 of
// the blade's length long (kKnot in print_grammar.cpp).
constexpr double kMinGap = 0.012;
constexpr double kLastKnot = 0.985;
constexpr std::size_t kMaxKnots = 70;
// Points of a hand-drawn line that are this far apart have independent deviations.
constexpr double kTremorLength_mm = 4;

// Least-squares parabola and straight line through the points of a line. Their parameter is 0 at
// the first point and 1 at the last.
struct LineFit {
    Vec2 begin = Vec2::Zero();
    Vec2 straight = Vec2::UnitY(); // Direction of the straight line.
    // Turn of the parabola from its beginning to its end, positive to the right.
    double turn_deg = 0;
    double length = 0;
    double square_error = 0; // Sum of squared distances of the points from the parabola.
    double freedom = 0;      // Number of independent errors in `square_error`.
};

LineFit fit_line(FlatLine const& line)
{
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> sums = Eigen::Matrix<double, 3, 2>::Zero();
    auto const count = double(line.size());
    auto const row_at = [&](std::size_t i) {
        double const t = double(i) / (count - 1);
        return Vec3(1, t, t * t);
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        Vec3 const row = row_at(i);
        moments += row * row.transpose();
        sums += row * line[i].transpose();
    }
    Eigen::Matrix<double, 3, 2> const curve = moments.inverse() * sums;
    Eigen::Matrix2d const straight = moments.topLeftCorner<2, 2>().inverse() * sums.topRows<2>();
    LineFit made { .begin = straight.row(0).transpose(),
                   .straight = straight.row(1).transpose(),
                   .length = length_of(evenly(line, std::max<std::size_t>(line.size() / 8, 2))) };
    Vec2 const leave = curve.row(1).transpose();
    Vec2 const arrive = (curve.row(1) + 2 * curve.row(2)).transpose();
    made.turn_deg = -degrees(std::atan2(cross(leave, arrive), leave.dot(arrive)));
    made.straight.normalize();
    for (std::size_t i = 0; i < line.size(); ++i) {
        double const off
            = cross(made.straight, line[i] - (row_at(i).transpose() * curve).transpose());
        made.square_error += off * off;
    }
    made.freedom = count;
    return made;
}

double angle_deg(Vec2 const& direction)
{
    return degrees(std::atan2(direction.x(), direction.y()));
}

Vec2 direction_of(double degrees_to_the_right)
{
    double const angle = radians(degrees_to_the_right);
    return { std::sin(angle), std::cos(angle) };
}

double between_180(double angle)
{
    return std::remainder(angle, 360.0);
}

// Rounds a value to a multiple of 1 / parts, as in the text of the leaf's grammar.
double rounded(double value, double parts)
{
    return std::round(value * parts) / parts;
}

// Measurements of a drawn main vein.
struct MainLine {
    Vec2 begin = Vec2::Zero();
    double angle_deg = 0;
    double curve_deg = 0;
    double length = 1;
};

// Measurements of a drawn side vein.
struct SideLine {
    std::size_t parent = 0;
    bool is_right = true;
    double at = 0;
    // Angle between the straight line fitted to the vein and its parent's direction; not negative.
    double angle_deg = 0;
    double noise_deg = 0; // Standard error of `angle_deg` due to tremor.
    // Turn of the vein from beginning to end, positive towards the parent's end.
    double turn_deg = 0;
    double length = 0;
    double fitted_deg = 0; // Fitted angle to the parent at the vein's beginning.
};

class VeinFitter {
public:
    VeinFitter(RecognisedLeaf const& leaf, FlatBlade const& blade, Outline const& outline,
               double tremor)
        : leaf_(leaf)
        , blade_(blade)
        , outline_(outline)
        , tremor_(tremor)
    {
    }

    Result<FittedVeins> fit()
    {
        find_hub();
        for (std::size_t k = 0; k < blade_.mains.size(); ++k)
            mains_.push_back(k == 0 ? MainLine {} : measure_main(blade_.mains[k]));
        for (std::size_t k = 0; k < blade_.sides.size(); ++k)
            sides_.push_back(measure_side(blade_.sides[k], leaf_.sides[k].parent));
        find_curve();
        for (std::size_t parent = 0; parent < mains_.size(); ++parent)
            steady_angles(parent);
        fill_result();
        for (std::size_t k = 0; k < mains_.size(); ++k)
            TRY(fill_main(k));
        order_mains();
        return std::move(result_);
    }

private:
    // Finds the length of the hub, the segment above the end of the stalk on which the main veins
    // begin.
    void find_hub()
    {
        constexpr double kMin = 0.012;
        // Maximum length of the hub. With a longer hub, the limb would follow the outline past it.
        constexpr double kMax = 0.016;
        if (blade_.mains.size() < 2)
            return;
        std::vector<double> begins;
        for (std::size_t k = 1; k < blade_.mains.size(); ++k)
            begins.push_back(blade_.mains[k].front().y());
        std::ranges::sort(begins);
        result_.hub = rounded(std::clamp(begins[begins.size() / 2], kMin, kMax), 1e4);
    }

    double noise_deg(double length) const
    {
        double const independent = std::max(2.0, length * blade_.size_mm / kTremorLength_mm);
        return degrees(tremor_ / length * std::sqrt(12 / independent));
    }

    // Standard error of a line's turn due to tremor. It is larger than that of the line's angle,
    // because the height of a parabola is only an eighth of its turn times its length.
    double turn_noise_deg(double length) const { return 4 * noise_deg(length); }

    MainLine measure_main(FlatLine const& line) const
    {
        constexpr double kMinTurn = 8;
        auto const fit = fit_line(line);
        MainLine made { .begin = fit.begin, .length = fit.length };
        made.angle_deg = angle_deg(fit.straight);
        if (std::abs(fit.turn_deg) > std::max(kMinTurn, 2.5 * turn_noise_deg(fit.length))) {
            made.curve_deg = fit.turn_deg;
            made.angle_deg -= 0.5 * fit.turn_deg;
        } else if (double const reach = outline_.reach(fit.begin, direction_of(made.angle_deg));
                   reach > 0.7 * fit.length && reach < 1.5 * fit.length) {
            made.length = reach;
        }
        return made;
    }

    SideLine measure_side(FlatLine const& line, std::size_t parent) const
    {
        auto const& main = mains_[parent];
        auto const fit = fit_line(line);
        SideLine made { .parent = parent, .length = fit.length };
        // The chord of a bent parent is accurate enough to locate the vein on the parent.
        Vec2 const chord = direction_of(main.angle_deg + 0.5 * main.curve_deg);
        Vec2 const from = line.front() - main.begin;
        double const along = from.dot(chord) / main.length;
        double const direction = main.angle_deg + main.curve_deg * std::clamp(along, 0.0, 1.0);
        double const angle = between_180(angle_deg(fit.straight) - direction);
        made.is_right = angle >= 0;
        made.angle_deg = std::abs(angle);
        double const aside = -cross(chord, from) * (made.is_right ? 1 : -1) / main.length;
        double const back = aside / std::tan(radians(std::max(made.angle_deg, 15.0)));
        constexpr double kMaxBack = 0.03;
        made.at = along - std::clamp(back, -kMaxBack, kMaxBack);
        made.turn_deg = made.is_right ? -fit.turn_deg : fit.turn_deg;
        made.noise_deg = noise_deg(fit.length);
        return made;
    }

    // Fits a common law for the turn of all side veins, linear in their position on the parent. The
    // law stays 0 unless the turn is significant.
    void find_curve()
    {
        constexpr double kMinTurn = 5;
        constexpr double kMaxTurn = 120;
        constexpr std::size_t kEnough = 8;
        Eigen::Matrix2d moments = 1e-9 * Eigen::Matrix2d::Identity();
        Vec2 sums = Vec2::Zero();
        for (auto const& side : sides_) {
            double const weight = 1 / std::pow(turn_noise_deg(side.length) + 2, 2);
            Vec2 const row(1, sides_.size() < kEnough ? 0 : side.at - 0.5);
            moments += weight * row * row.transpose();
            sums += weight * side.turn_deg * row;
        }
        Eigen::Matrix2d const doubt = moments.inverse(); // Covariance of the coefficients.
        Vec2 law = doubt * sums;
        if (std::abs(law[0]) < std::max(kMinTurn, 3 * std::sqrt(doubt(0, 0))))
            return;
        if (std::abs(law[1]) < 3 * std::sqrt(doubt(1, 1)) || sides_.size() < kEnough)
            law[1] = 0;
        auto const at_end
            = [&](double turn) { return rounded(std::clamp(turn, -kMaxTurn, kMaxTurn), 10); };
        result_.side_curve_deg = at_end(law[0] - 0.5 * law[1]);
        result_.side_curve_at_tip_deg = at_end(law[0] + 0.5 * law[1]);
    }

    double curve_at(double at) const
    {
        return result_.side_curve_deg
            + at * (result_.side_curve_at_tip_deg - result_.side_curve_deg);
    }

    // Smooths the angles of a parent's side veins by empirical Bayes: the result for each vein is a
    // weighted mean of its measured angle and a linear law for all side veins of the parent.
    void steady_angles(std::size_t parent)
    {
        // Minimum of the assumed standard deviation of angles from the law if there are few veins.
        constexpr double kFree_deg = 6;
        // Maximum standard deviation of angles from the law if there are many veins.
        constexpr double kOwn_deg = 1.5;
        constexpr std::size_t kEnough = 6;
        std::vector<SideLine*> group;
        for (auto& side : sides_)
            if (side.parent == parent)
                group.push_back(&side);
        if (group.empty())
            return;
        Eigen::Matrix2d moments = 1e-9 * Eigen::Matrix2d::Identity();
        Vec2 sums = Vec2::Zero();
        for (auto const* const side : group) {
            double const weight = 1 / (side->noise_deg * side->noise_deg + 1);
            Vec2 const row(1, group.size() < kEnough ? 0 : side->at - 0.5);
            moments += weight * row * row.transpose();
            sums += weight * side->angle_deg * row;
        }
        Vec2 const law = moments.inverse() * sums;
        double own = 0;
        for (auto const* const side : group) {
            double const off = side->angle_deg - law[0] - law[1] * (side->at - 0.5);
            own += off * off - side->noise_deg * side->noise_deg;
        }
        own = std::clamp(own / double(group.size()), 0.25, kOwn_deg * kOwn_deg);
        if (group.size() < kEnough)
            own = std::max(own, kFree_deg * kFree_deg);
        for (auto* const side : group) {
            double const expected = law[0] + law[1] * (side->at - 0.5);
            double const doubt = own + side->noise_deg * side->noise_deg;
            double const off = side->angle_deg - expected;
            double const trust = off * off > 9 * doubt ? 1 : own / doubt;
            side->fitted_deg = rounded(expected + trust * off + 0.5 * curve_at(side->at), 10);
        }
    }

    void fill_result()
    {
        for (std::size_t k = 0; k < mains_.size(); ++k) {
            auto const& main = mains_[k];
            result_.veins.push_back(
                { .stroke = leaf_.mains[k].stroke,
                  .parent = leaf_.mains[k].stroke,
                  .drawn_angle_deg = main.angle_deg,
                  .fitted_angle_deg = rounded(main.angle_deg, 10),
                  .drawn_length_mm = blade_.size_mm * length_of(blade_.mains[k]),
                  .fitted_length_mm = blade_.size_mm * main.length });
            result_.mains.push_back({ .angle_deg = rounded(main.angle_deg, 10),
                                      .curve_deg = rounded(main.curve_deg, 10) });
        }
        for (std::size_t k = 0; k < sides_.size(); ++k) {
            auto const& side = sides_[k];
            double const sign = side.is_right ? 1 : -1;
            result_.veins.push_back(
                { .stroke = leaf_.sides[k].stroke,
                  .parent = leaf_.mains[side.parent].stroke,
                  .drawn_at = side.at,
                  .drawn_angle_deg = sign * (side.angle_deg + 0.5 * curve_at(side.at)),
                  .fitted_angle_deg = sign * side.fitted_deg,
                  .drawn_length_mm = blade_.size_mm * side.length });
        }
    }

    // Makes the knots of a main vein. Side veins that begin opposite to each other share a knot.
    Result<void> fill_main(std::size_t parent)
    {
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < sides_.size(); ++k)
            if (sides_[k].parent == parent)
                order.push_back(k);
        std::ranges::sort(order, {}, [&](std::size_t k) { return sides_[k].at; });
        auto& knots = result_.mains[parent].knots;
        std::vector<std::vector<std::size_t>> on_knot;
        for (auto const k : order) {
            auto const& side = sides_[k];
            bool const is_pair = !knots.empty() && side.at - knots.back().at < kMinGap
                && !(side.is_right ? knots.back().right_deg : knots.back().left_deg);
            if (!is_pair) {
                knots.push_back({ .at = side.at });
                on_knot.emplace_back();
            } else {
                knots.back().at = 0.5 * (knots.back().at + side.at);
            }
            (side.is_right ? knots.back().right_deg : knots.back().left_deg) = side.fitted_deg;
            on_knot.back().push_back(k);
        }
        if (knots.size() > kMaxKnots)
            return fail(Fault::User,
                        fmt::format("{} side veins begin on stroke {}: draw at most {}",
                                    order.size(), leaf_.mains[parent].stroke + 1, kMaxKnots));
        space_out(knots, parent == 0 ? result_.hub : 0);
        for (std::size_t k = 0; k < on_knot.size(); ++k)
            for (auto const side : on_knot[k])
                set_fitted_place(side, knots[k].at);
        if (knots.empty() && result_.mains[parent].curve_deg != 0)
            knots = { { .at = 0.2 }, { .at = 0.4 }, { .at = 0.6 }, { .at = 0.8 } };
        return {};
    }

    void set_fitted_place(std::size_t side, double at)
    {
        auto& vein = result_.veins[mains_.size() + side];
        auto const& main = mains_[sides_[side].parent];
        double const along_deg = main.angle_deg + at * main.curve_deg;
        Vec2 const from = main.begin
            + at * main.length * direction_of(main.angle_deg + 0.5 * at * main.curve_deg);
        double const bent
            = vein.fitted_angle_deg - (vein.fitted_angle_deg > 0 ? 0.5 : -0.5) * curve_at(at);
        vein.fitted_at = at;
        vein.fitted_length_mm
            = blade_.size_mm * outline_.reach(from, direction_of(along_deg + bent));
    }

    // Moves the knots of a main vein apart, because they have a length and must not overlap.
    static void space_out(std::vector<DrawnLeaf::Knot>& knots, double begin)
    {
        double least = begin + kMinGap;
        for (auto& knot : knots) {
            knot.at = std::max(knot.at, least);
            least = knot.at + kMinGap;
        }
        double most = kLastKnot;
        for (auto knot = knots.rbegin(); knot != knots.rend(); ++knot) {
            knot->at = rounded(std::min(knot->at, most), 1e4);
            most = knot->at - kMinGap;
        }
    }

    // Sorts the main veins: first the midrib, then from the outermost right one to the outermost
    // left one.
    void order_mains()
    {
        auto const key = [](DrawnLeaf::Main const& main) {
            return main.angle_deg >= 0 ? 360 - main.angle_deg : 720 + -main.angle_deg;
        };
        std::stable_sort(result_.mains.begin() + 1, result_.mains.end(),
                         [&](auto const& a, auto const& b) { return key(a) < key(b); });
    }

    RecognisedLeaf const& leaf_;
    FlatBlade const& blade_;
    Outline const& outline_;
    double tremor_;
    std::vector<MainLine> mains_;
    std::vector<SideLine> sides_;
    FittedVeins result_;
};

} // namespace

double tremor_of(FlatBlade const& blade)
{
    double squares = 0;
    double count = 0;
    auto const add = [&](FlatLine const& line) {
        auto const fit = fit_line(line);
        // The parabola has three coefficients, which absorb as many of the independent deviations.
        double const independent = std::max(1.0, fit.length * blade.size_mm / kTremorLength_mm);
        if (independent < 5)
            return;
        squares += fit.square_error * independent / (independent - 3);
        count += fit.freedom;
    };
    for (auto const& line : blade.mains)
        add(line);
    for (auto const& line : blade.sides)
        add(line);
    return count > 0 ? std::sqrt(squares / count) : 0;
}

Result<FittedVeins> fit_veins(RecognisedLeaf const& leaf, FlatBlade const& blade,
                              Outline const& outline, double tremor)
{
    return VeinFitter(leaf, blade, outline, tremor).fit();
}

} // namespace tractus::leaf
