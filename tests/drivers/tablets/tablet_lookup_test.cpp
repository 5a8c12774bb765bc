#include "drivers/tablets/tablet_lookup.h"

#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

DeviceInfo device(std::uint16_t vendor_id, std::uint16_t product_id,
                  std::map<int, std::string> strings = {})
{
    return { .name = "Tablet",
             .vendor_id = vendor_id,
             .product_id = product_id,
             .strings = std::move(strings) };
}

// Returns the descriptor of a Huion tablet's vendor-defined interface: report 8, with 12 bytes
// whose meaning is not described.
std::vector<std::byte> huion_descriptor()
{
    return bytes("06 00 ff 09 01 a1 01 85 08 75 58 95 01 09 01 81 02 c0");
}

std::string found_name(DeviceInfo const& info)
{
    auto const match = find_tablet(info);
    return match ? tablet_name(*match) : "none";
}

TEST(TabletLookup, FindsATabletWithIdsOfItsOwn)
{
    auto const match = find_tablet(device(0x056a, 0x037a));
    ASSERT_TRUE(match);
    EXPECT_EQ(match->tablet->name, "Wacom CTL-472");
    EXPECT_EQ(match->alternatives, 0u);
}

TEST(TabletLookup, KnowsTheFormatOfEachWacom)
{
    struct {
        std::uint16_t product_id;
        std::string_view family;
        Vec2 size_mm;
    } const expected[] = {
        { 0x03c0, "wacom-intuos-v3", { 600.16, 339.34 } }, // A Cintiq Pro 27.
        { 0x03d0, "wacom-intuos-v3", { 480.06, 271.78 } }, // A Cintiq Pro 22.
        { 0x00f4, "wacom-intuos-pro", { 522.4, 328 } },    // A Cintiq 24HD.
        { 0x0057, "wacom-intuos-pro", { 478.2, 270.3 } },  // A DTK-2241.
        { 0x00fb, "wacom-dtus", { 220.96, 139.6 } },       // A DTU-1031.
        { 0x0081, "wacom-graphire-bluetooth", { 208.8, 150.8 } },
    };
    for (auto const& [product_id, family, size_mm] : expected) {
        auto const match = find_tablet(device(0x056a, product_id));
        ASSERT_TRUE(match) << product_id;
        EXPECT_EQ(match->identifier->family, family) << product_id;
        EXPECT_EQ(match->tablet->size_mm, size_mm) << product_id;
        EXPECT_EQ(match->alternatives, 0u) << product_id;
    }
}

TEST(TabletLookup, ReadsAWacomThatItDoesNotKnowAsAnIntuosIfItsReportsAreAsLong)
{
    auto info = device(0x056a, 0xeeee);
    EXPECT_FALSE(find_tablet(info));
    // Report 2 with nine bytes after its id.
    info.report_descriptor = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 09 09 01 81 02 c0");
    EXPECT_EQ(found_name(info), "Wacom (model not known, read as an Intuos)");
    info.product_id = 0x037a; // A CTL-472 is an Intuos, regardless of the length of its reports.
    EXPECT_EQ(found_name(info), "Wacom CTL-472");
    info.product_id = 0xeeee;
    info.report_descriptor = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 08 09 01 81 02 c0");
    EXPECT_EQ(found_name(info), "none");
}

TEST(TabletLookup, TellsTheProportionsThatAllModelsShare)
{
    constexpr auto kSmallAndLarge = "A small one | 101.6 x 76.2 | 20320 x 15240 | 8191 | 2 | 0\n"
                                    "    1234:0001 10 generic\n"
                                    "A large one | 203.2 x 152.4 | 40640 x 30480 | 8191 | 2 | 0\n"
                                    "    1234:0001 10 generic\n"
                                    "    1234:0002 10 generic\n"
                                    "A wide one | 254 x 142.9 | 50800 x 28580 | 8191 | 2 | 0\n"
                                    "    1234:0002 10 generic\n";
    auto const tablets = parse_tablets(kSmallAndLarge).value();
    auto const alike = find_tablet(tablets, device(0x1234, 0x0001));
    ASSERT_TRUE(alike && alike->width_to_height);
    EXPECT_NEAR(*alike->width_to_height, 4.0 / 3, 1e-9);
    auto const others = find_tablet(tablets, device(0x1234, 0x0002));
    ASSERT_TRUE(others);
    EXPECT_FALSE(others->width_to_height);
}

