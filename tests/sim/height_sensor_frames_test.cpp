#include "sim/height_sensor_frames.h"

#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>

namespace tractus::sim {
namespace {

UsbSetup get(drivers::HeightSensorRequest request, std::uint16_t length)
{
    return { .request_type = drivers::kVendorInterfaceIn,
             .request = static_cast<std::uint8_t>(request),
             .length = length };
}

bool set(HeightSensorModel& model, drivers::HeightSensorRequest request, std::uint16_t value,
         std::vector<std::byte> const& data = {})
{
    return model.accept({ .request_type = drivers::kVendorInterfaceOut,
                          .request = static_cast<std::uint8_t>(request),
                          .value = value,
                          .length = static_cast<std::uint16_t>(data.size()) },
                        data);
}

// The expected bytes are those listed in firmware-notes/height-sensor-protocol.md.
TEST(HeightSensorModel, HasTheDescriptorsOfTheProtocol)
{
    HeightSensorModel const model;
    EXPECT_EQ(model.device_descriptor(),
              drivers::bytes("12 01 10 02 00 00 00 40 09 12 02 00 00 01 01 02 03 01"));
    EXPECT_EQ(model.configuration_descriptor(UsbSpeed::Full),
              drivers::bytes(
                  "09 02 19 00 01 01 00 80 32 09 04 00 00 01 ff 54 01 04 07 05 81 02 40 00 00"));
    EXPECT_EQ(model.configuration_descriptor(UsbSpeed::High),
              drivers::bytes(
                  "09 02 19 00 01 01 00 80 32 09 04 00 00 01 ff 54 01 04 07 05 81 02 00 02 00"));
    EXPECT_EQ(
        model.bos_descriptor(),
        drivers::bytes("05 0f 21 00 01 1c 10 05 00 df 60 dd d8 89 45 c7 4c 9c d2 65 9d 9e 64 8a 9f "
                       "00 00 03 06 a2 00 20 00"));
    EXPECT_EQ(model.strings().at(3), "tractus height sensor 1, full scale 4095");
}

TEST(HeightSensorModel, TellsWindowsWhichDriverToTake)
{
    HeightSensorModel const model;
    auto const set
        = model.answer({ .request_type = 0xC0, .request = 0x20, .index = 7, .length = 4096 }, 0);
    ASSERT_TRUE(set);
    EXPECT_EQ(*set, model.microsoft_os_descriptors());
    ASSERT_EQ(set->size(), 162u);
    // Each part of the set contains its own length; the lengths add up to that of the whole set.
    auto const length = [&](std::size_t at) { return std::to_integer<std::size_t>((*set)[at]); };
    EXPECT_EQ(length(0) + length(10) + length(30), set->size());
    EXPECT_EQ(length(8), set->size());
    EXPECT_FALSE(model.answer({ .request_type = 0xC0, .request = 0x20, .index = 4 }, 0));
}

TEST(HeightSensorModel, AnswersWithNoMoreThanWasAskedFor)
{
    HeightSensorModel const model;
    auto const whole
        = drivers::bytes("01 00 00 01 ff 0f 0c 01 64 00 20 4e 03 17 00 00 78 56 34 12");
    EXPECT_EQ(model.answer(get(drivers::HeightSensorRequest::GetIdentity, 64), 0x12345678), whole);
    auto const part = model.answer(get(drivers::HeightSensorRequest::GetIdentity, 2), 0);
    EXPECT_EQ(part, drivers::bytes("01 00"));
    EXPECT_EQ(model.answer(get(drivers::HeightSensorRequest::GetRate, 4), 0),
              drivers::bytes("e8 03 05 00"));
    EXPECT_EQ(model.answer(get(drivers::HeightSensorRequest::GetReference, 1), 0),
              drivers::bytes("00"));
}

TEST(HeightSensorModel, StallsWhatItDoesNotDoAndKeepsItsSettings)
{
    HeightSensorModel model;
    using Request = drivers::HeightSensorRequest;
    // A rate that is too high is refused.
    EXPECT_FALSE(set(model, Request::SetRate, 0, drivers::bytes("01 00 05 00")));
    // A frame of 24 readings is too long and is refused.
    EXPECT_FALSE(set(model, Request::SetRate, 0, drivers::bytes("e8 03 18 00")));
    // A frame without readings is refused.
    EXPECT_FALSE(set(model, Request::SetRate, 0, drivers::bytes("e8 03 00 00")));
    // A reserved byte that is set is refused.
    EXPECT_FALSE(set(model, Request::SetRate, 0, drivers::bytes("e8 03 05 01")));
    EXPECT_FALSE(set(model, Request::SetRate, 0, drivers::bytes("e8 03 05")));
    EXPECT_FALSE(set(model, Request::SetRate, 1, drivers::bytes("d0 07 05 00")));
    EXPECT_FALSE(set(model, Request::SetReference, 0, drivers::bytes("02")));
    EXPECT_FALSE(set(model, Request::SetStreaming, 2));
    EXPECT_FALSE(set(model, Request::SetStreaming, 1, drivers::bytes("00")));
    EXPECT_FALSE(set(model, Request::GetRate, 0));
    EXPECT_FALSE(set(model, Request { 9 }, 0));
    EXPECT_FALSE(model.answer(get(Request { 9 }, 4), 0));
    EXPECT_FALSE(model.answer(get(Request::SetRate, 4), 0));
    EXPECT_EQ(model.period_us(), 1000);
    EXPECT_EQ(model.reference(), drivers::HeightReference::Supply);
    EXPECT_FALSE(model.is_streaming());
}

TEST(HeightSensorModel, SendsNothingUntilItIsToldTo)
{
    HeightSensorModel model({ .samples_per_frame = 1 });
    EXPECT_FALSE(model.push(0, 1));
    EXPECT_TRUE(set(model, drivers::HeightSensorRequest::SetStreaming, 1));
    EXPECT_TRUE(model.push(1000, 1));
    EXPECT_TRUE(set(model, drivers::HeightSensorRequest::SetStreaming, 0));
    EXPECT_FALSE(model.push(2000, 1));
}

TEST(HeightSensorModel, MarksTheFirstFrameAndNumbersAll)
{
    HeightSensorModel model({ .samples_per_frame = 1 });
    ASSERT_TRUE(set(model, drivers::HeightSensorRequest::SetStreaming, 1));
    auto const first = model.push(0, 0).value();
    auto const second = model.push(1000, 0).value();
    model.lose_frames(3);
    auto const third = model.push(5000, 0).value();
    EXPECT_EQ(first[4], std::byte { drivers::kHeightFrameStart });
    EXPECT_EQ(second[4], std::byte { 0 });
    EXPECT_EQ(second[6], std::byte { 1 });
    EXPECT_EQ(third[4], std::byte { drivers::kHeightFrameOverrun });
    EXPECT_EQ(third[6], std::byte { 5 });
    // Streaming is switched on again.
    ASSERT_TRUE(set(model, drivers::HeightSensorRequest::SetStreaming, 1));
    auto const again = model.push(6000, 0).value();
    EXPECT_EQ(again[4], std::byte { drivers::kHeightFrameStart });
    EXPECT_EQ(again[6], std::byte { 0 });
}

TEST(HeightSensorModel, BeginsANewFrameAtANewRate)
{
    HeightSensorModel model({ .samples_per_frame = 2 });
    ASSERT_TRUE(set(model, drivers::HeightSensorRequest::SetStreaming, 1));
    EXPECT_FALSE(model.push(0, 7));
    ASSERT_TRUE(
        set(model, drivers::HeightSensorRequest::SetRate, 0, drivers::bytes("d0 07 02 00")));
    EXPECT_FALSE(model.push(1000, 8));
    auto const frame = model.push(3000, 9).value();
    EXPECT_EQ(frame[12], std::byte { 0xD0 });
    EXPECT_EQ(frame[14], std::byte { 8 });
    EXPECT_EQ(frame[16], std::byte { 9 });
}

} // namespace
} // namespace tractus::sim
