#include "engine/stroke/resample.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus {

ArcLength::ArcLength(std::span<Vec3 const> points)
    : points_(points.begin(), points.end())
{
    CHECK(!points_.empty());
    length_to_mm_.reserve(points_.size());
    length_to_mm_.push_back(0);
    for (std::size_t i = 1; i < points_.size(); ++i)
        length_to_mm_.push_back(length_to_mm_.back() + (points_[i] - points_[i - 1]).norm());

    first_in_share_.resize(points_.size());
    std::uint32_t point = 0;
    for (std::size_t share = 0; share < points_.size(); ++share) {
        double const begin_mm
            = length_mm() * static_cast<double>(share) / static_cast<double>(points_.size());
        while (point + 1 < points_.size() && length_to_mm_[point + 1] < begin_mm)
            ++point;
        first_in_share_[share] = point;
    }
}

Vec3 ArcLength::at(double fraction) const
{
    if (fraction <= 0)
        return points_.front();
    if (fraction >= 1)
        return points_.back();
    double const wanted_mm = fraction * length_mm();
    auto const share
        = std::min(static_cast<std::size_t>(fraction * static_cast<double>(points_.size())),
                   points_.size() - 1);
    std::size_t i = first_in_share_[share] + std::size_t { 1 };
    while (i < points_.size() && length_to_mm_[i] < wanted_mm)
        ++i;
    if (i >= points_.size())
        return points_.back();
    double const span_mm = length_to_mm_[i] - length_to_mm_[i - 1];
    if (span_mm <= 0)
        return points_[i];
    double const along = (wanted_mm - length_to_mm_[i - 1]) / span_mm;
    return points_[i - 1] + along * (points_[i] - points_[i - 1]);
}

std::vector<Vec3> resample(std::span<Vec3 const> points, std::size_t count)
{
    CHECK(count >= 2);
    ArcLength const curve(points);
    std::vector<Vec3> even(count);
    for (std::size_t i = 0; i < count; ++i)
        even[i] = curve.at(static_cast<double>(i) / static_cast<double>(count - 1));
    return even;
}

} // namespace tractus