TEST(TabletLookup, KnowsNotEveryDevice)
{
    EXPECT_FALSE(find_tablet(device(0x1234, 0x5678)));
}

TEST(TabletLookup, TellsTabletsThatShareIdsApartByString201)
{
    EXPECT_EQ(found_name(device(0x256c, 0x006d, { { 201, "HUION_T194_180726" } })), "Huion HS610");
    EXPECT_EQ(found_name(device(0x256c, 0x006d, { { 201, "HUION_T173_180101" } })), "Huion H640P");
    EXPECT_EQ(found_name(device(0x256c, 0x006d, { { 201, "OEM02_T18e_190101" } })), "Gaomon S620");
    EXPECT_EQ(found_name(device(0x256c, 0x0064, { { 201, "HUION_T227_210101" } })), "Huion HS610");
}

TEST(TabletLookup, TakesANewModelForOneOfItsKin)
{
    auto const match
        = find_tablet(device(0x256c, 0x006d, { { 201, "HUION_X999_180726" }, { 2, "" } }));
    ASSERT_TRUE(match);
    EXPECT_GT(match->alternatives, 0u);
    // The name must be qualified even if only one model has such ids, because the string matches no
    // model.
    auto const only = find_tablet(device(0x256c, 0x0067, { { 201, "HUION_X999_180726" } }));
    ASSERT_TRUE(only);
    EXPECT_EQ(tablet_name(*only), "Huion H951P (or another one with its ids)");
}

// The interfaces are those of a Wacom CTH-480: its pen has reports of 10 bytes, its touch surface
// has reports of 64.
TEST(TabletLookup, TellsATabletsPadFromItsPen)
{
    auto info = device(0x056a, 0x0302);
    info.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 3f 15 00 26 ff 00 09 01 81 02 c0");
    auto const pad = find_tablet(info);
    ASSERT_TRUE(pad);
    EXPECT_EQ(pad->identifier->family, kPadFamily);
    info.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 09 15 00 26 ff 00 09 01 81 02 c0");
    auto const pen = find_tablet(info);
    ASSERT_TRUE(pen);
    EXPECT_EQ(pen->identifier->family, "wacom-intuos");
}

// The pad and the pen of an XP-Pen Artist 13.3 differ only in their output reports.
TEST(TabletLookup, TellsATabletsPadFromItsPenByOutputReports)
{
    auto info = device(0x28bd, 0x000b);
    info.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 07 15 00 26 ff 00 09 01 81 02 c0");
    auto const pad = find_tablet(info);
    ASSERT_TRUE(pad);
    EXPECT_EQ(pad->identifier->family, kPadFamily);
    info.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 07 15 00 26 ff 00 09 01 81 02 09 01 91 02 c0");
    auto const pen = find_tablet(info);
    ASSERT_TRUE(pen);
    EXPECT_EQ(pen->identifier->family, "xp-pen");
}

TEST(TabletLookup, NeedsAllOfSeveralStrings)
{
    EXPECT_EQ(
        found_name(device(0x5543, 0x0081,
                          { { 4, "F401-20111028" }, { 5, "UC-LOIC" }, { 6, "TABLET 1060" } })),
        "UGEE M708");
    EXPECT_EQ(found_name(
                  device(0x28bd, 0x0905, { { 4, "UG901_BPU1002" }, { 5, "2020-10-23_Release3" } })),
              "XP-Pen Deco 01 V2 (Variant 2)");
    EXPECT_EQ(found_name(
                  device(0x28bd, 0x0905, { { 4, "UG901_BPU1002" }, { 5, "2019-01-01_Release1" } })),
              "XP-Pen Deco 01 V2");
}

TEST(TabletLookup, ReadsStringsWithZeros)
{
    using namespace std::string_literals;
    EXPECT_EQ(found_name(device(0x256c, 0x006e,
                                { { 6,
                                    "\0"
                                    "420\0\0"s } })),
              "Huion 420");
    EXPECT_EQ(found_name(device(0x256c, 0x006e, { { 6, "10594\0\0et\0"s } })), "Monoprice 10594");
}

