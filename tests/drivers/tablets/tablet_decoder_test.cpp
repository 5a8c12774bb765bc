#include "drivers/tablets/tablet_decoder.h"

#include "drivers/logs/log.h"
#include "drivers/tablets/pen_decoders.h"
#include "drivers/usb/string_descriptor.h"
#include "tests/corpus.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/decode_one.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

// Returns the vendor-defined interface of a Huion HS610, with USB string 201, by which the model is
// recognised.
DeviceInfo hs610()
{
    return {
        .name = "HUION Huion Tablet",
        .vendor_id = 0x256c,
        .product_id = 0x006d,
        .report_descriptor = bytes("06 00 ff 09 01 a1 01 85 08 75 58 95 01 09 01 81 02 c0"),
        .strings = { { 201, "HUION_T194_180726" } },
    };
}

// Descriptor of a Huion tablet in its power-up mode: a mouse, report 9, and a pen, report 7. Both
// have ranges of 40000 x 25000 on 10 x 6.25 inches.
std::vector<std::byte> huion_v1_descriptor()
{
    return bytes("05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 15 00 25 01 75 01 95 03"
                 "81 02 95 03 81 03 09 32 95 01 81 02 81 03 05 01 09 30 75 10 95 01 a4 55 0d 65 13"
                 "35 00 46 10 27 27 40 9c 00 00 81 02 09 31 46 6a 18 26 a8 61 81 02 b4 05 0d 09 30"
                 "26 ff 07 81 02 c0 c0");
}

DeviceInfo h690()
{
    return { .name = "Tablet",
             .vendor_id = 0x256c,
             .product_id = 0x006e,
             .report_descriptor = huion_v1_descriptor(),
             .strings = { { 6, "HuionH690" } } };
}

std::optional<PenSample> decode(PenDecoder& decoder, std::string_view report)
{
    auto const sample = decode_one(decoder, Timestamp(), bytes(report));
    EXPECT_TRUE(sample) << sample.error().message;
    return sample ? *sample : std::nullopt;
}

