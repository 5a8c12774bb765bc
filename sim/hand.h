#pragma once

#include "engine/base/time.h"
#include "engine/base/vectors.h"
#include "sim/path.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::sim {

// How a point moves along a path: from rest to rest, with as little jerk as can be, as arms do
// (T. Flash, N. Hogan, "The coordination of arm movements", J. Neurosci. 5, 1985). On a long way it
// speeds up within kRamp_s, goes on at the cruising speed and slows down again; on a way too short
// for that it takes the quintic of the paper, the more slowly the shorter the way is.
class SpeedProfile {
public:
    static constexpr double kRamp_s = 0.25;

    SpeedProfile() = default;
    SpeedProfile(double length_mm, double cruise_mm_s);

    double duration_s() const { return duration_s_; }

    // The way covered at `seconds` after the start, and the speed then.
    double distance_mm(double seconds) const;
    double speed_mm_s(double seconds) const;

private:
    bool cruises() const { return length_mm_ >= cruise_mm_s_ * kRamp_s; }

    double length_mm_ = 0;
    double cruise_mm_s_ = 1;
    double duration_s_ = 0;
};

// One line that the hand draws, pen down to pen up.
struct HandStroke {
    Path path;
    double speed_mm_s = 150; // Cruising along the path, unless a limit of HandOptions is lower.
    double pressure = 0.6;   // Pressure in the stroke's middle, 0 to 1.
    bool eraser = false;     // Drawn with the pen's other end.
};

struct HandOptions {
    std::uint64_t seed = 1; // Seed of the tremor.

    // Limits for the pen over the tablet and for the carriage.
    double max_plane_speed_mm_s = 300;
    double max_height_speed_mm_s = 200;

    // Standard deviation along x and along y, and of the carriage, which is heavy; 4 to 12 Hz.
    double plane_tremor_mm = 0.15;
    double height_tremor_mm = 0.05;

    // Hovering at rest before pen-down and after pen-up.
    Duration pause = std::chrono::milliseconds(120);

    // How the pen is held: towards +x (right-handed) and the user.
    Vec2 tilt_rad = Vec2(0.5, -0.35);
    // Leaned slowly all around that, so far to either side along x and along y.
    Vec2 leaned_around_rad = Vec2::Zero();
};

// Pen and carriage at one instant. World frame.
struct HandState {
    // The tip, tremor included; z is the carriage's height over its zero.
    Vec3 position_mm = Vec3::Zero();
    Vec3 velocity_mm_s = Vec3::Zero();
    bool in_range = false;
    bool touching = false;
    bool eraser = false;
    double pressure = 0;          // 0 to 1; 0 unless touching.
    Vec2 tilt_rad = Vec2::Zero(); // Towards +x and +y from upright.
};

// A hand that draws strokes one after another and hovers from each to the next, in straight lines
// and out of the tablet's range on longer ways; its other hand moves the carriage. Everything about
// it is a function of time. Starts at time 0 out of range above the first stroke's start, and ends
// out of range above the last one's end.
class Hand {
public:
    Hand(std::vector<HandStroke> strokes, HandOptions const& options); // At least one stroke.

    // When everything is over.
    Timestamp end() const { return end_; }

    // The state at `time`; before the start and after the end, as it is then.
    HandState at(Timestamp time) const;

    struct StrokeTimes {
        Timestamp chosen {}; // Time between the stroke before and this one: when to change tools.
        Timestamp down {};
        Timestamp up {};
    };

    // One per stroke, in order.
    std::span<StrokeTimes const> strokes() const { return stroke_times_; }

private:
    enum class Doing {
        Absent, // Rests out of range.
        Hover,  // Rests in range.
        Move,
        Draw,
    };

    struct Part {
        Doing doing = Doing::Absent;
        Timestamp start {};
        double duration_s = 0;
        Vec3 rest_mm = Vec3::Zero(); // Where the hand is, unless it goes along a path.
        std::optional<Path> path {};
        SpeedProfile profile {};
        std::size_t stroke = 0; // The one it draws or comes to.
    };

    // One sine of an axis's tremor.
    struct Wave {
        double amplitude_mm = 0;
        double rad_per_s = 0;
        double phase_rad = 0;
    };

    void rest(Doing doing, Vec3 const& place_mm, Duration length, std::size_t stroke);
    void go(Doing doing, Path path, double cruise_mm_s, std::size_t stroke);
    void draw(std::size_t stroke);
    void make_tremor();
    void add_tremor(HandState& state, double seconds) const;
    void press(HandState& state, Part const& part, double seconds) const;
    double cruise_mm_s(Path const& path, double speed_mm_s) const;

    HandOptions options_;
    std::vector<HandStroke> strokes_;
    std::vector<Part> parts_; // Parts in time order, without gaps.
    std::vector<StrokeTimes> stroke_times_;
    std::array<std::array<Wave, 6>, 3> tremor_ {};
    Timestamp end_ {};
};

} // namespace tractus::sim
