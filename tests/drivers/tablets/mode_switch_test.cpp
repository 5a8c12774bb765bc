#include "drivers/tablets/mode_switch.h"

#include "drivers/tablets/hidraw_port.h"
#include "drivers/tablets/pen_decoders.h"
#include "drivers/usb/string_descriptor.h"
#include "tests/drivers/bytes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>

namespace tractus::drivers {
namespace {

std::string hex(std::span<std::byte const> bytes)
{
    std::string text;
    for (auto const byte : bytes)
        fmt::format_to(std::back_inserter(text), "{}{:02x}", text.empty() ? "" : " ",
                       std::to_integer<int>(byte));
    return text;
}

// A fake tablet with the given strings, which records the requests that it receives.
class FakePort final : public TabletPort {
public:
    std::map<int, std::string> strings;
    std::string refused_report; // Report that the tablet refuses, such as "output 02 08".
    bool has_usb = true;
    std::vector<std::string> told;

    Result<void> send_feature(std::span<std::byte const> report) override
    {
        return take("feature " + hex(report));
    }
    Result<void> send_output(std::span<std::byte const> report) override
    {
        return take("output " + hex(report));
    }
    Result<std::string> read_string(int index) override
    {
        if (!has_usb)
            return fail(Fault::User, "cannot open the USB plain_device at 1-2");
        told.push_back(fmt::format("string {}", index));
        auto const found = strings.find(index);
        return found == strings.end() ? std::string() : found->second;
    }

private:
    Result<void> take(std::string report)
    {
        if (report == refused_report)
            return fail(Fault::Device, "it does not take report 2");
        told.push_back(std::move(report));
        return {};
    }
};

using PrintedState = std::vector<std::string>;

DeviceInfo plain_device(std::uint16_t vendor_id, std::uint16_t product_id)
{
    return { .name = "Tablet", .vendor_id = vendor_id, .product_id = product_id };
}

std::string const kHs610Parameters
    = string_descriptor_text(bytes("70 c6 00 06 7c 00 ff 1f d8 13 00 00 00 00 00 00"));

TEST(ModeSwitch, SendsAWacomItsFeatureReport)
{
    FakePort port;
    auto info = plain_device(0x056a, 0x037a);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told, PrintedState { "feature 02 02" });
    EXPECT_TRUE(info.warnings.empty());
}

TEST(ModeSwitch, SendsSeveralReportsInTheirOrder)
{
    FakePort port;
    auto intuos3 = plain_device(0x056a, 0x00b1);
    switch_to_full_mode(intuos3, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told, (PrintedState { "feature 02 02", "feature 04 00" }));

    port.told.clear();
    auto veikk = plain_device(0x2feb, 0x0008);
    switch_to_full_mode(veikk, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told,
              (PrintedState { "output 09 01 04", "output 09 02 02", "output 09 03 02" }));
}

TEST(ModeSwitch, LeavesToTheKernelWhatItsDriverDoes)
{
    FakePort port;
    auto info = plain_device(0x056a, 0x037a);
    switch_to_full_mode(info, port, SwitchedBy::Kernel);
    EXPECT_TRUE(port.told.empty());

    port.has_usb = false;
    for (std::uint16_t const product_id : { std::uint16_t { 0x0067 }, std::uint16_t { 0x006d } }) {
        auto huion = plain_device(0x256c, product_id);
        switch_to_full_mode(huion, port, SwitchedBy::Kernel);
        EXPECT_TRUE(huion.warnings.empty()) << huion.warnings.front();
    }
}

TEST(ModeSwitch, ReadsTheStringsOfAHuion)
{
    FakePort port;
    port.strings = { { 200, kHs610Parameters }, { 201, "HUION_T194_180726" } };
    auto info = plain_device(0x256c, 0x006d);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told, (PrintedState { "string 2", "string 201", "string 200" }));
    EXPECT_EQ(info.strings.at(201), "HUION_T194_180726");
    EXPECT_EQ(info.strings.at(2), ""); // The tablet lacks this string.

    info.report_descriptor = bytes("06 00 ff 09 01 a1 01 85 08 75 58 95 01 09 01 81 02 c0");
    auto const decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    EXPECT_NEAR((*decoder)->traits().size_mm.x(), 254, 1e-9);
    EXPECT_EQ((*decoder)->traits().raw_x_maximum, 50800);
}

TEST(ModeSwitch, ReadsTheStringsOfATabletThatTheKernelHasSwitched)
{
    FakePort port;
    port.strings = { { 200, kHs610Parameters }, { 201, "HUION_T194_180726" } };
    auto info = plain_device(0x256c, 0x006d);
    switch_to_full_mode(info, port, SwitchedBy::Kernel);
    EXPECT_EQ(port.told, (PrintedState { "string 2", "string 201", "string 200" }));
}

