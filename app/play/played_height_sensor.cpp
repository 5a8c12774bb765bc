#include "app/play/played_height_sensor.h"

#include "drivers/reports/clock.h"

#include <chrono>
#include <utility>

namespace tractus::play {

namespace {

// Readings that are late by more than this, as after the computer has slept, are skipped.
constexpr Duration kLongestDelay = std::chrono::seconds(1);

// Converts a time to the sensor's clock, which counts microseconds in 32 bits.
std::uint32_t device_us(Timestamp time)
{
    auto const since = std::chrono::floor<std::chrono::microseconds>(time.time_since_epoch());
    return static_cast<std::uint32_t>(since.count());
}

sim::HeightSensorModel make_model(sim::HeightCurve const& heights)
{
    sim::HeightSensorModel::Options options;
    options.full_scale = static_cast<std::uint16_t>(heights.full_scale());
    return sim::HeightSensorModel(options);
}

} // namespace

PlayedHeightSensor::PlayedHeightSensor(sim::HeightCurve heights)
    : heights_(std::move(heights))
    , model_(make_model(heights_))
{
}

Result<std::unique_ptr<PlayedHeightSensor>> PlayedHeightSensor::add_to(sim::UsbGadget& gadget,
                                                                       sim::HeightCurve heights)
{
    std::unique_ptr<PlayedHeightSensor> sensor(new PlayedHeightSensor(std::move(heights)));
    auto const& model = sensor->model_;
    sim::UsbFunctionDescriptors const descriptors {
        .full_speed = model.interface_descriptors(sim::UsbSpeed::Full, 1),
        .high_speed = model.interface_descriptors(sim::UsbSpeed::High, 1),
        .name = model.interface_string(),
    };
    sensor->device_ = TRY(sim::FunctionFsDevice::add_to(gadget, descriptors, sensor->answers()));
    return sensor;
}

sim::UsbControlAnswers PlayedHeightSensor::answers()
{
    return {
        .get =
            [this](sim::UsbSetup const& setup) {
                return model_.answer(setup, device_us(drivers::monotonic_now()));
            },
        .set =
            [this](sim::UsbSetup const& setup, std::span<std::byte const> data) {
                bool const was_streaming = model_.is_streaming();
                bool const is_accepted = model_.accept(setup, data);
                if (!was_streaming && model_.is_streaming())
                    next_reading_ = drivers::monotonic_now();
                return is_accepted;
            },
        .reset = [this] { model_ = make_model(heights_); },
    };
}

Timestamp PlayedHeightSensor::due() const
{
    return model_.is_streaming() ? next_reading_ : Timestamp::max();
}

Result<void> PlayedHeightSensor::play(Timestamp now)
{
    if (now - next_reading_ > kLongestDelay)
        next_reading_ = now;
    while (due() <= now)
        TRY(measure());
    return {};
}

Result<void> PlayedHeightSensor::measure()
{
    auto const since_begin = begin_ ? next_reading_ - *begin_ : Duration::zero();
    auto const counts = heights_.counts_at(Timestamp(since_begin), heights_.full_scale());
    auto const frame = model_.push(device_us(next_reading_), static_cast<std::uint16_t>(counts));
    next_reading_ += std::chrono::microseconds(model_.period_us());
    return frame ? device_->send(*frame) : Result<void>();
}

bool PlayedHeightSensor::is_over(Timestamp now) const
{
    return begin_ && now - *begin_ > heights_.end().time_since_epoch();
}

} // namespace tractus::play
