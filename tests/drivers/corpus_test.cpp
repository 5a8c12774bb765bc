// Tests with descriptors and recordings of real devices that other people have made.

#include "tests/corpus.h"
#include "tests/drivers/decode_one.h"

#include "drivers/logs/log.h"
#include "drivers/reports/pen_layout.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/file.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

namespace tractus::drivers {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(fs::path const& folder)
{
    std::vector<fs::path> files;
    for (auto const& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// Returns all recordings of raw reports, without recordings of the kernel's input events.
std::vector<fs::path> recordings()
{
    auto files = files_below(corpus() / "recordings");
    std::erase_if(files, [](auto const& path) { return path.extension() == ".ev"; });
    return files;
}

Result<HidReportDescriptor> parse_file(fs::path const& path)
{
    auto const text = read_file(path);
    EXPECT_TRUE(text);
    return parse_report_descriptor(std::as_bytes(std::span(*text)));
}

TEST(Corpus, ParsesEveryDescriptor)
{
    REQUIRE_CORPUS();
    for (auto const& path : files_below(corpus() / "descriptors")) {
        if (path.extension() != ".bin" || fs::file_size(path) == 0)
            continue;
        auto const descriptor = parse_file(path);
        EXPECT_TRUE(descriptor) << path << ": " << descriptor.error().message;
    }
}

TEST(Corpus, FindsAPenInEveryPenDescriptor)
{
    REQUIRE_CORPUS();
    int pens = 0;
    int declared = 0;
    int found = 0;
    for (auto const& path : files_below(corpus() / "descriptors" / "pen")) {
        auto const descriptor = parse_file(path);
        if (!descriptor)
            continue;
        ++pens;
        auto const layouts = find_pen_layouts(*descriptor);
        EXPECT_FALSE(layouts.empty()) << path;
        found += !layouts.empty();
        for (auto const& layout : layouts) {
            EXPECT_GE(layout.size_mm.minCoeff(), 20) << path;
            EXPECT_LE(layout.size_mm.maxCoeff(), 800) << path;
            EXPECT_LE(layout.bytes_needed, layout.report_size) << path;
        }
        declared += std::any_of(layouts.begin(), layouts.end(), [](auto const& layout) {
            return layout.size_source == PenLayout::Size::Declared;
        });
    }
    RecordProperty("descriptors", pens);
    RecordProperty("with_x_y_tip", found);
    RecordProperty("with_a_size", declared);
    EXPECT_GT(pens, 100);
    EXPECT_GT(declared, pens * 9 / 10);
}

// Parses bus, vendor and product from a file name such as
// "sysinfo.X8pBxWhnQo__0003_256C_006D.0008.hid.bin"; older names have only vendor and product.
DeviceInfo device_of(fs::path const& path)
{
    DeviceInfo info { .name = path.filename().string() };
    auto const ids = info.name.substr(info.name.rfind("__") + 2);
    bool const has_bus = ids.find('_', 5) != std::string::npos && ids[9] == '_';
    auto const number = [&](std::size_t at) {
        return static_cast<std::uint16_t>(std::stoul(ids.substr(at, 4), nullptr, 16));
    };
    if (has_bus)
        info.bus = number(0);
    info.vendor_id = number(has_bus ? 5 : 0);
    info.product_id = number(has_bus ? 10 : 5);
    auto const text = read_file(path);
    EXPECT_TRUE(text);
    for (char const byte : *text)
        info.report_descriptor.push_back(static_cast<std::byte>(byte));
    return info;
}

TEST(Corpus, MakesADecoderForEveryPen)
{
    REQUIRE_CORPUS();
    int decoders = 0;
    int assumed = 0;
    for (auto const& path : files_below(corpus() / "descriptors" / "pen")) {
        if (path.extension() != ".bin")
            continue;
        auto const decoder = make_pen_decoder(device_of(path));
        if (!decoder) {
            ADD_FAILURE() << path << ": " << decoder.error().message;
            continue;
        }
        ++decoders;
        auto const& traits = (*decoder)->traits();
        EXPECT_GE(traits.size_mm.minCoeff(), 40) << path;
        EXPECT_LE(traits.size_mm.maxCoeff(), 700) << path;
        EXPECT_GT(traits.raw_x_maximum, 0) << path;
        EXPECT_GT(traits.raw_y_maximum, 0) << path;
        assumed += traits.is_size_assumed;
    }
    RecordProperty("pens", decoders);
    RecordProperty("of_assumed_size", assumed);
    EXPECT_EQ(decoders, 133);
    EXPECT_LE(assumed, 5);
}

TEST(Corpus, FindsNoPenInOtherDescriptors)
{
    REQUIRE_CORPUS();
    for (auto const& path : files_below(corpus() / "descriptors" / "other")) {
        // Three devices in this folder do have a pen: a mouse with tip pressure, a touch screen
        // with a stylus, and a pen on Wacom's own page.
        auto const name = path.filename().string();
        if (name.find("2FEB_0001.0005") != std::string::npos
            || name.find("03EB_8ABB.0006") != std::string::npos
            || name.find("056A_0374.000A") != std::string::npos)
            continue;
        auto const descriptor = parse_file(path);
        if (descriptor) {
            EXPECT_TRUE(find_pen_layouts(*descriptor).empty()) << path;
        }
    }
}

TEST(Corpus, ReadsThePenOnWacomsOwnPage)
{
    REQUIRE_CORPUS();
    // A CTL-4100: 152 x 95 mm, 4095 levels of pressure. Its descriptor describes its reports on
    // Wacom's own page.
    auto const descriptor = parse_file(corpus() / "descriptors" / "other"
                                       / "sysinfo.SnJcZT74MO__0003_056A_0374.000A.hid.bin");
    ASSERT_TRUE(descriptor);
    auto const layouts = find_pen_layouts(*descriptor);
    ASSERT_EQ(layouts.size(), 1u);
    auto const& pen = layouts[0];
    EXPECT_NEAR(pen.size_mm.x(), 152, 0.1);
    EXPECT_NEAR(pen.size_mm.y(), 95, 0.1);
    EXPECT_EQ(pen.x.bit_size, 24u);
    EXPECT_EQ(pen.pressure.value().logical_maximum, 4095);
    EXPECT_TRUE(pen.tip && pen.in_range && pen.tool_serial && pen.tool_type);
}

TEST(Corpus, ReadsEveryRecordingToTheLastReport)
{
    REQUIRE_CORPUS();
    for (auto const& path : recordings()) {
        auto const log = read_log(path);
        ASSERT_TRUE(log) << log.error().message;
        auto const text = read_file(path);
        ASSERT_TRUE(text);
        std::size_t lines = text->starts_with("E:");
        for (auto at = text->find("\nE:"); at != std::string::npos; at = text->find("\nE:", at + 1))
            ++lines;
        EXPECT_EQ(log->records.size() + log->warning_count, lines) << path;
        EXPECT_EQ(log->warning_count, 0u) << summarize_warnings(*log);
    }
}

TEST(Corpus, DecodesRecordingsWithinTheirDevicesMaxima)
{
    REQUIRE_CORPUS();
    int pens = 0;
    for (auto const& path : recordings()) {
        auto const log = read_log(path);
        ASSERT_TRUE(log);
        auto decoder = make_pen_decoder(log->devices.front());
        if (!decoder)
            continue;
        ++pens;
        auto const& traits = (*decoder)->traits();
        bool has_touched = false;
        for (auto const& record : log->records) {
            auto const sample = decode_one(**decoder, record.time, log->report(record));
            ASSERT_TRUE(sample) << path << ": " << sample.error().message;
            if (!*sample)
                continue;
            auto const& pen = **sample;
            ASSERT_TRUE(pen.raw_x >= 0 && pen.raw_x <= traits.raw_x_maximum)
                << path << ' ' << pen.raw_x;
            ASSERT_TRUE(pen.raw_y >= 0 && pen.raw_y <= traits.raw_y_maximum)
                << path << ' ' << pen.raw_y;
            ASSERT_LE(pen.raw_pressure, traits.raw_pressure_maximum) << path;
            ASSERT_TRUE(pen.in_range || !pen.touching) << path;
            has_touched |= pen.touching;
        }
        // Recordings of barrel buttons contain no touches, one recording is of a dial, and one of
        // Wacom's is of a mouse.
        auto const is_of = [&](char const* what) {
            return path.filename().string().find(what) != std::string::npos;
        };
        EXPECT_TRUE(has_touched || is_of("buttons") || is_of("dials") || is_of("Intuos3")) << path;
    }
    RecordProperty("recordings_with_a_pen", pens);
    EXPECT_GE(pens, 20);
}

TEST(Corpus, ReadsTheWholeSurfaceOfAnHs610)
{
    REQUIRE_CORPUS();
    // The owner drew around the edges, so both axes reach both ends, and pressed as strongly as the
    // tablet measures: 8191.
    auto const log = read_log(corpus() / "recordings" / "uclogic"
                              / "Huion_HS610__dumps__default__pen_coords__if1.hidrec");
    ASSERT_TRUE(log);
    auto decoder = make_pen_decoder(log->devices.front());
    ASSERT_TRUE(decoder);
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t pressure = 0;
    for (auto const& record : log->records) {
        auto const sample = decode_one(**decoder, record.time, log->report(record));
        ASSERT_TRUE(sample);
        if (!*sample)
            continue;
        x = std::max(x, (*sample)->raw_x);
        y = std::max(y, (*sample)->raw_y);
        pressure = std::max(pressure, (*sample)->raw_pressure);
    }
    EXPECT_EQ(x, 32767);
    EXPECT_EQ(y, 32767);
    EXPECT_EQ(pressure, 8191);
}

} // namespace
} // namespace tractus::drivers
