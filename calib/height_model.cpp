#include "calib/height_model.h"

#include <cmath>

namespace tractus {

static std::optional<double> if_finite(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

static std::optional<double> to_height(LinearHeight const& model, double counts)
{
    return if_finite(model.mm_per_count * (counts - model.zero_counts));
}

static std::optional<double> to_height(StringHeight const& model, double counts)
{
    double const length_mm = model.mm_per_count * counts + model.zero_length_mm;
    if (!(length_mm >= model.offset_mm))
        return std::nullopt;
    // (L - offset)(L + offset) keeps its digits where L is hardly longer than the offset.
    double const rise_mm = std::sqrt((length_mm - model.offset_mm) * (length_mm + model.offset_mm));
    return if_finite(rise_mm - model.base_mm);
}

static std::optional<double> to_counts(LinearHeight const& model, double height_mm)
{
    return if_finite(height_mm / model.mm_per_count + model.zero_counts);
}

static std::optional<double> to_counts(StringHeight const& model, double height_mm)
{
    double const rise_mm = height_mm + model.base_mm;
    if (!(rise_mm >= 0))
        return std::nullopt;
    double const length_mm = std::hypot(rise_mm, model.offset_mm);
    return if_finite((length_mm - model.zero_length_mm) / model.mm_per_count);
}

std::optional<double> height_mm(HeightModel const& model, double counts)
{
    return std::visit([&](auto const& kind) { return to_height(kind, counts); }, model);
}

std::optional<double> counts_at_height(HeightModel const& model, double height_mm)
{
    return std::visit([&](auto const& kind) { return to_counts(kind, height_mm); }, model);
}

} // namespace tractus
