#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace tractus {

// Simulates how a hand draws a line, with tremor, hooks and interruptions. It shares nothing with
// the code that recognises lines. Its numbers were measured on people at tablets: tremor with the
// spectrum kTremor, drift below 1 Hz with twice the amplitude of the tremor, a bell-shaped speed,
// 200 reports a second, and hooks of 0.5 to 3 mm.
class Hand {
public:
    explicit Hand(std::uint64_t seed)
        : random_(seed)
    {
    }

    double between(double least, double most)
    {
        return least + (most - least) * static_cast<double>(random_() % 100'001) / 100'000.0;
    }
    bool chance(double share) { return between(0, 1) < share; }
    std::size_t below(std::size_t count) { return random_() % count; }
    template<typename Range> void shuffle(Range& range)
    {
        // std::shuffle is not used, since its result differs between libraries.
        for (std::size_t i = range.size(); i > 1; --i)
            std::swap(range[i - 1], range[below(i)]);
    }

    // Returns a line as the pen reports it, drawn at 60 to 160 mm/s. `tremor_mm` is the root mean
    // square of the tremor in each coordinate.
    std::vector<Vec3> draw(std::vector<Vec3> const& line, double tremor_mm)
    {
        constexpr double kReport_s = 0.005;
        ArcLength const along(line);
        double const speed_mm_s = between(60, 160);
        double const takes_s = std::max(0.1, along.length_mm() / speed_mm_s);
        auto const count = static_cast<std::size_t>(takes_s / kReport_s) + 12;
        struct Wave {
            double amplitude_mm, per_s, phase;
        };
        double power = 0;
        for (auto const& band : kTremor)
            power += band.share * band.share;
        std::vector<Wave> waves[2];
        for (auto& coordinate : waves) {
            for (auto const& band : kTremor)
                coordinate.push_back({ tremor_mm * band.share * std::sqrt(2 / power),
                                       band.per_s + between(-0.5, 0.5), between(0, 2 * kPi) });
            coordinate.push_back({ 2 * tremor_mm, between(0.2, 0.8), between(0, 2 * kPi) });
        }
        std::vector<Vec3> drawn;
        for (std::size_t i = 0; i < count; ++i) {
            double const t = static_cast<double>(i) / static_cast<double>(count - 1);
            // The speed is nearly constant, and lower at both ends.
            double const bell = t * t * (3 - 2 * t);
            Vec3 point = along.at(0.6 * t + 0.4 * bell);
            for (int axis = 0; axis < 2; ++axis)
                for (auto const& wave : waves[axis])
                    point[axis] += wave.amplitude_mm
                        * std::sin(2 * kPi * wave.per_s * t * takes_s + wave.phase);
            drawn.push_back(point);
        }
        return drawn;
    }

    // Adds a hook at an end of the stroke, where the pen slips aside while it is put down or
    // lifted.
    static void add_hook(std::vector<Vec3>& stroke, double length_mm, double turn_deg)
    {
        auto const n = stroke.size();
        auto const back = std::min<std::size_t>(n - 1, 8);
        Vec3 const way = (stroke[n - 1] - stroke[n - 1 - back]).normalized();
        Vec3 const end = stroke.back();
        constexpr int kPoints = 6;
        for (int i = 1; i <= kPoints; ++i) {
            double const share = static_cast<double>(i) / kPoints;
            double const turn = radians(turn_deg) * std::min(1.0, 0.5 + share);
            Vec3 const aside(way.x() * std::cos(turn) - way.y() * std::sin(turn),
                             way.x() * std::sin(turn) + way.y() * std::cos(turn), 0);
            stroke.push_back(end + share * length_mm * aside);
        }
    }
    void add_hooks(std::vector<Vec3>& stroke, double min_mm = 0.5, double most_mm = 3)
    {
        for (int end = 0; end < 2; ++end) {
            if (chance(0.8))
                add_hook(stroke, between(min_mm, most_mm),
                         (chance(0.5) ? 1 : -1) * between(50, 160));
            std::reverse(stroke.begin(), stroke.end());
        }
    }

    // Returns the line in `count` pieces. Each piece begins slightly before or after the end of the
    // previous one.
    std::vector<std::vector<Vec3>> pieces(std::vector<Vec3> const& line, int count)
    {
        ArcLength const along(line);
        std::vector<std::vector<Vec3>> result;
        for (int i = 0; i < count; ++i) {
            double const slip = std::min(0.03, 4 / along.length_mm());
            double const from
                = i == 0 ? 0 : static_cast<double>(i) / count + between(-slip, slip / 2);
            double const to = i + 1 == count ? 1 : static_cast<double>(i + 1) / count;
            std::vector<Vec3> piece;
            for (int k = 0; k <= 60; ++k)
                piece.push_back(along.at(from + (to - from) * k / 60));
            result.push_back(std::move(piece));
        }
        return result;
    }

    // Returns the part of the line between two shares of its length, displaced sideways. The part
    // begins and ends on the line.
    static std::vector<Vec3> part_aside(std::vector<Vec3> const& line, double from, double to,
                                        double aside_mm)
    {
        ArcLength const along(line);
        std::vector<Vec3> part;
        for (int k = 0; k <= 60; ++k) {
            double const share = k / 60.0;
            double const at = from + (to - from) * share;
            Vec3 const way
                = (along.at(std::min(1.0, at + 0.01)) - along.at(std::max(0.0, at - 0.01)))
                      .normalized();
            double const bell = std::sin(kPi * share);
            part.push_back(along.at(at) + aside_mm * bell * bell * Vec3(-way.y(), way.x(), 0));
        }
        return part;
    }

private:
    // Amplitude spectrum of the tremor: the median of 36 seconds of strokes in 13 public recordings
    // of tablets, less the course of each stroke, a polynomial of the seventh degree. Below 7 Hz
    // intended movement prevails.
    struct Band {
        double per_s;
        double share; // Amplitude relative to that at 7 Hz.
    };
    static constexpr std::array<Band, 14> kTremor { {
        { 7, 1 },
        { 8, 0.87 },
        { 9, 0.84 },
        { 10, 1.06 },
        { 11, 0.74 },
        { 12, 0.42 },
        { 13, 0.29 },
        { 14, 0.19 },
        { 15, 0.29 },
        { 16, 0.19 },
        { 18, 0.19 },
        { 20, 0.19 },
        { 23, 0.16 },
        { 26, 0.1 },
    } };

    std::mt19937_64 random_;
};

} // namespace tractus
