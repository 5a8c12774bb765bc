// Tests pens that are decoded by their report descriptors: Wacom's own usage page, and known habits
// of some models.

#include "drivers/pens/descriptor_decoder.h"
#include "drivers/pens/known_habits.h"
#include "tests/drivers/decode_one.h"
#include "tests/drivers/devices.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

// Decodes the reports of one device, 5 ms apart.
class Device {
public:
    explicit Device(DeviceInfo const& info)
        : decoder_(make_descriptor_decoder(info).value())
    {
    }

    std::optional<PenSample> report(std::string const& text)
    {
        time_ += 5ms;
        return decode_one(*decoder_, time_, bytes(text)).value();
    }

    // Returns the sample of a report that must give one.
    PenSample sample(std::string const& text)
    {
        auto const result = report(text);
        EXPECT_TRUE(result) << text;
        return result.value_or(PenSample());
    }

    PenDecoder& decoder() { return *decoder_; }

private:
    std::unique_ptr<PenDecoder> decoder_;
    Timestamp time_ {};
};

// A pen of 200 x 100 mm, 0.01 mm per count, on Wacom's page 0xFF0D. The bytes of its report:
//   10            id
//   ..            bits: 0 tip, 1 barrel, 2 eraser, 3 invert, 4 in proximity, 5 in range
//   .. .. ..      x
//   .. .. ..      y
//   .. ..         pressure, 0 to 4095
//   .. .. .. ..   serial number
//   .. ..         type of the tool
// Its other report, 13, is the state of its battery.
DeviceInfo wacom_page_pen()
{
    return { .vendor_id = 0x056a,
             .report_descriptor
             = bytes("06 0d ff 09 01 a1 01 85 10 09 20 a1 00"
                     "09 42 09 44 09 45 09 3c 09 36 09 32 15 00 25 01 75 01 95 06 81 02"
                     "95 02 81 03"
                     "0a 30 01 27 20 4e 00 00 46 c8 00 65 11 55 0f 75 18 95 01 81 02"
                     "0a 31 01 27 10 27 00 00 46 64 00 81 02"
                     "09 30 26 ff 0f 45 00 65 00 55 00 75 10 81 02"
                     "09 5b 17 00 00 00 80 27 ff ff ff 7f 75 20 81 02"
                     "09 77 15 00 26 ff 0f 75 10 81 02"
                     "c0 85 13 0a 3b 04 25 64 75 08 81 02 c0") };
}

constexpr char const* kSerial = " 78 56 34 12 42 08";

std::string with_serial(std::string report)
{
    report += kSerial;
    return report;
}

TEST(WacomPage, ReadsPlacePressureAndTip)
{
    Device device(wacom_page_pen());
    EXPECT_NEAR(device.decoder().traits().size_mm.x(), 200, 1e-9);
    auto const pen = device.sample(with_serial("10 33 10 27 00 c4 09 00 ff 0f"));
    EXPECT_NEAR(pen.position_mm.x(), 100, 1e-9);
    EXPECT_NEAR(pen.position_mm.y(), 75, 1e-9);
    EXPECT_EQ(pen.pressure, 1.0);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(pen.buttons, 1u);
}

TEST(WacomPage, SerialAndTypeComeWithTheTool)
{
    Device device(wacom_page_pen());
    auto const pen = device.sample(with_serial("10 30 10 27 00 c4 09 00 00 00"));
    EXPECT_EQ(pen.tool_serial, 0x12345678u);
    EXPECT_EQ(pen.tool_type, 0x0842u);
}

TEST(WacomPage, ProximityWithoutRangeDoesNotMoveThePen)
{
    Device device(wacom_page_pen());
    auto const high = with_serial("10 10 00 00 00 00 00 00 00 00");
    EXPECT_EQ(device.report(high), std::nullopt);
    device.sample(with_serial("10 30 10 27 00 c4 09 00 00 00"));
    auto const gone = device.sample(high);
    EXPECT_FALSE(gone.in_range);
    EXPECT_NEAR(gone.position_mm.x(), 100, 1e-9);
}

TEST(WacomPage, OutOfRangeIsSaidOnce)
{
    Device device(wacom_page_pen());
    device.sample(with_serial("10 30 10 27 00 c4 09 00 00 00"));
    auto const out = "10 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00";
    EXPECT_FALSE(device.sample(out).in_range);
    EXPECT_EQ(device.report(out), std::nullopt);
    EXPECT_EQ(device.report(out), std::nullopt);
}