TEST(TabletDecoder, AssumesTheSizeOfAWacomThatItDoesNotKnow)
{
    auto decoder = make_pen_decoder(
        { .name = "Tablet",
          .vendor_id = 0x056a,
          .product_id = 0xeeee,
          .report_descriptor = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 09 09 01 81 02 c0") });
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_TRUE((*decoder)->traits().is_size_assumed);
    auto const pen = decode(**decoder, "02 e0 13 88 04 e2 e2 2b 64 00");
    ASSERT_TRUE(pen);
    EXPECT_EQ(pen->raw_x, 10'000);
    EXPECT_TRUE(pen->touching);
}

// Report 0x1e of a Cintiq Pro 22 or 27, on Wacom's own page: switches in byte 2, of which bit 5 is
// Invert and bit 6 In Range; axes of 24 bits; tilts of 16 bits at 11 and 13.
TEST(TabletDecoder, ReadsACintiqPro27)
{
    auto decoder = make_pen_decoder(
        { .name = "Wacom Cintiq Pro 27",
          .vendor_id = 0x056a,
          .product_id = 0x03c0,
          .report_descriptor = bytes("06 0d ff 09 02 a1 01 85 1e 09 20 75 08 95 0e 81 02 c0") });
    ASSERT_TRUE(decoder) << decoder.error().message;
    auto const pen = decode(**decoder, "1e 01 43 10 27 00 c4 09 00 ff 1f 1e 00 e2 ff");
    ASSERT_TRUE(pen);
    EXPECT_EQ(pen->raw_x, 10'000);
    EXPECT_EQ(pen->raw_y, 2500);
    EXPECT_EQ(pen->pressure, 1.0);
    EXPECT_TRUE(pen->touching);
    EXPECT_FALSE(pen->eraser);
    EXPECT_EQ(pen->buttons, 1u);
    EXPECT_NEAR(pen->tilt_rad.value().x(), radians(30.0), 1e-12);
    // The report has -30 degrees towards the user.
    EXPECT_NEAR(pen->tilt_rad.value().y(), radians(30.0), 1e-12);
    EXPECT_FALSE(decode(**decoder, "1e 01 00 00 00 00 00 00 00 00 00 00 00 00 00")->in_range);
    EXPECT_TRUE(decode(**decoder, "1e 01 60 10 27 00 c4 09 00 00 00 00 00 00 00")->eraser);
}

// Returns a pen whose axes both range to 32767; `x_size` and `y_size` are the descriptor items with
// their physical ranges.
DeviceInfo square_pen(std::uint16_t vendor_id, std::uint16_t product_id, std::string const& x_size,
                      std::string const& y_size)
{
    return { .name = "Tablet",
             .vendor_id = vendor_id,
             .product_id = product_id,
             .report_descriptor
             = bytes("05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 15 00 25 01 75 01 95 "
                     "03 81 02 95 02 81 03 09 32 95 01 81 02 95 02 81 03 75 10 95 01 35 00 a4 05 "
                     "01 09 30 "
                     + x_size + " 26 ff 7f 81 02 09 31 " + y_size
                     + " 26 ff 7f 81 02 b4 09 30 26 ff 1f 81 02 09 3d 15 81 25 7f 75 08 81 02 09 "
                       "3e 81 02 c0 c0") };
}

TEST(TabletDecoder, PutsTheSidesRightThatADescriptorChangesOver)
{
    // A Deco Pro M, whose descriptor says 6.181 inches along X and 10.984 along Y; the table has
    // 279 x 157 mm.
    auto decoder = make_pen_decoder(square_pen(0x28bd, 0x0904, "65 13 55 0d 46 25 18", "46 e8 2a"));
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_EQ((*decoder)->traits().size_mm, Vec2(278.99, 156.995));
    auto const pen = decode(**decoder, "07 21 ff 7f ff 3f ff 0f 00 00");
    ASSERT_TRUE(pen);
    EXPECT_NEAR(pen->position_mm.x(), 278.99, 0.01);
    EXPECT_NEAR(pen->position_mm.y(), 78.5, 0.01);
}

TEST(TabletDecoder, TakesNoTabletForSquare)
{
    auto const size_of = [](DeviceInfo const& info) {
        auto const decoder = make_pen_decoder(info);
        EXPECT_TRUE(decoder && (*decoder)->traits().is_size_assumed);
        return decoder ? (*decoder)->traits().size_mm : Vec2(0, 0);
    };
    // An unknown tablet is assumed to have sides of 16 to 10.
    auto const unknown = size_of(square_pen(0x1234, 0x5678, "", ""));
    EXPECT_NEAR(unknown.x() / unknown.y(), 1.6, 1e-9);
}

TEST(TabletDecoder, ReadsAMakersOwnFormatByTheTable)
{
    auto decoder = make_pen_decoder(hs610());
    ASSERT_TRUE(decoder) << decoder.error().message;
    auto const& traits = (*decoder)->traits();
    EXPECT_EQ(traits.size_mm, Vec2(254, 158.75));
    EXPECT_FALSE(traits.is_size_assumed);
    EXPECT_EQ(traits.raw_pressure_maximum, 8191);
    EXPECT_TRUE(traits.has_tilt);
    EXPECT_EQ(traits.button_count, 2u);

    // The report is of a pen in the middle of the surface, at half pressure.
    auto const sample = decode(**decoder, "08 81 38 63 03 3e 00 10 00 00 00 00");
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->position_mm.x(), 127, 0.01);
    EXPECT_NEAR(sample->position_mm.y(), 79.375, 0.01);
    EXPECT_NEAR(sample->pressure.value(), 0.5, 0.001);
    EXPECT_TRUE(sample->touching);
}

TEST(TabletDecoder, LetsASilentPenLeave)
{
    auto decoder = make_pen_decoder(hs610());
    ASSERT_TRUE(decoder);
    EXPECT_FALSE((*decoder)->silence_limit());
    ASSERT_TRUE(decode(**decoder, "08 81 38 63 03 3e 00 10 00 00 00 00"));
    EXPECT_FALSE((*decoder)->silence_limit()) << "it may report changes only";
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(decode(**decoder, "08 81 38 63 03 3e 00 10 00 00 00 00"));
    EXPECT_EQ((*decoder)->silence_limit(), Duration(std::chrono::milliseconds(100)));
    auto const left = (*decoder)->leave(Timestamp());
    ASSERT_TRUE(left);
    EXPECT_FALSE(left->touching);
}

TEST(TabletDecoder, BelievesTheTabletBeforeTheTable)
{
    auto info = hs610();
    // String 200 says 40000 x 25000 counts, 2047 levels, 4000 counts per inch.
    info.strings[200]
        = string_descriptor_text(bytes("40 9c 00 a8 61 00 ff 07 a0 0f 00 00 00 00 00 00"));
    auto const decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    auto const& traits = (*decoder)->traits();
    EXPECT_EQ(traits.raw_x_maximum, 40000);
    EXPECT_EQ(traits.raw_pressure_maximum, 2047);
    EXPECT_NEAR(traits.size_mm.x(), 254, 1e-9);
}

TEST(TabletDecoder, AssumesTheSizeOfATabletThatItCannotTellFromOthers)
{
    auto info = hs610();
    info.strings.clear();
    auto const decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    EXPECT_TRUE((*decoder)->traits().is_size_assumed);
    // The size is not assumed if the tablet describes it itself.
    info.strings[200]
        = string_descriptor_text(bytes("70 c6 00 06 7c 00 ff 1f d8 13 00 00 00 00 00 00"));
    auto const sure = make_pen_decoder(info);
    ASSERT_TRUE(sure);
    EXPECT_FALSE((*sure)->traits().is_size_assumed);
}

TEST(TabletDecoder, AssumesASizeThatTheTableDoubts)
{
    DeviceInfo const info { .vendor_id = 0x28bd, .product_id = 0x0803 }; // An XP-Pen Deco 02.
    auto const decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    EXPECT_TRUE((*decoder)->traits().is_size_assumed);
}

TEST(TabletDecoder, BelievesADescriptorThatLinuxHasRewritten)
{
    auto info = hs610();
    // Descriptor by hid-uclogic: report 8 is a pen with a bit "in range", 0 to 32000 on 160 mm, and
    // report 0xF7 is keys.
    info.report_descriptor = bytes(
        "05 0d 09 02 a1 01 85 08 09 20 a1 00 15 00 25 01 75 01 09 42 09 44 09 5a 95 03 81 02"
        "95 03 81 03 09 32 95 01 81 02 95 01 81 03 05 01 65 11 55 0f 35 00 75 18 95 01"
        "46 a0 00 27 00 7d 00 00 09 30 81 02 46 64 00 27 20 4e 00 00 09 31 81 02"
        "05 0d 75 10 26 ff 1f 09 30 81 02 75 08 81 03 c0 c0"
        "05 01 09 07 a1 01 85 f7 05 09 19 01 29 10 15 00 25 01 75 01 95 10 81 02 c0");
    info.strings[200]
        = string_descriptor_text(bytes("70 c6 00 06 7c 00 ff 1f d8 13 00 00 00 00 00 00"));
    auto decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_NEAR((*decoder)->traits().size_mm.x(), 160, 0.01);
    auto const sample = decode(**decoder, "08 41 00 7d 00 20 4e 00 ff 1f 00");
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->position_mm.x(), 160, 0.01);
}

TEST(TabletDecoder, ReadsWhatTheDescriptorDescribesUntilTheTabletIsSwitched)
{
    auto decoder = make_pen_decoder(h690());
    ASSERT_TRUE(decoder);
    auto const sample = decode(**decoder, "07 41 10 27 10 27 00 00");
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->in_range);
    auto const left = decode(**decoder, "07 00 10 27 10 27 00 00");
    ASSERT_TRUE(left);
    EXPECT_FALSE(left->in_range);
}

TEST(TabletDecoder, ReadsTheFamilysReportsOnceStringsHaveSwitchedTheTablet)
{
    auto info = h690();
    info.strings[100] = string_descriptor_text(bytes("a0 8c e4 57 00 00 ff 07 a0 0f"));
    info.strings[123] = "HK On";
    auto decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    EXPECT_EQ((*decoder)->traits().raw_x_maximum, 36000);
    // In the family's format, the bit that the descriptor calls "in range" is inverted.
    auto const sample = decode(**decoder, "07 81 10 27 10 27 ff 03");
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->in_range);
    EXPECT_NEAR(sample->position_mm.x(), 10000 / 36000.0 * 228.6, 0.01);
    auto const left = decode(**decoder, "07 c0 10 27 10 27 00 00");
    ASSERT_TRUE(left);
    EXPECT_FALSE(left->in_range);
}

