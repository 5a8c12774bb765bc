#include "drivers/reports/report_descriptor.h"

#include "engine/base/vectors.h"
#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::drivers {
namespace {

Result<HidReportDescriptor> parse(std::string const& text)
{
    auto const descriptor = bytes(text);
    return parse_report_descriptor(descriptor);
}

HidField only_field(std::string const& text)
{
    auto const descriptor = parse(text);
    EXPECT_TRUE(descriptor) << descriptor.error().message;
    if (!descriptor || descriptor->fields.size() != 1) {
        ADD_FAILURE() << "expected one field";
        return {};
    }
    return descriptor->fields.front();
}

TEST(ReportDescriptor, ReadsTheMouseOfTheStandard)
{
    // The example of HID 1.11, appendix E.10.
    auto const mouse
        = parse("05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
                "95 01 75 05 81 01 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 81 06 c0 c0");
    ASSERT_TRUE(mouse) << mouse.error().message;
    ASSERT_EQ(mouse->fields.size(), 5u);
    EXPECT_EQ(mouse->fields[0].usage, 0x0009'0001u);
    EXPECT_EQ(mouse->fields[2].usage, 0x0009'0003u);
    EXPECT_EQ(mouse->fields[2].bit_offset, 2u);
    auto const& y = mouse->fields[4];
    EXPECT_EQ(y.usage, 0x0001'0031u);
    EXPECT_EQ(y.bit_offset, 16u); // Offset after three buttons, five bits of padding, and X.
    EXPECT_EQ(y.bit_size, 8u);
    EXPECT_TRUE(y.is_relative);
    EXPECT_EQ(y.logical_minimum, -127);
    EXPECT_EQ(mouse->report_size(HidReportKind::Input, 0), 3u);
}

TEST(ReportDescriptor, TellsTheCollectionsThatAFieldLiesIn)
{
    auto const pen
        = parse("05 0d 09 02 a1 01 09 20 a1 00 09 42 15 00 25 01 75 01 95 01 81 02 c0 c0");
    ASSERT_TRUE(pen);
    ASSERT_EQ(pen->fields.size(), 1u);
    auto const& stylus = pen->collections.at(pen->fields[0].collection.value());
    EXPECT_EQ(stylus.usage, 0x000D'0020u);
    EXPECT_EQ(stylus.type, 0);
    EXPECT_EQ(pen->collections.at(stylus.parent.value()).usage, 0x000D'0002u);
}

TEST(ReportDescriptor, CountsTheIdByteAndEachReportAlone)
{
    auto const two
        = parse("05 0d 85 01 09 30 75 08 95 01 81 02 85 02 09 30 09 30 95 02 81 02 b1 02");
    ASSERT_TRUE(two);
    EXPECT_EQ(two->fields[0].bit_offset, 8u);
    EXPECT_EQ(two->fields[1].report_id, 2);
    EXPECT_EQ(two->fields[1].bit_offset, 8u);
    EXPECT_EQ(two->fields[2].bit_offset, 16u);
    EXPECT_EQ(two->report_size(HidReportKind::Input, 1), 2u);
    EXPECT_EQ(two->report_size(HidReportKind::Input, 2), 3u);
    EXPECT_EQ(two->report_size(HidReportKind::Feature, 2), 3u);
    EXPECT_EQ(two->report_size(HidReportKind::Output, 2), 0u);
}

TEST(ReportDescriptor, RepeatsTheLastUsage)
{
    auto const flags = parse("05 0d 09 42 09 3c 15 00 25 01 75 01 95 04 81 02");
    ASSERT_TRUE(flags);
    ASSERT_EQ(flags->fields.size(), 4u);
    EXPECT_EQ(flags->fields[0].usage, 0x000D'0042u);
    EXPECT_EQ(flags->fields[3].usage, 0x000D'003Cu);
}

TEST(ReportDescriptor, TakesThePageFromAFourByteUsage)
{
    EXPECT_EQ(only_field("05 01 0b 5d 00 0d ff 75 01 95 01 81 02").usage, 0xFF0D'005Du);
}

TEST(ReportDescriptor, LetsAUsageStandBeforeItsPage)
{
    EXPECT_EQ(only_field("05 01 09 30 05 0d 75 08 95 01 81 02").usage, 0x000D'0030u);
    auto const both = parse("05 01 09 30 05 0d 09 30 75 08 95 02 81 02");
    ASSERT_TRUE(both);
    EXPECT_EQ(both->fields[0].usage, 0x0001'0030u);
    EXPECT_EQ(both->fields[1].usage, 0x000D'0030u);
}

TEST(ReportDescriptor, ReadsAMaximumThatFitsOnlyUnsigned)
{
    auto const pressure = only_field("05 0d 09 30 15 00 25 ff 75 08 95 01 81 02");
    EXPECT_EQ(pressure.logical_maximum, 255);
    EXPECT_EQ(read_field(pressure, bytes("ff")), 255);
}

TEST(ReportDescriptor, ReadsNegativeRanges)
{
    auto const tilt = only_field("05 0d 09 3d 16 d8 dc 26 28 23 75 10 95 01 81 02");
    EXPECT_EQ(tilt.logical_minimum, -9000);
    EXPECT_EQ(tilt.logical_maximum, 9000);
    EXPECT_EQ(read_field(tilt, bytes("d8 dc")), -9000);
}

TEST(ReportDescriptor, RestoresWhatWasPushed)
{
    auto const two = parse("05 0d 75 08 95 01 a4 75 10 55 0e 65 11 09 30 81 02 b4 09 30 81 02");
    ASSERT_TRUE(two);
    EXPECT_EQ(two->fields[0].bit_size, 16u);
    EXPECT_EQ(two->fields[0].unit, 0x11u);
    EXPECT_EQ(two->fields[1].bit_size, 8u);
    EXPECT_EQ(two->fields[1].unit, 0u);
}

TEST(ReportDescriptor, StepsOverLongItems)
{
    EXPECT_EQ(only_field("fe 03 f0 75 75 75 05 0d 09 30 75 08 95 01 81 02").bit_size, 8u);
}

TEST(ReportDescriptor, KeepsAnArraysUsagesAsARange)
{
    auto const descriptor = parse("05 07 19 00 29 65 15 00 25 65 75 08 95 06 81 00");
    ASSERT_TRUE(descriptor);
    ASSERT_EQ(descriptor->fields.size(), 6u);
    EXPECT_TRUE(descriptor->fields[5].is_array);
    EXPECT_EQ(descriptor->fields[5].usage, 0x0007'0000u);
    EXPECT_EQ(descriptor->fields[5].usage_maximum, 0x0007'0065u);
}

TEST(ReportDescriptor, MeasuresInMillimetres)
{
    // Counts 0 to 32000 mean 0 to 6299 thousandths of an inch. The byte of the unit exponent is FD,
    // although the standard requires the nibble D.
    auto const inches = only_field(
        "05 01 09 30 15 00 27 00 7d 00 00 35 00 46 9b 18 65 13 55 fd 75 18 95 01 81 02");
    EXPECT_EQ(inches.unit_exponent, -3);
    EXPECT_NEAR(physical_span_mm(inches).value(), 6.299 * 25.4, 1e-9);

    auto const centimetres
        = only_field("05 01 09 30 15 00 26 80 25 35 00 46 03 0a 65 11 55 0e 75 10 95 01 81 02");
    EXPECT_NEAR(physical_span_mm(centimetres).value(), 256.3, 1e-9);
}

TEST(ReportDescriptor, KnowsNoLengthWithoutAUnitOfLength)
{
    auto const cubic_inches
        = only_field("05 01 09 30 15 00 26 ff 7f 46 00 08 65 33 55 0d 75 10 95 01 81 02");
    EXPECT_FALSE(physical_span_mm(cubic_inches));
    auto const nothing = only_field("05 01 09 30 15 00 26 ff 7f 75 10 95 01 81 02");
    EXPECT_FALSE(physical_span_mm(nothing));
}

TEST(ReportDescriptor, MeasuresAngles)
{
    // The unit is a hundredth of a degree.
    auto const tilt = only_field(
        "05 0d 09 3d 16 d8 dc 26 28 23 36 d8 dc 46 28 23 65 14 55 0e 75 10 95 01 81 02");
    EXPECT_NEAR(radians_per_count(tilt).value(), radians(0.01), 1e-12);
}

TEST(ReportDescriptor, ReadsFieldsThatCrossBytes)
{
    // Fields of 4, 12 and 32 bits; the last one begins in the middle of a byte.
    auto const odd = parse("05 0d 15 00 25 0f 75 04 95 01 09 30 81 02 75 0c 26 ff 0f 09 30 81 02"
                           "75 04 81 01 75 20 09 30 27 ff ff ff ff 81 02");
    ASSERT_TRUE(odd);
    auto const report = bytes("5a ab 8f 67 45 23 f1");
    EXPECT_EQ(read_field(odd->fields[0], report), 0xa);
    EXPECT_EQ(read_field(odd->fields[1], report), 0xab5);
    EXPECT_EQ(read_field(odd->fields[2], report), 0x1234'5678);
}

struct Hostile {
    char const* what;
    char const* bytes;
    char const* message;
};

class HostileDescriptor : public testing::TestWithParam<Hostile> { };

TEST_P(HostileDescriptor, IsRefusedWithAReason)
{
    auto const descriptor = parse(GetParam().bytes);
    ASSERT_FALSE(descriptor);
    EXPECT_EQ(descriptor.error().fault, Fault::Device);
    EXPECT_EQ(descriptor.error().message, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    , HostileDescriptor,
    testing::Values(
        Hostile { "Empty", "", "the report descriptor is empty" },
        Hostile { "CutOffItem", "05 0d 27 ff ff",
                  "report descriptor, byte 2: it ends inside the item 27" },
        Hostile { "CutOffLongItem", "fe 05 f0 00",
                  "report descriptor, byte 0: it ends inside a long item" },
        Hostile { "OpenCollection", "05 0d 09 02 a1 01",
                  "report descriptor, byte 6: it ends inside a collection" },
        Hostile { "EndWithoutBegin", "05 0d c0",
                  "report descriptor, byte 2: the end of a collection that was not begun" },
        Hostile { "PopWithoutPush", "b4", "report descriptor, byte 0: pop without push" },
        Hostile { "ReportIdZero", "85 00",
                  "report descriptor, byte 0: report id 0 is not in 1 to 255" },
        Hostile { "HugeField", "77 ff ff ff ff 95 01 81 02",
                  "report descriptor, byte 7: a field of 4294967295 bits, more than 256" },
        Hostile { "HugeCount", "75 01 97 ff ff ff ff 81 02",
                  "report descriptor, byte 7: report 0 grows beyond 16384 bytes" }),
    [](auto const& test) { return std::string(test.param.what); });

TEST(ReportDescriptor, MayNotPushForEver)
{
    std::vector<std::byte> const pushes(1000, std::byte { 0xA4 });
    auto const descriptor = parse_report_descriptor(pushes);
    ASSERT_FALSE(descriptor);
    EXPECT_EQ(descriptor.error().message, "report descriptor, byte 64: more than 64 pushes");
}

TEST(ReportDescriptor, MayNestDeeply)
{
    auto deep = std::vector<std::byte>();
    for (int i = 0; i < 10'000; ++i)
        deep.insert(deep.end(), { std::byte { 0xA1 }, std::byte { 0 } });
    deep.insert(deep.end(), 10'000, std::byte { 0xC0 });
    auto const descriptor = parse_report_descriptor(deep);
    ASSERT_TRUE(descriptor);
    EXPECT_EQ(descriptor->collections.size(), 10'000u);
}

TEST(ReportDescriptor, MayNotDescribeMillionsOfFields)
{
    auto many = bytes("75 01 96 ff 7f");
    for (int id = 1; id < 200; ++id) {
        auto const report = bytes("85 00 81 02");
        many.insert(many.end(), report.begin(), report.end());
        many[many.size() - 3] = static_cast<std::byte>(id);
    }
    auto const descriptor = parse_report_descriptor(many);
    ASSERT_FALSE(descriptor);
    EXPECT_EQ(descriptor.error().message, "report descriptor, byte 15: more than 65536 fields");
}

} // namespace
} // namespace tractus::drivers
