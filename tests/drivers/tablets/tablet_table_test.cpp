#include "drivers/tablets/tablet_table.h"

#include "drivers/pens/families.h"
#include "tests/drivers/bytes.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <tuple>

namespace tractus::drivers {
namespace {

constexpr std::string_view kTwoTablets
    = "# A comment.\n"
      "\n"
      "Maker One | 254 x 158.75 | 50800 x 31750 | 8191 | 2 | 12\n"
      "    256c:006d 12 uclogic-v2; if 201 ONE_(T1|T2)_\\d{6}$; string 200\n"
      "    28bd:0905 12/10 xp-pen; output 02 b0 04, 02 b0 02; interface 1\n"
      "Maker Two | 100 x 100 | 1000 x 900 | 1023 | 1 | 0 | size in doubt\n"
      "    0458:5010 - genius; feature 05 12; string 100, 123\n";

TEST(TabletTable, ReadsATablet)
{
    auto const tablets = parse_tablets(kTwoTablets);
    ASSERT_TRUE(tablets) << tablets.error().message;
    ASSERT_EQ(tablets->size(), 2u);
    auto const& tablet = tablets->front();
    EXPECT_EQ(tablet.name, "Maker One");
    EXPECT_EQ(tablet.size_mm, Vec2(254, 158.75));
    EXPECT_FALSE(tablet.is_size_in_doubt);
    EXPECT_EQ(tablet.x_maximum, 50800);
    EXPECT_EQ(tablet.y_maximum, 31750);
    EXPECT_EQ(tablet.pressure_maximum, 8191);
    EXPECT_EQ(tablet.pen_buttons, 2u);
    EXPECT_EQ(tablet.pad_keys, 12u);
    EXPECT_TRUE(tablets->back().is_size_in_doubt);
}

TEST(TabletTable, ReadsHowATabletPresentsItself)
{
    auto const tablets = parse_tablets(kTwoTablets);
    ASSERT_TRUE(tablets);
    auto const& one = tablets->front().identifiers;
    ASSERT_EQ(one.size(), 2u);
    EXPECT_EQ(one[0].vendor_id, 0x256c);
    EXPECT_EQ(one[0].product_id, 0x006d);
    EXPECT_EQ(one[0].input_size, 12u);
    EXPECT_FALSE(one[0].output_size);
    EXPECT_EQ(one[0].family, "uclogic-v2");
    ASSERT_EQ(one[0].conditions.size(), 1u);
    EXPECT_EQ(one[0].conditions[0].index, 201);
    EXPECT_EQ(one[0].conditions[0].pattern, "ONE_(T1|T2)_\\d{6}$");
    EXPECT_EQ(one[0].setup.strings, std::vector { 200 });

    EXPECT_EQ(one[1].output_size, 10u);
    EXPECT_EQ(one[1].interface_number, 1);
    auto const expected = std::vector { bytes("02 b0 04"), bytes("02 b0 02") };
    EXPECT_EQ(one[1].setup.output_reports, expected);

    auto const& two = tablets->back().identifiers.at(0);
    EXPECT_FALSE(two.input_size);
    EXPECT_EQ(two.setup.feature_reports, std::vector(1, bytes("05 12")));
    EXPECT_EQ(two.setup.strings, (std::vector { 100, 123 }));
}

TEST(TabletTable, NamesTheLineThatItCannotRead)
{
    for (auto const* const line : {
             "Maker | 254 x | 50800 x 31750 | 8191 | 2 | 12\n",
             "Maker | 254 x 158 | 50800 x 31750 | 8191 | 2\n",
             "Maker | 254 x 158 | 50800 x 31750 | 8191 | 2 | 12 | size in dout\n",
             "    256c:006d 12 uclogic-v2\n",
         }) {
        auto const tablets = parse_tablets(fmt::format("# Above.\n{}", line));
        ASSERT_FALSE(tablets) << line;
        EXPECT_EQ(tablets.error().fault, Fault::Station);
        EXPECT_TRUE(tablets.error().message.starts_with("tablets.txt:2: cannot read"))
            << tablets.error().message;
    }
}

TEST(TabletTable, RefusesIdentifiersThatItDoesNotUnderstand)
{
    for (auto const* const line : {
             "256c 12 uclogic-v2",
             "256c:006d twelve uclogic-v2",
             "256c:006d 12",
             "256c:006d 12 uclogic-v2; strong 200",
             "256c:006d 12 uclogic-v2; string",
             "256c:006d 12 uclogic-v2; if HUION",
             "256c:006d 12 uclogic-v2; output 02 1b0",
             "256c:006d 12 uclogic-v2; feature",
         })
        EXPECT_FALSE(parse_tablets(fmt::format("M | 9 x 9 | 9 x 9 | 9 | 2 | 0\n    {}\n", line)))
            << line;
}

// Tests of the table itself, which must be complete and valid.

TEST(KnownTablets, AreAll)
{
    std::size_t identifiers = 0;
    std::size_t pads = 0;
    std::set<std::string_view> names;
    for (auto const& tablet : known_tablets()) {
        for (auto const& identifier : tablet.identifiers)
            ++(identifier.family == kPadFamily ? pads : identifiers);
        EXPECT_TRUE(names.insert(tablet.name).second) << tablet.name << " is there twice";
        EXPECT_FALSE(tablet.identifiers.empty()) << tablet.name;
    }
    EXPECT_EQ(known_tablets().size(), 327u);
    EXPECT_EQ(identifiers, 502u);
    EXPECT_EQ(pads, 35u);
}

TEST(KnownTablets, NameFamiliesThatExist)
{
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers) {
            if (identifier.family == kPadFamily)
                continue;
            EXPECT_TRUE(find_pen_family(identifier.family))
                << tablet.name << ": " << identifier.family;
        }
}

TEST(KnownTablets, UseEveryFamily)
{
    std::set<std::string_view> used;
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers)
            used.insert(identifier.family);
    for (auto const& family : pen_families())
        EXPECT_TRUE(used.contains(family.name)) << family.name;
}

