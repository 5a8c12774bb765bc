#include "sim/cp2112_model.h"

#include "drivers/reports/report_descriptor.h"
#include "sim/mcp3208_model.h"

#include <gtest/gtest.h>

namespace tractus::sim {

namespace {

std::vector<std::byte> bytes_of(std::initializer_list<int> values)
{
    std::vector<std::byte> result;
    for (int const value : values)
        result.push_back(static_cast<std::byte>(value));
    return result;
}

} // namespace

// Fixture in which lines 0 and 1 are outputs, and line 2 is connected to a switch that is on.
struct Cp2112ModelTest : testing::Test {
    std::uint8_t driven = 0xff;
    Cp2112Model model { { .driven = [this](std::uint8_t levels) { driven = levels; },
                          .levels = [] { return std::uint8_t { 0b100 }; } } };

    void SetUp() override { ASSERT_TRUE(model.set_feature(bytes_of({ 2, 0b011, 0, 0, 0 }))); }
};

TEST_F(Cp2112ModelTest, SetsTheLinesThatTheMaskNames)
{
    ASSERT_TRUE(model.set_feature(bytes_of({ 4, 0xff, 0b001 })));
    EXPECT_EQ(driven, 0b001);
    ASSERT_TRUE(model.set_feature(bytes_of({ 4, 0x00, 0b010 })));
    EXPECT_EQ(driven, 0b001);
    ASSERT_TRUE(model.set_feature(bytes_of({ 4, 0x00, 0b001 })));
    EXPECT_EQ(driven, 0);
}

TEST_F(Cp2112ModelTest, DrivesNoInput)
{
    ASSERT_TRUE(model.set_feature(bytes_of({ 4, 0xff, 0xff })));
    EXPECT_EQ(driven, 0b011);
}

TEST_F(Cp2112ModelTest, ReadsInputsAndWhatOutputsAreSetTo)
{
    ASSERT_TRUE(model.set_feature(bytes_of({ 4, 0xff, 0b010 })));
    EXPECT_EQ(model.get_feature(3), bytes_of({ 3, 0b110 }));
}

TEST_F(Cp2112ModelTest, KeepsItsConfigurationForTheHost)
{
    EXPECT_EQ(model.get_feature(2), bytes_of({ 2, 0b011, 0, 0, 0 }));
}

TEST_F(Cp2112ModelTest, RefusesReportsThatItDoesNotHave)
{
    EXPECT_FALSE(model.get_feature(0x20));
    EXPECT_FALSE(model.set_feature(bytes_of({ 0x20, 0 })));
    EXPECT_FALSE(model.set_feature(bytes_of({ 4, 0xff }))) << "too short";
    EXPECT_FALSE(model.set_feature({}));
}

TEST_F(Cp2112ModelTest, ReadsNoLinesOnABadCable)
{
    model.fail_readings();
    EXPECT_FALSE(model.get_feature(3));
    EXPECT_TRUE(model.get_feature(5)) << "the version is still told";
}

TEST_F(Cp2112ModelTest, DescribesTheReportsThatItHas)
{
    auto const descriptor = drivers::parse_report_descriptor(Cp2112Model::info().report_descriptor);
    ASSERT_TRUE(descriptor) << descriptor.error().message;
    for (auto const id : std::initializer_list<std::uint8_t> { 2, 3, 5, 6 })
        EXPECT_EQ(descriptor->report_size(drivers::HidReportKind::Feature, id),
                  model.get_feature(id).value().size())
            << int(id);
    EXPECT_EQ(descriptor->report_size(drivers::HidReportKind::Feature, 4), 3u);
}

} // namespace tractus::sim
