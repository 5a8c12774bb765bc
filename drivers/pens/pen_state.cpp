#include "drivers/pens/pen_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::drivers {

std::optional<Duration> PenState::silence_limit() const
{
    if (!last_.in_range)
        return std::nullopt;
    if (reported_left_at_)
        return *reported_left_at_ - last_.time + habits_.false_leave;
    if (habits_.rests_in_silence)
        return std::nullopt;
    if (!last_.touching)
        return can_report_leaving() ? std::nullopt : std::optional<Duration>(kSilence);
    auto const interval = rhythm_.streaming_interval();
    if (!interval)
        return std::nullopt;
    return std::max(can_report_leaving() ? kUnreportedLeaveSilence : kSilence,
                    kSilentIntervals * *interval);
}

std::optional<PenSample> PenState::leave(Timestamp time)
{
    reported_left_at_.reset();
    rhythm_.interrupt_run();
    if (!last_.in_range)
        return std::nullopt;
    went_silent_touching_ = last_.touching;
    last_.time = time;
    last_.in_range = false;
    last_.touching = false;
    last_.buttons = 0;
    last_.raw_pressure = 0;
    if (last_.pressure)
        last_.pressure = 0;
    return last_;
}

void PenState::undo_habits(PenFields& fields) const
{
    constexpr std::uint32_t kSecondButton = 2, kThirdButton = 4;
    if (habits_.second_button_is_eraser && std::exchange(fields.eraser_touch, false))
        fields.buttons |= kSecondButton;
    if (habits_.third_button_is_invert && fields.invert && last_.in_range && !last_.eraser) {
        fields.invert = false;
        fields.buttons |= kThirdButton;
    }
}

void PenState::read_pressure(PenSample& sample, PenFields const& fields,
                             PenScale const& scale) const
{
    if (!scale.has_pressure)
        return;
    sample.raw_pressure = fields.pressure.value_or(last_.raw_pressure);
    auto const range
        = static_cast<double>(scale.pressure_maximum) - static_cast<double>(scale.pressure_minimum);
    auto const above
        = static_cast<double>(sample.raw_pressure) - static_cast<double>(scale.pressure_minimum);
    sample.pressure = std::clamp(above / range, 0.0, 1.0);
}

// Converts the position and tilt. Y is inverted, because reports count from the tablet's far edge,
// and the tablet frame counts from the near edge.
void PenState::place(PenSample& sample, PenFields const& fields, PenScale const& scale) const
{
    if (scale.has_tilt)
        sample.tilt_rad = fields.tilt_deg
            ? Vec2(radians(fields.tilt_deg->x()), -radians(fields.tilt_deg->y()))
            : last_.tilt_rad;
    if (!fields.carries_position)
        return;
    sample.raw_x = fields.x;
    sample.raw_y = fields.y;
    sample.position_mm = {
        (static_cast<double>(fields.x) - static_cast<double>(scale.x_minimum))
            * scale.mm_per_count.x(),
        (static_cast<double>(scale.y_maximum) - static_cast<double>(fields.y))
            * scale.mm_per_count.y(),
    };
    if (habits_.coil_height_mm != 0 && sample.tilt_rad)
        sample.position_mm -= habits_.coil_height_mm * sample.tilt_rad->array().sin().matrix();
}

bool PenState::is_other_tool(PenSample const& sample) const
{
    // A change of serial number during a stroke is ignored, because nobody changes pens while
    // drawing.
    bool const other_pen = !last_.touching && sample.tool_serial != 0 && last_.tool_serial != 0
        && sample.tool_serial != last_.tool_serial;
    return last_.in_range && (sample.eraser != last_.eraser || other_pen);
}

// True if a sample must be held back because the device may be wrong in reporting that the pen has
// left. Some devices report leaving and then hovering when a button is pressed.
bool PenState::is_in_doubt(PenSample const& sample)
{
    if (habits_.false_leave == Duration::zero() || !last_.in_range)
        return false;
    if (!sample.in_range && !reported_left_at_)
        reported_left_at_ = sample.time;
    if (!reported_left_at_)
        return false;
    if (sample.in_range && (sample.touching || !last_.touching))
        reported_left_at_.reset();
    return reported_left_at_.has_value();
}

// Updates what is known of the tablet's reporting pace from a sample in range. `last_` is still the
// previous sample.
void PenState::follow_rhythm(Timestamp received, PenFields const& fields, PenSample const& sample)
{
    constexpr double kSamePlace_mm = 1;
    if (std::exchange(went_silent_touching_, false) && sample.touching
        && (sample.position_mm - last_.position_mm).norm() <= kSamePlace_mm)
        rhythm_.disprove();
    rhythm_.push(received, fields);
}

bool PenState::has_moved_during_silence(PenSample const& sample) const
{
    return last_.touching && sample.touching && !can_report_leaving()
        && sample.time - last_.time > kSilence
        && (sample.position_mm - last_.position_mm).norm() > kFarthestAfterRest_mm;
}

// Handles a report that the pen has left, as opposed to a silence.
std::optional<PenSample> PenState::leave_as_reported(Timestamp time)
{
    auto const left = leave(time);
    went_silent_touching_ = false;
    return left;
}

std::optional<PenSample> PenState::push(Timestamp received, PenFields fields, PenScale const& scale)
{
    auto const as_reported = fields;
    if (reported_left_at_ && received - *reported_left_at_ > habits_.false_leave)
        return leave_as_reported(*reported_left_at_);
    undo_habits(fields);
    says_in_range_ = fields.in_range.has_value();

    PenSample sample { .time = received,
                       .position_mm = last_.position_mm,
                       .tool_serial = fields.tool_serial,
                       .tool_type = fields.tool_type,
                       .raw_x = last_.raw_x,
                       .raw_y = last_.raw_y };
    read_pressure(sample, fields, scale);
    bool const presses = scale.has_pressure && fields.in_range.value_or(true)
        && sample.raw_pressure > std::max(scale.pressure_minimum, scale.touch_above);
    sample.touching = fields.tip.value_or(presses) || fields.eraser_touch;
    sample.eraser = fields.eraser_touch || fields.invert;
    sample.in_range = sample.touching || fields.in_range.value_or(true);
    if (is_in_doubt(sample))
        return std::nullopt;
    if (!sample.in_range || is_other_tool(sample))
        return leave_as_reported(received);

    if (!fields.carries_position && !has_position_)
        return std::nullopt;
    has_position_ = true;
    place(sample, fields, scale);
    if (has_moved_during_silence(sample))
        return leave_as_reported(received);
    follow_rhythm(received, as_reported, sample);
    sample.buttons = fields.buttons;
    last_ = sample;
    return sample;
}

} // namespace tractus::drivers