// Returns the counts per inch along X and Y.
Vec2 resolution(Tablet const& tablet)
{
    return Vec2(tablet.x_maximum, tablet.y_maximum).cwiseQuotient(tablet.size_mm) * 25.4;
}

TEST(KnownTablets, HaveSizesAndMaximaThatAgree)
{
    int in_doubt = 0;
    for (auto const& tablet : known_tablets()) {
        auto const cpi = resolution(tablet);
        bool const is_square = std::abs(cpi.x() / cpi.y() - 1) <= 0.005;
        bool const is_usual = cpi.minCoeff() >= 500 && cpi.maxCoeff() <= 10'500;
        EXPECT_EQ(tablet.is_size_in_doubt, !is_square || !is_usual)
            << tablet.name << ": " << cpi.transpose() << " counts per inch";
        in_doubt += tablet.is_size_in_doubt;
    }
    EXPECT_EQ(in_doubt, 11);
}

TEST(KnownTablets, HavePlausibleFigures)
{
    std::set<std::int32_t> const levels { 255, 511, 1023, 2046, 2047, 4095, 8191, 16383, 32767 };
    for (auto const& tablet : known_tablets()) {
        EXPECT_GE(tablet.size_mm.minCoeff(), 55) << tablet.name;
        EXPECT_LE(tablet.size_mm.maxCoeff(), 650) << tablet.name;
        EXPECT_TRUE(levels.contains(tablet.pressure_maximum)) << tablet.name;
        EXPECT_LE(tablet.pen_buttons, 3u) << tablet.name;
        EXPECT_LE(tablet.pad_keys, 20u) << tablet.name;
        for (auto const& identifier : tablet.identifiers)
            if (identifier.input_size) {
                EXPECT_GE(*identifier.input_size, 5u) << tablet.name;
            }
    }
}

TEST(KnownTablets, HavePatternsThatAreRegularExpressions)
{
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers)
            for (auto const& [index, pattern] : identifier.conditions) {
                EXPECT_NO_THROW(std::regex { pattern }) << tablet.name << ": " << pattern;
                EXPECT_TRUE(index > 0 && index < 256) << tablet.name;
            }
}

TEST(KnownTablets, AreToldApartByAStringOrAReportsLength)
{
    std::map<std::tuple<int, int, std::size_t, std::size_t>, std::string_view> taken;
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers) {
            if (!identifier.conditions.empty())
                continue;
            auto const [at, is_first] = taken.insert(
                { { identifier.vendor_id, identifier.product_id, identifier.input_size.value_or(0),
                    identifier.output_size.value_or(0) },
                  tablet.name });
            EXPECT_TRUE(is_first || at->second == tablet.name)
                << tablet.name << " and " << at->second << " look the same";
        }
}

TEST(KnownTablets, SwitchWithWholeReports)
{
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers) {
            for (auto const* const reports :
                 { &identifier.setup.feature_reports, &identifier.setup.output_reports })
                for (auto const& report : *reports) {
                    EXPECT_GE(report.size(), 2u) << tablet.name;
                    EXPECT_LE(report.size(), 64u) << tablet.name;
                }
            for (int const index : identifier.setup.strings)
                EXPECT_TRUE(index >= 0 && index < 256) << tablet.name;
        }
}

} // namespace
} // namespace tractus::drivers