TEST(ModeSwitch, SwitchesANewModelLikeItsKin)
{
    FakePort port;
    port.strings = { { 200, kHs610Parameters }, { 201, "HUION_X999_300101" } };
    auto info = plain_device(0x256c, 0x006d);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told.back(), "string 200");
    EXPECT_EQ(info.strings.at(200), kHs610Parameters);
}

TEST(ModeSwitch, ReadsAStringOnlyOnce)
{
    FakePort port;
    port.strings = { { 201, "F610_M61P-T1234" } };
    auto info = plain_device(0x5543, 0x0081);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told,
              (PrintedState { "string 4", "string 5", "string 6", "string 201", "string 100" }));
    port.told.clear();
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_TRUE(port.told.empty());
}

TEST(ModeSwitch, AsksNothingOfADeviceThatIsNotInTheTable)
{
    FakePort port;
    auto info = plain_device(0x04d8, 0x00dd); // An MCP2221A, which is not a tablet.
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_TRUE(port.told.empty());
    EXPECT_TRUE(info.warnings.empty());
}

TEST(ModeSwitch, WarnsOfARefusedReportAndSendsNoMore)
{
    FakePort port;
    port.refused_report = "output 09 02 02";
    auto info = plain_device(0x2feb, 0x0008);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_EQ(port.told, PrintedState { "output 09 01 04" });
    EXPECT_EQ(info.warnings,
              PrintedState {
                  "cannot switch VEIKK VK1060 to its full mode, so it stays in the one it is in: "
                  "it does not take report 2" });
}

TEST(ModeSwitch, WarnsWhereStringsCannotBeRead)
{
    FakePort port;
    port.has_usb = false;
    auto info = plain_device(0x256c, 0x0067);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    EXPECT_EQ(info.warnings,
              PrintedState {
                  "cannot switch Huion H951P to its full mode, so it stays in the one it is in: "
                  "cannot open the USB plain_device at 1-2" });
    EXPECT_TRUE(info.strings.empty());
}

TEST(ModeSwitch, WarnsWhereItCannotTellTabletsApart)
{
    FakePort port;
    port.has_usb = false;
    auto info = plain_device(0x256c, 0x006d);
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    ASSERT_EQ(info.warnings.size(), 1u);
    auto const& warning = info.warnings[0];
    EXPECT_TRUE(warning.starts_with("cannot tell which tablet Tablet is, and takes it for "))
        << warning;
    EXPECT_TRUE(warning.ends_with("others with its ids): cannot open the USB plain_device at 1-2"))
        << warning;
}

// Helper for tests of find_receiver(): returns an interface with the given report descriptor.

DeviceInfo interface_with(std::string_view descriptor)
{
    return { .report_descriptor = bytes(descriptor) };
}

constexpr auto kPenDescriptor = "05 0d 09 02 a1 01 85 07 09 30 15 00 26 ff 7f 75 10 95 01 81 02 c0";
constexpr auto kVendor
    = "06 00 ff 09 01 a1 01 85 02 09 01 15 00 26 ff 00 75 08 95 0b 81 02 09 01 95 09 91 02 c0";
constexpr auto kFeature = "05 0d 09 02 a1 01 85 02 09 3a 15 00 26 ff 00 75 08 95 01 b1 02 c0";

TEST(Receiver, IsTheInterfaceThatHasTheReport)
{
    std::vector const interfaces { interface_with(kPenDescriptor), interface_with(kVendor),
                                   interface_with(kFeature) };
    EXPECT_EQ(find_receiver(interfaces, 0, HostReportKind::Output, 2), 1u);
    EXPECT_EQ(find_receiver(interfaces, 0, HostReportKind::Feature, 2), 2u);
}

TEST(Receiver, IsTheOpenInterfaceIfItHasTheReportOrNoneHas)
{
    std::vector const interfaces { interface_with(kVendor), interface_with(kVendor),
                                   interface_with("") };
    EXPECT_EQ(find_receiver(interfaces, 1, HostReportKind::Output, 2), 1u);
    EXPECT_EQ(find_receiver(interfaces, 2, HostReportKind::Output, 9), 2u);
}

TEST(HidrawPort, SaysWhyItsNodeDoesNotTakeAReport)
{
    HidrawPort port({ .name = "Tablet", .location = "/dev/hidraw-nowhere" }, {}, "/nowhere");
    auto const sent = port.send_feature(bytes("02 02"));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().message,
              "cannot open Tablet at /dev/hidraw-nowhere: there is no such device (was it "
              "unplugged?)");
}

} // namespace
} // namespace tractus::drivers
