#include "tests/physics/capture_log.h"

#include <cmath>
#include <cstdio>

namespace tractus::physics {

namespace {

constexpr double kBetweenCaptures_s = 4;
constexpr double kReading_s = 0.0101; // Interval between readings, out of step with the hum.
constexpr double kCaptured_s = 1.2;

template<typename... Values> void append(std::string& text, char const* format, Values... values)
{
    char line[160];
    std::snprintf(line, sizeof line, format, values...);
    text += line;
}

// Appends the sensor's descriptor: a multi-axis controller with one slider of 16 bits, from 0 to
// the converter's full scale. (A joystick would be taken for a game controller.)
void append_sensor(std::string& text, int full_scale)
{
    auto const low = static_cast<unsigned>(full_scale & 0xff);
    auto const high = static_cast<unsigned>(full_scale >> 8);
    text += "D: 0\nR: 20 05 01 09 08 a1 01 09 36 15 00 26 ";
    append(text, "%02x %02x 75 10 95 01 81 02 c0\n", low, high);
    text += "N: Slider\nP: physics/0\nI: 3 1209 0002\n";
}

} // namespace

std::string capture_log(Potentiometer const& sensor, int full_scale, Person const& person,
                        Dice& dice)
{
    std::string text;
    append_sensor(text, full_scale);
    double direction = 0;
    for (std::size_t i = 0; i < person.heights_mm.size(); ++i) {
        double const height_mm = person.heights_mm[i];
        if (i > 0)
            direction = height_mm > person.heights_mm[i - 1] ? 1 : -1;
        double const begin_s = 1 + kBetweenCaptures_s * static_cast<double>(i);
        double const stated_mm = person.stated_mm[i] + normal(dice, person.ruler_error_mm);
        append(text, "T: %013.6f calibrate capture %.1f\n", begin_s,
               std::round(stated_mm * 10) / 10);
        for (double since_s = kReading_s; since_s < kCaptured_s; since_s += kReading_s) {
            auto const counts
                = static_cast<unsigned>(sensor.read(height_mm, direction, begin_s + since_s, dice));
            append(text, "E: %013.6f 2 %02x %02x\n", begin_s + since_s, counts & 0xff, counts >> 8);
        }
    }
    return text;
}

} // namespace tractus::physics