TEST(TabletDecoder, LetsThePenLeaveBeforeItGoesOnInTheOtherFormat)
{
    // Report 0x0a is a described pen of 0 to 32767, report 8 is in the maker's own format.
    auto info = hs610();
    auto const described = bytes(
        "05 0d 09 02 a1 01 85 0a 09 20 a1 00 09 42 09 44 09 45 09 3c 15 00 25 01 75 01 95 06"
        "81 02 09 32 75 01 95 01 81 02 81 03 05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02"
        "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0");
    info.report_descriptor.insert(info.report_descriptor.end(), described.begin(), described.end());
    auto decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    // The size is the table's, since the descriptor has none.
    EXPECT_EQ((*decoder)->traits().size_mm, Vec2(254, 158.75));
    EXPECT_FALSE((*decoder)->traits().is_size_assumed);

    ASSERT_TRUE(decode(**decoder, "0a 41 ff 3f ff 3f ff 0f")->touching);
    auto const left = decode(**decoder, "08 81 38 63 03 3e 00 10 00 00 00 00");
    ASSERT_TRUE(left);
    EXPECT_FALSE(left->in_range);
    auto const goes_on = decode(**decoder, "08 81 38 63 03 3e 00 10 00 00 00 00");
    ASSERT_TRUE(goes_on);
    EXPECT_TRUE(goes_on->touching);
    EXPECT_NEAR(goes_on->position_mm.x(), 127, 0.01);
}

