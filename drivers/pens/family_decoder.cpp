#include "drivers/pens/family_decoder.h"

#include "drivers/pens/pen_state.h"
#include "engine/base/check.h"

#include <algorithm>
#include <vector>

namespace tractus::drivers {

namespace {

PenTraits traits_of(PenFamily const& family, TabletShape const& shape)
{
    return {
        .size_mm = shape.size_mm,
        .is_size_assumed = shape.is_size_assumed,
        .has_pressure = shape.pressure_maximum > 0,
        .has_tilt = family.has_tilt,
        .has_in_range = family.reports_leaving,
        .has_eraser = family.has_eraser,
        .button_count = std::min(shape.button_count, family.button_count),
        .raw_x_maximum = shape.x_maximum,
        .raw_y_maximum = shape.y_maximum,
        .raw_pressure_maximum = shape.pressure_maximum,
    };
}

PenScale scale_of(PenFamily const& family, TabletShape const& shape)
{
    return {
        .y_maximum = shape.y_maximum,
        .mm_per_count
        = { shape.size_mm.x() / shape.x_maximum, shape.size_mm.y() / shape.y_maximum },
        .has_pressure = shape.pressure_maximum > 0,
        .pressure_maximum = std::max(shape.pressure_maximum, 1),
        .touch_above = family.touch_above,
        .has_tilt = family.has_tilt,
    };
}

class FamilyDecoder final : public PenDecoder {
public:
    FamilyDecoder(PenFamily const& family, TabletShape const& shape)
        : family_(family)
        , traits_(traits_of(family, shape))
        , scale_(scale_of(family, shape))
        , format_({ .x_maximum = shape.x_maximum })
        , pen_({ .reports_leaving = family.reports_leaving })
    {
    }

    using PenDecoder::decode;
    PenTraits const& traits() const override { return traits_; }
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<PenSample>& out) override;
    std::optional<Duration> silence_limit() const override { return pen_.silence_limit(); }
    std::optional<PenSample> leave(Timestamp time) override;

private:
    PenFamily family_;
    PenTraits traits_;
    PenScale scale_;
    FamilyState format_;
    PenState pen_;
    std::vector<PenFields> frames_; // Pen states of the newest report.
    // Time of the newest report, or of the pen's leaving if that was later.
    std::optional<Timestamp> last_time_;
};

Result<void> FamilyDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                   std::vector<PenSample>& out)
{
    if (report.empty())
        return fail(Fault::Device, "an empty report");
    frames_.clear();
    for (format_.frame = 0; format_.frame < family_.frames; ++format_.frame)
        if (auto const fields = family_.decode(report, format_))
            frames_.push_back(*fields);
    if (frames_.empty())
        return {};
    auto age = static_cast<Duration::rep>(frames_.size());
    auto interval = family_.frame_interval;
    if (last_time_)
        interval = std::clamp((received - *last_time_) / age, Duration(0), interval);
    last_time_ = received;
    for (auto const& fields : frames_)
        if (auto const sample = pen_.push(received - --age * interval, fields, scale_))
            out.push_back(*sample);
    return {};
}

// Remembers the time, so that later states are not dated before the pen left.
std::optional<PenSample> FamilyDecoder::leave(Timestamp time)
{
    last_time_ = last_time_ ? std::max(*last_time_, time) : time;
    return pen_.leave(time);
}

} // namespace

std::unique_ptr<PenDecoder> make_family_decoder(PenFamily const& family, TabletShape const& shape)
{
    CHECK(family.decode);
    CHECK(shape.x_maximum > 0 && shape.y_maximum > 0);
    return std::make_unique<FamilyDecoder>(family, shape);
}

} // namespace tractus::drivers
