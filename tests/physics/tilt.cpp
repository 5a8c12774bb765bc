#include "calib/fuser.h"
#include "calib/tilt_fit.h"
#include "tests/physics/checks.h"
#include "tests/physics/leaning_pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace tractus::physics {

namespace {

// Returns how a pen is held while it is leaned in all directions by varying angles.
Holding leaned_around(double farthest_deg, Dice& dice)
{
    double const farthest = farthest_deg * kPi / 180;
    double const phase = uniform(dice, 0, 6);
    double const turns_hz = uniform(dice, 0.12, 0.2);
    return [=](double t) {
        double const part = 0.7 + 0.3 * std::sin(2 * kPi * 0.31 * t + phase);
        return Hold { farthest * part, 2 * kPi * turns_hz * t + phase };
    };
}

// Returns how a pen is held while drawing: leaned by 25 to 55 degrees, with the wrist and arm
// turning.
Holding drawing_hand(Dice& dice)
{
    double const lean = uniform(dice, 30, 45) * kPi / 180;
    double const azimuth = uniform(dice, -1.2, 0.2);
    double const phase = uniform(dice, 0, 6);
    return [=](double t) {
        return Hold { lean + 0.12 * std::sin(2 * kPi * 0.9 * t + phase),
                      azimuth + 0.5 * std::sin(2 * kPi * 0.6 * t + 2 * phase) };
    };
}

// Returns the nib's position at time `t` on loops drawn at up to 300 mm/s.
Vec2 loops(double t)
{
    return { 120 + 40 * std::sin(2 * kPi * 0.8 * t), 80 + 30 * std::sin(2 * kPi * 1.1 * t) };
}

// Returns the movement of a nib in a dent. It trembles, and it slides up the dent's side in the
// direction in which the pen leans, or in the opposite direction.
NibPath dent(double moved_mm, Holding const& holding, Dice& dice)
{
    double const play_mm = uniform(dice, -0.1, 0.1);
    return [=](double t) {
        auto const hold = holding(t);
        Vec2 const place(100 + 0.04 * std::sin(11 * t), 70 + 0.04 * std::sin(13 * t));
        Vec2 const way(std::cos(hold.azimuth_rad), std::sin(hold.azimuth_rad));
        return Vec2(place + play_mm * std::sin(hold.lean_rad) * way
                    + (t > 9 ? Vec2(moved_mm, 0) : Vec2::Zero()));
    };
}

struct TipErrors {
    double live_mm = 0; // Root mean square errors of live and settled tips.
    double settled_mm = 0;
};

double rms(std::vector<Vec2> const& tips, std::vector<Vec2> const& truth)
{
    double squares = 0;
    for (std::size_t i = 0; i < tips.size(); ++i)
        squares += (tips[i] - truth[i]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(tips.size(), 1)));
}

// Returns the errors of the tips that a fuser makes from a recording over a table at rest.
TipErrors fuse(PenRecording const& recording, Vec2 const& coil_height_mm)
{
    calib::Rig rig;
    rig.height_model = calib::LinearHeight { .mm_per_count = 0.1, .zero_counts = 0 };
    rig.coil_height_mm = coil_height_mm;
    Vec2 const centre_mm = rig.tablet_size_mm / 2;
    calib::Fuser fuser(rig);
    std::vector<Vec2> live;
    std::vector<Vec2> settled;
    auto const settle = [&] {
        for (auto const& tip : fuser.take_settled())
            settled.push_back(tip.position_mm.head<2>() + centre_mm);
    };
    Timestamp next_height {};
    for (auto const& pen : recording.samples) {
        for (; next_height <= pen.time; next_height += std::chrono::milliseconds(2))
            fuser.push(
                drivers::HeightSample { .time = next_height, .counts = 1000, .full_scale = 4095 });
        if (auto const tip = fuser.push(pen))
            live.push_back(tip->position_mm.head<2>() + centre_mm);
        settle();
    }
    fuser.flush();
    settle();
    return { rms(live, recording.nibs_mm), rms(settled, recording.nibs_mm) };
}