TEST(TabletDecoder, ReadsReportsWithoutIds)
{
    // A VEIKK A30 of the second version, assumed to use no report ids.
    DeviceInfo const info {
        .vendor_id = 0x2feb,
        .product_id = 0x0002,
        .report_descriptor
        = bytes("06 00 ff 09 01 a1 01 09 01 15 00 26 ff 00 75 08 95 0c 81 02 c0"),
    };
    auto decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder) << decoder.error().message;
    auto const sample = decode(**decoder, "41 a1 70 c6 00 10 77 00 ff 1f 00 00");
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->raw_x, 50800);
    EXPECT_EQ(sample->raw_pressure, 8191);
}

TEST(TabletDecoder, IsNotForTheKeysOfATablet)
{
    auto info = hs610();
    info.report_descriptor
        = bytes("05 01 09 06 a1 01 85 03 05 07 19 e0 29 e7 15 00 25 01 75 01 95 08 81 02 c0");
    auto const decoder = make_pen_decoder(info);
    ASSERT_FALSE(decoder);
    EXPECT_EQ(decoder.error().fault, Fault::User);
}

TEST(TabletDecoder, KnowsATabletOverBluetooth)
{
    DeviceInfo const info { .bus = 5, .vendor_id = 0x056a, .product_id = 0x0360 };
    auto const decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_EQ((*decoder)->traits().size_mm, Vec2(224, 148));
    EXPECT_EQ((*decoder)->traits().raw_pressure_maximum, 8191);
}

// A recording of a real tablet, and what the tablet's maker publishes.

struct Recorded {
    char const* file;
    Vec2 size_mm = Vec2::Zero(); // Published size of the active area.
    // Published maxima, if the owner drew around the edges and pressed fully; otherwise 0.
    std::int32_t x_reached = 0;
    std::int32_t y_reached = 0;
    std::int32_t pressure_reached = 0;
};

class RecordedTablet : public testing::TestWithParam<Recorded> { };