TEST(WacomPage, ABatteryReportIsNoEvent)
{
    Device device(wacom_page_pen());
    auto const hovering = with_serial("10 30 10 27 00 c4 09 00 00 00");
    auto const before = device.sample(hovering);
    EXPECT_EQ(device.report("13 40"), std::nullopt);
    EXPECT_EQ(device.sample(hovering).position_mm, before.position_mm);
}

// Returns a digitizer's pen. A report has one byte of bits, of which the first six have the given
// usages, and three two-byte numbers: X up to 20000, Y up to 10000, and pressure up to 8191.
DeviceInfo pen_with_bits(std::uint16_t vendor_id, std::uint16_t product_id,
                         std::string const& six_usages)
{
    return { .vendor_id = vendor_id,
             .product_id = product_id,
             .report_descriptor
             = bytes("05 0d 09 02 a1 01 85 07 09 20 a1 00" + six_usages
                     + "15 00 25 01 75 01 95 06 81 02 95 02 81 03"
                       "05 01 09 30 26 20 4e 75 10 95 01 81 02 09 31 26 10 27 81 02"
                       "05 0d 09 30 26 ff 1f 81 02 c0 c0") };
}

constexpr char const* kTipBarrelEraserInvertRange = "09 42 09 44 09 45 09 3c 09 32 09 00";

TEST(KnownHabits, APenThatCannotTurnHasTwoButtonsAndNoEraser)
{
    Device device(pen_with_bits(0x28bd, 0x0042, "09 42 09 44 09 45 09 00 09 32 09 00"));
    EXPECT_FALSE(device.decoder().traits().has_eraser);
    EXPECT_EQ(device.decoder().traits().button_count, 2u);
    auto const pen = device.sample("07 14 10 27 c4 09 00 00");
    EXPECT_FALSE(pen.touching);
    EXPECT_FALSE(pen.eraser);
    EXPECT_EQ(pen.buttons, 2u);
}

TEST(KnownHabits, HuionsSecondButtonIsTheEraser)
{
    Device device(pen_with_bits(0x256c, 0x006d, kTipBarrelEraserInvertRange));
    auto const pen = device.sample("07 15 10 27 c4 09 ff 0f");
    EXPECT_TRUE(pen.touching);
    EXPECT_FALSE(pen.eraser);
    EXPECT_EQ(pen.buttons, 2u);
}

TEST(KnownHabits, HuionsSecondButtonIsTheEraserBesideATipSwitchThatNeverComes)
{
    // A Q11K, a K26 or a W58 in its power-up mode. Usages of its bits: tip, barrel, eraser, invert,
    // secondary tip, in range. The upper button is pressed while the pen hovers, and then while it
    // draws.
    Device device(pen_with_bits(0x256c, 0x006e, "09 42 09 44 09 45 09 3c 09 43 09 32"));
    EXPECT_EQ(device.decoder().traits().button_count, 2u);
    EXPECT_EQ(device.sample("07 20 10 27 c4 09 00 00").buttons, 0u);
    auto const hovering = device.sample("07 24 10 27 c4 09 00 00");
    EXPECT_FALSE(hovering.touching || hovering.eraser);
    EXPECT_EQ(hovering.buttons, 2u);
    auto const drawing = device.sample("07 25 10 27 c4 09 ff 0f");
    EXPECT_TRUE(drawing.touching);
    EXPECT_FALSE(drawing.eraser);
    EXPECT_EQ(drawing.buttons, 2u);
}

TEST(KnownHabits, OtherPensErasersAreErasers)
{
    Device device(pen_with_bits(0x1b96, 0x1000, kTipBarrelEraserInvertRange));
    auto const pen = device.sample("07 14 10 27 c4 09 ff 0f");
    EXPECT_TRUE(pen.touching && pen.eraser);
    EXPECT_EQ(pen.buttons, 0u);
}

TEST(KnownHabits, ADescriptorThatWasPutRightIsBelieved)
{
    // Linux has corrected the usage of the second button.
    Device device(pen_with_bits(0x28bd, 0x093a, "09 42 09 44 09 5a 09 45 09 32 09 00"));
    EXPECT_TRUE(device.decoder().traits().has_eraser);
    EXPECT_TRUE(device.sample("07 18 10 27 c4 09 ff 0f").eraser);
    EXPECT_EQ(device.sample("07 00 00 00 00 00 00 00").in_range, false);
    EXPECT_EQ(device.sample("07 14 10 27 c4 09 00 00").buttons, 2u);
}

