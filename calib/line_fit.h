#pragma once

#include <optional>

namespace tractus::calib {

// Sums of a weighted line fit, with times relative to the instant of interest.
class LineFit {
public:
    void add(double seconds, double value, double weight)
    {
        weights_ += weight;
        times_ += weight * seconds;
        squares_ += weight * seconds * seconds;
        values_ += weight * value;
        products_ += weight * seconds * value;
        ++count_;
    }

    struct Line {
        double at_zero = 0; // Value of the line at time 0.
        double per_second = 0;
    };

    // Returns the line. No value for fewer than four values, or if they are too close together in
    // time.
    std::optional<Line> line() const
    {
        // The determinant is the weighted variance of the times; if it is tiny, no slope can be
        // fitted.
        constexpr double kMinSpread_s = 1e-3;
        constexpr int kFewestReadings = 4;
        double const determinant = weights_ * squares_ - times_ * times_;
        if (count_ < kFewestReadings
            || !(determinant > weights_ * weights_ * kMinSpread_s * kMinSpread_s))
            return std::nullopt;
        return Line { (squares_ * values_ - times_ * products_) / determinant,
                      (weights_ * products_ - times_ * values_) / determinant };
    }

private:
    double weights_ = 0;
    double times_ = 0;
    double squares_ = 0;
    double values_ = 0;
    double products_ = 0;
    int count_ = 0;
};

} // namespace tractus::calib
