#pragma once

#include "app/play/device_parts.h"
#include "sim/function_fs_device.h"
#include "sim/height_curve.h"
#include "sim/height_sensor_frames.h"
#include "sim/usb_gadget.h"

#include <memory>
#include <optional>

namespace tractus::play {

// Emulates the program's own height sensor (firmware-notes/height-sensor-protocol.md) as a function
// of a USB gadget. The sensor measures the heights of a recording. It answers the host's requests,
// and sends frames while the host asks for them. Its time is this computer's clock.
class PlayedHeightSensor final : public DevicePart {
public:
    // Adds the sensor to `gadget`, which must not be plugged in yet and must outlive the sensor.
    // Fails like FunctionFsDevice::add_to().
    static Result<std::unique_ptr<PlayedHeightSensor>> add_to(sim::UsbGadget& gadget,
                                                              sim::HeightCurve heights);

    sim::KernelDevice& device() { return *device_; }

    void begin(Timestamp now) override { begin_ = now; }
    Timestamp due() const override;
    Result<void> play(Timestamp now) override;
    bool is_over(Timestamp now) const override;

private:
    explicit PlayedHeightSensor(sim::HeightCurve heights);

    sim::UsbControlAnswers answers();
    Result<void> measure();

    sim::HeightCurve heights_;
    sim::HeightSensorModel model_;
    std::unique_ptr<sim::FunctionFsDevice> device_;
    std::optional<Timestamp> begin_ {};
    Timestamp next_reading_ {}; // Time of the next reading, while the host asks for frames.
};

} // namespace tractus::play