TEST(KnownHabits, AnArtist24HoldsItsFalseLeave)
{
    Device device(pen_with_bits(0x28bd, 0x093a, "09 42 09 44 09 45 09 00 09 32 09 00"));
    EXPECT_TRUE(device.sample("07 11 10 27 c4 09 ff 0f").touching);
    EXPECT_EQ(device.report("07 00 00 00 00 00 00 00"), std::nullopt); // The button is pressed.
    EXPECT_EQ(device.report("07 14 10 27 c4 09 00 00"), std::nullopt);
    auto const pressed = device.sample("07 15 10 27 c4 09 ff 0f");
    EXPECT_TRUE(pressed.touching);
    EXPECT_EQ(pressed.buttons, 2u);
}

TEST(KnownHabits, SecondaryTipSwitchIsTheSecondButton)
{
    // A Kamvas Pro 19. Usages of its bits: tip, barrel, secondary tip, invert, eraser, in range.
    Device device(pen_with_bits(0x256c, 0x006b, "09 42 09 44 09 43 09 3c 09 45 09 32"));
    EXPECT_EQ(device.sample("07 20 10 27 c4 09 00 00").buttons, 0u);
    EXPECT_EQ(device.sample("07 24 10 27 c4 09 00 00").buttons, 2u);
    EXPECT_EQ(device.sample("07 28 10 27 c4 09 00 00").buttons, 4u); // Invert is the third button.
    EXPECT_FALSE(device.sample("07 00 00 00 00 00 00 00").in_range);
    // The pen comes into range with its eraser end towards the tablet.
    EXPECT_TRUE(device.sample("07 28 10 27 c4 09 00 00").eraser);
    EXPECT_TRUE(device.sample("07 30 10 27 c4 09 ff 0f").touching);
}

TEST(DescriptorDecoder, BelievesAKnownSizeWhereTheDescriptorTellsNone)
{
    auto const info = pen_with_bits(0x256c, 0x006d, kTipBarrelEraserInvertRange);
    auto const guessed = make_descriptor_decoder(info).value();
    EXPECT_TRUE(guessed->traits().is_size_assumed);
    EXPECT_NEAR(guessed->traits().size_mm.x(), 100, 1e-9);
    auto const known = make_descriptor_decoder(info, Vec2(254, 127)).value();
    EXPECT_EQ(known->traits().size_mm, Vec2(254, 127));
    auto const declared = make_descriptor_decoder(simple_pen(), Vec2(254, 127)).value();
    EXPECT_EQ(declared->traits().size_mm, Vec2(200, 100));
}

TEST(DescriptorDecoder, BelievesTheKernelsSizeAfterTheTables)
{
    auto info = pen_with_bits(0x256c, 0x006d, kTipBarrelEraserInvertRange);
    info.size_mm = Vec2(203, 127);
    auto const kernels = make_descriptor_decoder(info).value();
    EXPECT_FALSE(kernels->traits().is_size_assumed);
    EXPECT_EQ(kernels->traits().size_mm, Vec2(203, 127));
    auto const tables = make_descriptor_decoder(info, Vec2(254, 127)).value();
    EXPECT_EQ(tables->traits().size_mm, Vec2(254, 127));
    auto declared = simple_pen();
    declared.size_mm = Vec2(203, 127);
    EXPECT_EQ(make_descriptor_decoder(declared).value()->traits().size_mm, Vec2(200, 100));
}

TEST(DescriptorDecoder, AMousesSilenceEndsThePresenceThatItCannotEnd)
{
    // The device has pen reports in addition to mouse reports, and pen reports can report leaving.
    auto info = simple_pen();
    auto const mouse = bytes(
        "05 01 09 02 a1 01 85 09 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
        "95 05 81 01 05 01 09 30 09 31 65 00 35 00 45 00 26 ff 7f 95 02 75 10 81 02"
        "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0");
    info.report_descriptor.insert(info.report_descriptor.end(), mouse.begin(), mouse.end());
    Device device(info);
    device.sample("02 20 10 27 c4 09 00 00 00 00");
    EXPECT_FALSE(device.decoder().silence_limit());
    device.sample("09 00 10 27 c4 09 00 00");
    EXPECT_EQ(device.decoder().silence_limit(), 100ms);
}

} // namespace
} // namespace tractus::drivers
