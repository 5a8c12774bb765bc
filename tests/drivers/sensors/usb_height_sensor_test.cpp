#include "drivers/sensors/usb_height_sensor.h"

#include "drivers/height_decoders.h"
#include "sim/height_sensor_frames.h"
#include "tests/drivers/heights.h"

#include <algorithm>
#include <deque>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

// A sensor model that answers requests. Its simulated time advances with each read, and the sensor
// measures during that time.
struct FakeSensor {
    sim::HeightSensorModel model;
    bool is_plugged = true;
    std::deque<std::vector<std::byte>> waiting; // Frames that have not been fetched yet.
    std::uint32_t now_us = 1000;
};

class FakeSensorLink final : public HeightSensorLink {
public:
    explicit FakeSensorLink(FakeSensor& sensor)
        : sensor_(sensor)
    {
    }

    Result<std::vector<std::byte>> get(HeightSensorRequest request, std::size_t bytes) override
    {
        auto const data
            = sensor_.model.answer(setup(kVendorInterfaceIn, request, 0, bytes), sensor_.now_us);
        if (!sensor_.is_plugged || !data)
            return fail(Fault::Device, "stalled");
        return *data;
    }

    Result<void> set(HeightSensorRequest request, std::uint16_t value,
                     std::span<std::byte const> data) override
    {
        if (!sensor_.is_plugged
            || !sensor_.model.accept(setup(kVendorInterfaceOut, request, value, data.size()), data))
            return fail(Fault::Device, "stalled");
        return {};
    }

    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        if (!sensor_.is_plugged)
            return fail(Fault::Device, "unplugged");
        auto const end_us = sensor_.now_us + static_cast<std::uint32_t>(timeout / 1us);
        while (sensor_.waiting.empty() && sensor_.now_us < end_us) {
            sensor_.now_us += sensor_.model.period_us();
            if (auto frame = sensor_.model.push(sensor_.now_us, 1234))
                sensor_.waiting.push_back(*std::move(frame));
        }
        if (sensor_.waiting.empty())
            return std::optional<RawReport>();
        RawReport report { .received = Timestamp(1us * sensor_.now_us),
                           .size = sensor_.waiting.front().size() };
        std::copy(sensor_.waiting.front().begin(), sensor_.waiting.front().end(),
                  report.storage.begin());
        sensor_.waiting.pop_front();
        return std::optional(report);
    }

private:
    static sim::UsbSetup setup(std::uint8_t type, HeightSensorRequest request, std::uint16_t value,
                               std::size_t bytes)
    {
        return { .request_type = type,
                 .request = static_cast<std::uint8_t>(request),
                 .value = value,
                 .length = static_cast<std::uint16_t>(bytes) };
    }

    FakeSensor& sensor_;
};

Result<std::unique_ptr<ReportSource>> open(FakeSensor& sensor,
                                           UsbHeightSensorOptions const& options = {})
{
    return open_usb_height_sensor(sensor.model.info(), std::make_unique<FakeSensorLink>(sensor),
                                  options);
}

TEST(UsbHeightSensor, StreamsFramesThatDecode)
{
    FakeSensor sensor;
    auto const source = open(sensor);
    ASSERT_TRUE(source) << source.error().message;
    auto const decoder = make_height_decoder((*source)->info()).value();
    std::vector<HeightSample> samples;
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(decoder->decode((*source)->read(100ms).value().value(), samples));
    ASSERT_EQ(samples.size(), 100u);
    EXPECT_EQ(samples[0].counts, 1234);
    for (std::size_t i = 1; i < samples.size(); ++i)
        EXPECT_EQ(samples[i].time - samples[i - 1].time, 1ms);
    EXPECT_EQ(decoder->stream_counts().lost_frames, 0u);
}

TEST(UsbHeightSensor, ForgetsWhatTheSensorSentBefore)
{
    FakeSensor sensor;
    HeightFrame stale { .sequence = 77, .period_us = 1000, .count = 1, .counts = { 1 } };
    for (int i = 0; i < 40; ++i)
        sensor.waiting.push_back(sim::encode_height_frame(stale));
    auto const source = open(sensor).value();
    auto const first = source->read(100ms).value().value();
    EXPECT_EQ(first.storage[4], std::byte { kHeightFrameStart });
    EXPECT_EQ(first.storage[6], std::byte { 0 });
}

TEST(UsbHeightSensor, SetsRateAndReference)
{
    FakeSensor sensor;
    auto const source = open(
        sensor,
        { .period_us = 2000, .samples_per_frame = 1, .reference = HeightReference::Internal });
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(sensor.model.period_us(), 2000);
    EXPECT_EQ(sensor.model.reference(), HeightReference::Internal);
    EXPECT_EQ((*source)->read(100ms).value()->storage[5], std::byte { 1 });
}

TEST(UsbHeightSensor, KeepsTheSensorsRateWhereNoneIsAskedFor)
{
    FakeSensor sensor;
    ASSERT_TRUE(open(sensor, { .samples_per_frame = 3 }));
    EXPECT_EQ(sensor.model.period_us(), 1000);
}

TEST(UsbHeightSensor, BlamesTheUserForARateThatItDoesNotDo)
{
    FakeSensor sensor;
    auto const source = open(sensor, { .period_us = 10 });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
    EXPECT_EQ(source.error().message,
              "Height sensor at simulated does not read every 10 us with 5 readings to a frame "
              "(stalled)");
}

TEST(UsbHeightSensor, StopsTheSensorWhenItGoes)
{
    FakeSensor sensor;
    {
        auto const source = open(sensor).value();
        EXPECT_TRUE(sensor.model.is_streaming());
    }
    EXPECT_FALSE(sensor.model.is_streaming());
}

TEST(UsbHeightSensor, SaysThatItWasUnplugged)
{
    FakeSensor sensor;
    auto const source = open(sensor).value();
    sensor.is_plugged = false;
    EXPECT_FALSE(source->read(10ms));
}

TEST(UsbHeightSensor, ItsOptionsAreReadFromAnAddress)
{
    auto const options = parse_usb_height_sensor_options("2000us,internal").value();
    EXPECT_EQ(options.period_us, 2000);
    EXPECT_EQ(options.reference, HeightReference::Internal);
    EXPECT_FALSE(parse_usb_height_sensor_options("").value().period_us);
    for (auto const* const wrong : { "0us", "65536us", "us", "fast", "2ms" })
        EXPECT_FALSE(parse_usb_height_sensor_options(wrong)) << wrong;
}

TEST(UsbHeightSensor, NeedsAnAddressOnUsb)
{
    auto const source = open_usb_height_sensor({ .name = "Sensor", .location = "/dev/hidraw0" });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
    EXPECT_EQ(source.error().message,
              "Sensor at /dev/hidraw0 is no USB device by its port: expected usb:BUS-PORTS");
}

} // namespace
} // namespace tractus::drivers
