// The vendors in drivers/70-tractus.rules must be those in the table of tablets.

#include "drivers/tablets/tablet_table.h"
#include "engine/base/file.h"
#include "tests/corpus.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace tractus::drivers {
namespace {

// Conditions of a udev rule that permits access to a USB device.
struct Rule {
    // True: the rule is for the USB device itself, not for its hidraw nodes.
    bool is_for_usb = false;
    std::string vendors;  // Alternative vendor ids, such as "0458|056a".
    std::string products; // Alternative product ids; empty if the rule applies to all products.
};

std::string match_of(std::string const& line, char const* key)
{
    std::smatch found;
    std::regex const pattern(fmt::format("ATTRS?\\{{{}\\}}==\"([^\"]*)\"", key));
    return std::regex_search(line, found, pattern) ? found[1].str() : std::string();
}

std::vector<Rule> read_rules()
{
    auto const text
        = read_file(std::filesystem::path(TRACTUS_SOURCE_FOLDER) / "drivers" / "70-tractus.rules");
    EXPECT_TRUE(text);
    std::vector<Rule> rules;
    std::istringstream lines(text.value_or(""));
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with('#') && line.find("TAG+=\"uaccess\"") != std::string::npos)
            rules.push_back({ .is_for_usb = line.starts_with("SUBSYSTEM==\"usb\""),
                              .vendors = match_of(line, "idVendor"),
                              .products = match_of(line, "idProduct") });
    return rules;
}

bool names(std::string const& alternatives, std::uint16_t id)
{
    return ("|" + alternatives + "|").find(fmt::format("|{:04x}|", id)) != std::string::npos;
}

bool permits(std::vector<Rule> const& rules, bool as_usb, TabletIdentifier const& identifier)
{
    return std::any_of(rules.begin(), rules.end(), [&](Rule const& rule) {
        return rule.is_for_usb == as_usb && names(rule.vendors, identifier.vendor_id)
            && (rule.products.empty() || names(rule.products, identifier.product_id));
    });
}

TEST(Rules, PermitEveryKnownTablet)
{
    auto const rules = read_rules();
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers) {
            EXPECT_TRUE(permits(rules, false, identifier))
                << "hidraw: " << tablet.name << ' ' << identifier.vendor_id;
            EXPECT_TRUE(permits(rules, true, identifier))
                << "usb: " << tablet.name << ' ' << identifier.vendor_id;
        }
}

// Returns whether the rule's program permits a device with this descriptor.
bool is_permitted_by_usage(std::string const& descriptor_path)
{
    auto const text
        = read_file(std::filesystem::path(TRACTUS_SOURCE_FOLDER) / "drivers" / "70-tractus.rules");
    std::smatch found;
    EXPECT_TRUE(text && std::regex_search(*text, found, std::regex("\nPROGRAM==\"([^\"]*)\"")));
    auto command = found[1].str();
    std::string const place = "/sys%p/device/report_descriptor";
    auto const at = command.find(place);
    EXPECT_NE(at, std::string::npos) << command;
    command.replace(at, place.size(), "'" + descriptor_path + "'");
    return std::system(command.c_str()) == 0;
}

TEST(Rules, PermitEveryPenOfTheCorpusByItsUsage)
{
    REQUIRE_CORPUS();
    int pens = 0;
    for (auto const& entry :
         std::filesystem::directory_iterator(corpus() / "descriptors" / "pen")) {
        EXPECT_TRUE(is_permitted_by_usage(entry.path())) << entry.path();
        ++pens;
    }
    EXPECT_EQ(pens, 133);
}

TEST(Rules, PermitByUsageNoDeviceOfTheCorpusThatIsNoPen)
{
    REQUIRE_CORPUS();
    for (auto const& entry :
         std::filesystem::directory_iterator(corpus() / "descriptors" / "other")) {
        // Wacom's devices in this folder are pens with reports in Wacom's own format.
        bool const is_wacom = entry.path().filename().string().find("_056A_") != std::string::npos;
        EXPECT_TRUE(is_wacom || !is_permitted_by_usage(entry.path())) << entry.path();
    }
}

// The ids of chip makers are used by many devices that are not tablets. Genius makes keyboards,
// whose input must not be readable by everyone.
TEST(Rules, PermitNotAllDevicesOfMakersOfOtherThings)
{
    std::vector<std::uint16_t> const vendor_ids { 0x0458, 0x0483, 0x0a12, 0x04d8, 0x1209 };
    for (auto const& rule : read_rules())
        for (auto const vendor_id : vendor_ids)
            EXPECT_FALSE(names(rule.vendors, vendor_id) && rule.products.empty()) << rule.vendors;
}

} // namespace
} // namespace tractus::drivers