TEST_P(RecordedTablet, ReachesItsPublishedMaxima)
{
    REQUIRE_CORPUS();
    auto const& expected = GetParam();
    auto const log = read_log(corpus() / "recordings" / expected.file);
    ASSERT_TRUE(log) << log.error().message;
    auto decoder = make_pen_decoder(log->devices.front());
    ASSERT_TRUE(decoder) << decoder.error().message;
    auto const& traits = (*decoder)->traits();
    EXPECT_NEAR(traits.size_mm.x(), expected.size_mm.x(), 0.02 * expected.size_mm.x());
    EXPECT_NEAR(traits.size_mm.y(), expected.size_mm.y(), 0.02 * expected.size_mm.y());

    PenSample last;
    Eigen::Array3i reached = Eigen::Array3i::Zero();
    for (auto const& record : log->records) {
        auto const sample = decode_one(**decoder, record.time, log->report(record));
        ASSERT_TRUE(sample) << sample.error().message;
        if (!*sample)
            continue;
        last = **sample;
        reached = reached.max(Eigen::Array3i(last.raw_x, last.raw_y, last.raw_pressure));
        EXPECT_TRUE(last.in_range || !last.touching);
    }
    if ((*decoder)->silence_limit())
        last = (*decoder)->leave(last.time).value();
    EXPECT_FALSE(last.touching);
    EXPECT_LE(reached.x(), traits.raw_x_maximum);
    EXPECT_LE(reached.y(), traits.raw_y_maximum);
    EXPECT_LE(reached.z(), traits.raw_pressure_maximum);
    EXPECT_GE(reached.x(), expected.x_reached);
    EXPECT_GE(reached.y(), expected.y_reached);
    EXPECT_GE(reached.z(), expected.pressure_reached);
}

Recorded const kRecorded[] {
    { "uclogic/Huion_HS610__dumps__enabled__pen_coords__if0.hidrec",
      { 254, 158.75 },
      50800,
      31750 },
    { "uclogic/Huion_HS610__dumps__enabled__pen_pressure__if0.hidrec",
      { 254, 158.75 },
      0,
      0,
      8191 },
    { "uclogic/Huion_HS610__dumps__enabled__pen_tilt__if0.hidrec", { 254, 158.75 }, 0, 0, 8191 },
    { "uclogic/Huion_HS610__dumps__enabled__pen_buttons__if0.hidrec", { 254, 158.75 } },
    { "uclogic/Huion_HS610__dumps__default__pen_coords__if1.hidrec",
      { 254, 158.75 },
      32767,
      32767,
      8191 },
    { "uclogic/Huion_New_1060_Plus__dumps__pen_coords__if0.hidrec",
      { 254, 158.75 },
      50800,
      31750,
      8191 },
    { "uclogic/Huion_New_1060_Plus__dumps__pen_pressure__if0.hidrec", { 254, 158.75 }, 0, 0, 8191 },
    { "uclogic/Huion_New_1060_Plus__dumps__pen_buttons__if0.hidrec", { 254, 158.75 } },
    { "uclogic/XP-Pen_Deco_01__dumps__pen_coords__if1.hidrec", { 254, 158.75 }, 25400, 15875 },
    { "uclogic/XP-Pen_Deco_01__dumps__pen_pressure__if1.hidrec", { 254, 158.75 }, 0, 0, 8191 },
    { "uclogic/Ugee_M708_v2__dumps__pen_coords__if1.hidrec", { 254, 152.4 }, 50700, 30400, 8191 },
    { "uclogic/VEIKK_A30__dumps__pen_coords__if0.hidrec", { 254, 152.4 }, 32700, 32767 },
    { "uclogic/VEIKK_A30__dumps__pen_pressure__if0.hidrec", { 254, 152.4 }, 0, 0, 8191 },
    { "uclogic/XP-Pen_Artist_16_Pro__dumps__pen_coords__if1.hidrec",
      { 344.16, 193.59 },
      34000,
      19000 },
    { "wacom/Wacom_Bamboo_Pen_056a_00D4.hid", { 147.2, 92 }, 14720, 9200, 1000 },
    { "wacom/Wacom_BambooFun_4x5_056a_0017.hid", { 147.6, 92.25 } },
    { "wacom/Wacom_Bamboo_056a_0065.hid", { 147.6, 92.25 }, 0, 0, 511 },
    { "wacom/Wacom_Graphire3_056a_0013.hid", { 127.6, 92.8 } },
    { "wacom/Wacom_Intuos3_6x8_056a_00B1.hid", { 203.2, 152.4 } },
    { "wacom/Wacom_Intuos4_4x6_056a_00B8.hid", { 157.48, 98.425 } },
    { "wacom/Wacom_Intuos_Pro_S_056a_0314.hid", { 157.48, 98.425 } },
};

INSTANTIATE_TEST_SUITE_P(Corpus, RecordedTablet, testing::ValuesIn(kRecorded));

} // namespace
} // namespace tractus::drivers
