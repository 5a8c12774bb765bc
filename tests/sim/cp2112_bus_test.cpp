#include "sim/cp2112_bus.h"

#include "drivers/reports/report_descriptor.h"
#include "sim/cp2112_model.h"
#include "sim/mcp3421_model.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <initializer_list>
#include <vector>

namespace tractus::sim {
namespace {

std::vector<std::byte> report_of(std::initializer_list<int> values)
{
    std::vector<std::byte> report;
    for (int const value : values)
        report.push_back(static_cast<std::byte>(value));
    return report;
}

std::vector<int> begin_of(std::vector<std::byte> const& report, std::size_t size)
{
    std::vector<int> begin;
    for (std::size_t i = 0; i < std::min(size, report.size()); ++i)
        begin.push_back(std::to_integer<int>(report[i]));
    return begin;
}

// A bus with an MCP3421, driven by the reports that the kernel's hid-cp2112 and mcp3422 send.
class Cp2112BusTest : public testing::Test {
protected:
    // Reads `size` bytes from an address. Returns no bytes if no chip acknowledges the address.
    std::vector<int> read(int address, int size)
    {
        EXPECT_TRUE(bus.output(report_of({ 0x10, address << 1, 0, size })).empty());
        auto const status = begin_of(bus.output(report_of({ 0x15, 1 })), 7);
        if (status[1] != 2)
            return {};
        EXPECT_EQ(status[6], size);
        auto const data = bus.output(report_of({ 0x12, 0, size }));
        EXPECT_EQ(data.size(), 64u);
        EXPECT_EQ(begin_of(data, 3), (std::vector { 0x13, 2, size }));
        auto bytes = begin_of(data, static_cast<std::size_t>(3 + size));
        bytes.erase(bytes.begin(), bytes.begin() + 3);
        return bytes;
    }

    void configure(int value)
    {
        EXPECT_TRUE(bus.output(report_of({ 0x14, 0x68 << 1, 1, value })).empty());
        EXPECT_EQ(begin_of(bus.output(report_of({ 0x15, 1 })), 3), (std::vector { 0x16, 2, 5 }));
    }

    double input = 0.5;
    Mcp3421Model converter { [this] { return input; } };
    Cp2112Bus bus { { .address = Mcp3421Model::kAddress,
                      .write = [this](std::span<std::byte const> bytes) { converter.write(bytes); },
                      .read = [this](std::size_t size) { return converter.read(size); } } };
};

// The expected values are those of the data sheet's tables 4-1 to 4-4.
TEST_F(Cp2112BusTest, ReadsTheConverterAtAllItsResolutions)
{
    configure(0x10);
    input = 1;
    EXPECT_EQ(read(0x68, 3), (std::vector { 0x07, 0xff, 0x10 }));
    input = -1;
    EXPECT_EQ(read(0x68, 3), (std::vector { 0xf8, 0x01, 0x10 }));
    configure(0x18);
    input = 1;
    EXPECT_EQ(read(0x68, 3), (std::vector { 0x7f, 0xff, 0x18 }));
    configure(0x9c);
    EXPECT_EQ(read(0x68, 4), (std::vector { 0x01, 0xff, 0xff, 0x1c }));
    input = -2;
    EXPECT_EQ(read(0x68, 4), (std::vector { 0xfe, 0x00, 0x00, 0x1c }));
}

TEST_F(Cp2112BusTest, TellsThatNothingAcknowledges)
{
    EXPECT_EQ(begin_of(bus.output(report_of({ 0x15, 1 })), 2), (std::vector { 0x16, 0 }));
    EXPECT_TRUE(read(0x69, 3).empty());
    EXPECT_TRUE(bus.output(report_of({ 0x14, 0x20, 1, 0 })).empty());
    EXPECT_EQ(begin_of(bus.output(report_of({ 0x15, 1 })), 3), (std::vector { 0x16, 3, 0 }));
}

TEST_F(Cp2112BusTest, WritesAndReadsInOneTransfer)
{
    input = 1;
    EXPECT_TRUE(bus.output(report_of({ 0x11, 0x68 << 1, 0, 3, 1, 0x18 })).empty());
    EXPECT_EQ(begin_of(bus.output(report_of({ 0x12, 0, 3 })), 6),
              (std::vector { 0x13, 2, 3, 0x7f, 0xff, 0x18 }));
}

TEST_F(Cp2112BusTest, StandsWhatNoHostSends)
{
    for (int id = 0; id < 256; ++id)
        for (std::size_t size = 0; size < 8; ++size) {
            auto report = report_of({ id, 0xd0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff });
            report.resize(size);
            EXPECT_LE(bus.output(report).size(), 64u);
        }
}

TEST_F(Cp2112BusTest, DescribesItsReports)
{
    auto const descriptor = drivers::parse_report_descriptor(Cp2112Model::info().report_descriptor);
    ASSERT_TRUE(descriptor) << descriptor.error().message;
    for (auto const id : std::initializer_list<std::uint8_t> { 0x13, 0x16 })
        EXPECT_EQ(descriptor->report_size(drivers::HidReportKind::Input, id), 64u);
    for (auto const id : std::initializer_list<std::uint8_t> { 0x10, 0x11, 0x12, 0x14, 0x15, 0x17 })
        EXPECT_EQ(descriptor->report_size(drivers::HidReportKind::Output, id), 64u);
}

} // namespace
} // namespace tractus::sim