double at(std::vector<double> values, double part)
{
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

struct Scenario {
    char const* name = "";
    Tablet tablet {};
    double goal = 0.95; // Required share of the fits within two standard errors, or within 0.1 mm.
};

// Fits the height of the pen's coil, and then draws with a rig that has this coil height.
bool run_row(Scenario const& scenario, Run const& run)
{
    std::vector<double> off, before, live, settled;
    std::array<unsigned, 3> within {};
    unsigned good = 0;
    std::string missed;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        auto tablet = scenario.tablet;
        tablet.coil_mm = uniform(dice, 8, 12);
        Vec2 const truth(tablet.coil_mm, tablet.is_y_inverted ? -tablet.coil_mm : tablet.coil_mm);
        auto const around = leaned_around(uniform(dice, 35, 50), dice);
        auto const fit
            = calib::fit_tilt(record_pen(dent(0, around, dice), around, 20, tablet, dice).samples);
        if (!fit) {
            missed.append(1, ' ').append(std::to_string(seed));
            continue;
        }
        bool is_good = true;
        for (int axis = 0; axis < 2; ++axis) {
            double const miss = std::abs(fit->coil_height_mm[axis] - truth[axis]);
            off.push_back(miss);
            for (std::size_t i = 0; i < within.size(); ++i)
                within[i] += miss <= static_cast<double>(i + 1) * fit->coil_height_error_mm[axis];
            is_good &= miss <= 0.3;
        }
        good += is_good;
        if (!is_good)
            missed.append(1, ' ').append(std::to_string(seed));
        auto const drawn = record_pen(loops, drawing_hand(dice), 6, tablet, dice);
        before.push_back(fuse(drawn, Vec2::Zero()).settled_mm);
        auto const after = fuse(drawn, fit->coil_height_mm);
        live.push_back(after.live_mm);
        settled.push_back(after.settled_mm);
    }
    if (off.empty())
        return false;
    auto const share
        = [&](unsigned count) { return 100.0 * count / static_cast<double>(off.size()); };
    std::printf("%-38s off %.3f, 95 %% %.3f mm  within 1, 2, 3 SE %3.0f %3.0f %3.0f %%  tips "
                "before %.2f, live %.2f, settled %.2f mm  good %5.1f %%\n",
                scenario.name, at(off, 0.5), at(off, 0.95), share(within[0]), share(within[1]),
                share(within[2]), at(before, 0.5), at(live, 0.5), at(settled, 0.5),
                100.0 * good / run.rigs);
    if (!missed.empty() && missed.size() < 400)
        std::printf("  seeds that missed:%s\n", missed.c_str());
    bool const is_good = is_enough(static_cast<double>(good) / run.rigs, scenario.goal, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * scenario.goal);
    return is_good;
}

struct Case {
    char const* name = "";
    double coil_mm = 10;
    double farthest_deg = 45;
    double moved_mm = 0;
    enum class Outcome { Corrected, Refused } wanted = Outcome::Refused;
    double goal = 0.99;
};

// Checks how often a calibration that must be refused is refused.
bool run_case(Case const& one, Run const& run)
{
    unsigned good = 0;
    std::string missed;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        auto const around = leaned_around(one.farthest_deg, dice);
        auto const fit = calib::fit_tilt(record_pen(dent(one.moved_mm, around, dice), around, 20,
                                                    { .coil_mm = one.coil_mm }, dice)
                                             .samples);
        bool const is_good
            = one.wanted == Case::Outcome::Refused ? !fit : fit && fit->is_corrected();
        good += is_good;
        if (!is_good)
            missed.append(1, ' ').append(std::to_string(seed));
    }
    double const part = static_cast<double>(good) / run.rigs;
    std::printf("%-38s %s %5.1f %%\n", one.name,
                one.wanted == Case::Outcome::Refused ? "refused" : "told to be nothing",
                100 * part);
    if (!missed.empty() && missed.size() < 400)
        std::printf("  seeds that missed:%s\n", missed.c_str());
    bool const is_good = is_enough(part, one.goal, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * one.goal);
    return is_good;
}

} // namespace

bool check_tilt(Run const& run)
{
    std::printf("\nTilt: a coil 8 to 12 mm above the nib, tilts in whole degrees, a pen of 133 Hz; "
                "fits of 20 s\n");
    bool all_good = true;
    for (Scenario const& scenario : {
             Scenario { .name = "no noise", .tablet = { .tilt_noise_deg = 0 } },
             Scenario { .name = "noise of 0.5 degrees" },
             Scenario { .name = "noise of 1 degree", .tablet = { .tilt_noise_deg = 1 } },
             Scenario { .name = "noise of 2 degrees", .tablet = { .tilt_noise_deg = 2 } },
             Scenario { .name = "tilts 30 ms late", .tablet = { .tilt_late_s = 0.03 } },
             Scenario { .name = "y turned round", .tablet = { .is_y_inverted = true } },
             Scenario {
                 .name = "shifted as the tangent", .tablet = { .sight = Sight::Along }, .goal = 0 },
         })
        all_good &= run_row(scenario, run);
    for (Case const& one : {
             Case {
                 .name = "tablet that corrects", .coil_mm = 0, .wanted = Case::Outcome::Corrected },
             Case { .name = "leaned by 12 degrees", .farthest_deg = 12 },
             Case { .name = "nib moved by 3 mm", .moved_mm = 3 },
             Case { .name = "nib moved by 2 mm", .moved_mm = 2, .goal = 0 },
         })
        all_good &= run_case(one, run);
    return all_good;
}

} // namespace tractus::physics
