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

// Motion of a point along a path, from rest to rest with minimum jerk, as arms move (T. Flash, N.
// Hogan, "The coordination of arm movements", J. Neurosci. 5, 1985). On a long path it accelerates
// within kRamp_s, continues at the cruising speed and decelerates; on a shorter path it follows the
// paper's quintic, the more slowly the shorter the path is.
class SpeedProfile {
public:
    static constexpr double kRamp_s = 0.25;

    SpeedProfile() = default;
    SpeedProfile(double length_mm, double cruise_mm_s);

    double duration_s() const { return duration_s_; }

    // Distance covered at `seconds` after the start, and the speed at that time.
    double distance_mm(double seconds) const;
    double speed_mm_s(double seconds) const;

private:
    bool cruises() const { return length_mm_ >= cruise_mm_s_ * kRamp_s; }

    double length_mm_ = 0;
    double cruise_mm_s_ = 1;
    double duration_s_ = 0;
};

// A line that the hand draws, from pen-down to pen-up.
struct HandStroke {
    Path path;
    // Cruising speed along the path, unless a limit in HandOptions is lower.
    double speed_mm_s = 150;
    double pressure = 0.6; // Pressure in the middle of the stroke, 0 to 1.
    bool eraser = false;   // True: the stroke is drawn with the pen's eraser end.
    bool is_dab = false;   // True: a touch by mistake, before the stroke that is meant.
};

struct HandOptions {
    std::uint64_t seed = 1; // Seed of the tremor.

    // Speed limits of the pen over the tablet and of the carriage.
    double max_plane_speed_mm_s = 300;
    double max_height_speed_mm_s = 200;

    // Standard deviation of the tremor along x and along y, standard deviation of the carriage's
    // tremor, and the range of the tremor's frequencies. The carriage is heavy and trembles less.
    double plane_tremor_mm = 0.15;
    double height_tremor_mm = 0.05;
    double min_tremor_hz = 4;
    double most_tremor_hz = 12;

    // Time of hovering at rest before pen-down and after pen-up.
    Duration pause = std::chrono::milliseconds(120);

    // Tilt of the pen towards +x (right-handed) and towards the user.
    Vec2 tilt_rad = Vec2(0.5, -0.35);
    // Amplitude of a slow variation of the tilt along x and y.
    Vec2 leaned_around_rad = Vec2::Zero();
};

// State of pen and carriage at one instant. World frame.
struct HandState {
    // Position of the tip including tremor; z is the carriage's height above its zero.
    Vec3 position_mm = Vec3::Zero();
    Vec3 velocity_mm_s = Vec3::Zero();
    bool in_range = false;
    bool touching = false;
    bool eraser = false;
    double pressure = 0;          // Pressure from 0 to 1; 0 unless touching.
    Vec2 tilt_rad = Vec2::Zero(); // Tilt from upright towards +x and +y.
};

// A hand that draws strokes one after another and hovers from each to the next, in straight lines,
// and out of the tablet's range on longer moves; the other hand moves the carriage. Its whole state
// is a function of time. It starts at time 0 out of range above the start of the first stroke, and
// ends out of range above the end of the last one.
class Hand {
public:
    // Requires at least one stroke.
    Hand(std::vector<HandStroke> strokes, HandOptions const& options);

    // Returns the time at which the hand has finished the last stroke and left.
    Timestamp end() const { return end_; }

    // Returns the state at `time`, clamped to the start and the end.
    HandState at(Timestamp time) const;

    struct StrokeTimes {
        // Time between the previous stroke and this one at which to change tools.
        Timestamp chosen {};
        Timestamp down {};
        Timestamp up {};
    };

    // Returns the times of the strokes, in order.
    std::span<StrokeTimes const> strokes() const { return stroke_times_; }

    bool is_dab(std::size_t stroke) const { return strokes_[stroke].is_dab; }

private:
    enum class HandPhase {
        Absent, // The hand rests out of range.
        Hover,  // The hand rests in range.
        Move,
        Draw,
    };

    struct Part {
        HandPhase doing = HandPhase::Absent;
        Timestamp start {};
        double duration_s = 0;
        Vec3 rest_mm = Vec3::Zero(); // Position of the hand while it rests.
        std::optional<Path> path {};
        SpeedProfile profile {};
        std::size_t stroke = 0; // Index of the stroke that this part draws or moves to.
    };

    // One sine component of an axis's tremor.
    struct Wave {
        double amplitude_mm = 0;
        double rad_per_s = 0;
        double phase_rad = 0;
    };

    void rest(HandPhase doing, Vec3 const& place_mm, Duration length, std::size_t stroke);
    void go(HandPhase doing, Path path, double cruise_mm_s, std::size_t stroke);
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