// A log may give a tablet a text of any length. A search in it must not exhaust the stack.
TEST(TabletLookup, TakesATextThatIsTooLongForUsbForNoneThatItKnows)
{
    auto const with_text = [](std::string const& text) {
        return found_name(device(0x256c, 0x006e, { { 6, text } }));
    };
    std::string const name = "420";
    EXPECT_EQ(with_text(std::string(100, '\0') + name), with_text(name));
    auto const with_zeros = with_text(std::string(250'000, '\0') + name);
    EXPECT_EQ(with_zeros, with_text("unknown"));
    EXPECT_NE(with_zeros, with_text(name));
}

TEST(TabletLookup, SaysHowManyOthersWouldFit)
{
    auto info = device(0x256c, 0x006d);
    info.report_descriptor = huion_descriptor();
    auto const match = find_tablet(info);
    ASSERT_TRUE(match);
    EXPECT_GT(match->alternatives, 20u);
    EXPECT_NE(tablet_name(*match).find("others with its ids"), std::string::npos);
    // All candidates have the same resolution.
    EXPECT_NEAR(match->tablet->x_maximum / match->tablet->size_mm.x(), 200, 0.1);
}

TEST(TabletLookup, BelievesTheTabletsOwnName)
{
    auto info = device(0x256c, 0x006d);
    info.name = "HUION Huion Tablet_H640P Pen";
    EXPECT_EQ(found_name(info), "Huion H640P");
    info.name = "HUION H610 Pro V2";
    // The device's name must not be taken for that of the H610 Pro.
    EXPECT_EQ(found_name(info), "Huion H610 Pro V2");
}

TEST(TabletLookup, TellsFirmwareApartByTheLengthOfReports)
{
    auto info = device(0x2feb, 0x0002);
    // The device sends reports of 12 bytes without an id. The missing id counts as one more byte.
    info.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 75 08 95 0c 15 00 26 ff 00 09 01 81 02 c0");
    EXPECT_EQ(found_name(info), "VEIKK A30 V2");
    info.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 75 08 95 08 15 00 26 ff 00 09 01 81 02 c0");
    EXPECT_EQ(found_name(info), "VEIKK A30");
}

TEST(TabletLookup, TellsVariantsApartByTheLengthOfOutputReports)
{
    auto info = device(0x28bd, 0x0947);
    auto const descriptor = [](std::string_view output_count) {
        auto result = bytes("06 00 ff 09 01 a1 01 85 02 75 08 95 0b 15 00 26 ff 00 09 01 81 02 95");
        for (auto const byte : bytes(output_count))
            result.push_back(byte);
        for (auto const byte : bytes("09 01 91 02 c0"))
            result.push_back(byte);
        return result;
    };
    info.report_descriptor = descriptor("0d");
    EXPECT_EQ(found_name(info), "XP-Pen Deco 01 V3 (Variant 2)");
    info.report_descriptor = descriptor("09");
    EXPECT_EQ(found_name(info), "XP-Pen Deco 01 V3");
}

TEST(TabletLookup, TellsTabletsApartByTheMaximaThatTheyTell)
{
    // String 200 with X up to 32000, Y up to 20000, pressure up to 8191, 5080 counts per inch: an
    // H640P or a related model.
    using namespace std::string_literals;
    auto info = device(0x256c, 0x006d);
    info.report_descriptor = huion_descriptor();
    info.strings[200] = "\u7d00\u2000\u004e\u1fff\u13d8\u0300\u0800\u0008"s;
    auto const match = find_tablet(info);
    ASSERT_TRUE(match);
    EXPECT_EQ(match->tablet->x_maximum, 32000);
    EXPECT_EQ(match->tablet->y_maximum, 20000);
}

TEST(TabletLookup, NamesTheStringsThatTellTabletsApart)
{
    EXPECT_EQ(identifying_strings(0x256c, 0x006d), (std::vector { 2, 201 }));
    EXPECT_EQ(identifying_strings(0x5543, 0x0081), (std::vector { 4, 5, 6, 201 }));
    EXPECT_TRUE(identifying_strings(0x056a, 0x037a).empty());
}

TEST(TabletLookup, KeepsToItsInterface)
{
    auto const tablets = parse_tablets("Maker One | 100 x 100 | 9000 x 9000 | 8191 | 2 | 0\n"
                                       "    1234:0001 8 generic; interface 1\n");
    ASSERT_TRUE(tablets);
    auto info = device(0x1234, 0x0001);
    // The device's interface number is not known, so it may be this tablet.
    EXPECT_TRUE(find_tablet(*tablets, info));
    info.interface_number = 1;
    EXPECT_TRUE(find_tablet(*tablets, info));
    info.interface_number = 0;
    EXPECT_FALSE(find_tablet(*tablets, info));
}

} // namespace
} // namespace tractus::drivers
