#include "drivers/gpio/gpio_adc.h"

#include "drivers/device_list.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/gpio/simulated_converter.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>
#include <utility>

namespace tractus::drivers {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

// Forwards to lines that the test owns. A source owns the lines that it is given, but the test
// needs them, too.
class BorrowedLines final : public GpioLines {
public:
    explicit BorrowedLines(GpioLines& lines)
        : lines_(lines)
    {
    }

    Result<void> set(std::uint32_t values) override { return lines_.set(values); }
    Result<std::uint32_t> get() override { return lines_.get(); }

private:
    GpioLines& lines_;
};

constexpr char kAddress[] = "gpio:gpiochip0:11,10,9,8:mcp3208:5";

Result<std::unique_ptr<ReportSource>> open(SimulatedConverter& converter,
                                           std::string const& address = kAddress)
{
    return open_gpio_adc(
        { .location = address }, std::make_unique<BorrowedLines>(converter.lines),
        { .now = [&] { return converter.lines.now(); },
          .sleep_until = [&](Timestamp time) { converter.lines.sleep_until(time); } });
}

// Returns the number of the k-th request in the n-th conversion. The first three conversions are
// made when the converter is opened.
constexpr std::uint64_t request(std::uint64_t conversion, std::uint64_t k)
{
    return conversion * 51 + k;
}

// Returns the next reading, which must exist.
HeightSample read(ReportSource& source)
{
    auto const report = source.read(seconds(1));
    EXPECT_TRUE(report && *report);
    std::vector<HeightSample> samples;
    auto const decoder = make_height_decoder(source.info());
    EXPECT_TRUE(decoder) << decoder.error().message;
    EXPECT_TRUE((*decoder)->decode(**report, samples));
    EXPECT_EQ(samples.size(), 1U);
    return samples.at(0);
}

TEST(GpioAdc, ReadsTheChannelOfItsAddress)
{
    SimulatedConverter converter;
    converter.inputs[5] = 1234.5 / 4096;
    auto const source = open(converter);
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ((*source)->info().name, "MCP3208 channel 5 on gpiochip0");
    EXPECT_EQ((*source)->info().bus, 0x1c);
    auto const sample = read(**source);
    EXPECT_EQ(sample.counts, 1234);
    EXPECT_EQ(sample.full_scale, 4095);
}

TEST(GpioAdc, ReadsTheSmallerConverter)
{
    SimulatedConverter converter({ .bits = 10 });
    converter.inputs[0] = 1;
    auto const source = open(converter, "gpio:gpiochip0:11,10,9,8:mcp3008:0");
    ASSERT_TRUE(source);
    auto const sample = read(**source);
    EXPECT_EQ(sample.counts, 1023);
    EXPECT_EQ(sample.full_scale, 1023);
}

TEST(GpioAdc, ReadsFiveHundredTimesASecond)
{
    SimulatedConverter converter;
    auto const source = open(converter);
    ASSERT_TRUE(source);
    auto const first = read(**source).time;
    for (int i = 1; i <= 500; ++i) {
        auto const late = read(**source).time - first - i * milliseconds(2);
        ASSERT_EQ(late, Duration(0)) << i;
    }
}

TEST(GpioAdc, ReadsAsOftenAsSlowLinesAllow)
{
    SimulatedConverter converter({}, { .request_time = microseconds(100) });
    auto const source = open(converter);
    ASSERT_TRUE(source);
    auto const first = read(**source).time;
    EXPECT_EQ(read(**source).time - first, 51 * microseconds(100));
}

TEST(GpioAdc, WaitsNoLongerThanItIsTold)
{
    SimulatedConverter converter;
    auto const source = open(converter);
    ASSERT_TRUE(source);
    read(**source);
    auto const before = converter.lines.now();
    auto const report = (*source)->read(microseconds(500));
    ASSERT_TRUE(report);
    EXPECT_FALSE(*report);
    EXPECT_EQ(converter.lines.now() - before, microseconds(500));
}

TEST(GpioAdc, RepeatsWhatTheSchedulerInterrupted)
{
    // Two conversions in a row are interrupted while the bits of the reading are sent.
    SimulatedConverter converter({},
                                 { .pauses = { { request(3, 30), milliseconds(30) },
                                               { request(4, 40), milliseconds(3) } } });
    converter.inputs[5] = 3000.5 / 4096;
    auto const source = open(converter);
    ASSERT_TRUE(source);
    auto const report = (*source)->read(seconds(1));
    ASSERT_TRUE(report && *report);
    EXPECT_EQ(std::vector<std::byte>((*report)->bytes().begin(), (*report)->bytes().end()),
              bytes("00 02 b8 0b"));
    EXPECT_EQ(read(**source).counts, 3000);
}

TEST(GpioAdc, NeverGivesAReadingThatAnInterruptionSpoiled)
{
    // The reading is interrupted once, before each of its requests in turn.
    for (std::uint64_t at = 0; at < 51; ++at) {
        SimulatedConverter converter({}, { .pauses = { { request(3, at), milliseconds(30) } } });
        converter.inputs[5] = 3000.5 / 4096;
        auto const source = open(converter);
        ASSERT_TRUE(source);
        ASSERT_EQ(read(**source).counts, 3000) << at;
    }
}

TEST(GpioAdc, UsesSlowLinesAndSaysSo)
{
    SimulatedConverter converter({ .droop_per_second = 0 }, { .request_time = microseconds(150) });
    converter.inputs[5] = 0.25;
    auto const source = open(converter);
    ASSERT_TRUE(source) << source.error().message;
    auto const report = (*source)->read(seconds(1));
    ASSERT_TRUE(report && *report);
    EXPECT_EQ(std::vector<std::byte>((*report)->bytes().begin(), (*report)->bytes().end()),
              bytes("02 00 00 04"));
}

TEST(GpioAdc, RefusesToOpenWhereNothingAnswers)
{
    SimulatedConverter converter({}, { .dout_pull = true });
    converter.model.break_wire(sim::Mcp3208Model::Wire::Dout);
    auto const source = open(converter);
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::Device);
    EXPECT_EQ(source.error().message,
              "nothing answers at gpio:gpiochip0:11,10,9,8:mcp3208:5: DOUT is high where the "
              "converter sends a zero (check the order of the lines, CS, and its supply)");
}

TEST(GpioAdc, TellsInItsReportsThatAWireBroke)
{
    SimulatedConverter converter({}, { .dout_pull = true });
    auto const source = open(converter);
    ASSERT_TRUE(source);
    converter.model.break_wire(sim::Mcp3208Model::Wire::Cs);
    auto const report = (*source)->read(seconds(1));
    ASSERT_TRUE(report && *report);
    std::vector<HeightSample> samples;
    auto const decoded = (*make_height_decoder((*source)->info()))->decode(**report, samples);
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.error().message,
              "MCP3208: nothing answers on DOUT (check its wires and its supply)");
    converter.model.mend_wire(sim::Mcp3208Model::Wire::Cs);
    EXPECT_EQ(read(**source).counts, 0);
}

TEST(GpioAdc, FailsWhenTheChipIsUnplugged)
{
    SimulatedConverter converter({}, { .gone_at = request(4, 20) });
    auto const source = open(converter);
    ASSERT_TRUE(source);
    read(**source);
    auto const report = (*source)->read(seconds(1));
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::Device);
}

TEST(GpioAdc, RefusesAddressesOfWhatCannotBe)
{
    auto const why = [](char const* address) {
        return open_gpio_adc({ .location = address }).error().message;
    };
    EXPECT_EQ(why("gpio:gpiochip0:11,10,9,8:ads1115:0"),
              "gpio:gpiochip0:11,10,9,8:ads1115:0: there is no converter 'ads1115': mcp3008 and "
              "mcp3208 can be read");
    EXPECT_EQ(why("gpio:gpiochip0:11,10,9,8:mcp3208:8"),
              "gpio:gpiochip0:11,10,9,8:mcp3208:8: the MCP3208 has the channels 0 to 7");
    EXPECT_EQ(why("/dev/hidraw0"), "/dev/hidraw0 is not the address of a converter on GPIO lines");
}

TEST(GpioAdc, TellsWhenTheSurfaceWasWhere)
{
    // The surface sways while the scheduler interrupts every tenth conversion.
    auto const level = [](Timestamp time) { return 0.5 + 0.4 * std::sin(9 * to_seconds(time)); };
    sim::SimulatedGpio::Options options { .request_time = microseconds(4) };
    for (std::uint64_t i = 10; i < 2000; i += 10)
        options.pauses[request(i, i * 7 % 51)] = milliseconds(1 + i % 9);
    sim::Mcp3208Model model([&](unsigned, Timestamp time) { return level(time); }, {});
    sim::SimulatedGpio lines(model, options);
    auto const source
        = open_gpio_adc({ .location = kAddress }, std::make_unique<BorrowedLines>(lines),
                        { .now = [&] { return lines.now(); },
                          .sleep_until = [&](Timestamp time) { lines.sleep_until(time); } });
    ASSERT_TRUE(source);
    for (int i = 0; i < 1000; ++i) {
        auto const sample = read(**source);
        // A pause too short to cause a repetition lets the capacitor droop by at most one count.
        ASSERT_NEAR(sample.counts, std::floor(4096 * level(sample.time)), 2) << i;
    }
}

TEST(GpioAdc, IsKnownByItsAddressAlone)
{
    auto const info = find_device("gpio:gpiochip0:11,10,9,8:mcp3008:3");
    ASSERT_TRUE(info) << info.error().message;
    EXPECT_EQ(info->name, "MCP3008 channel 3 on gpiochip0");
    EXPECT_EQ((*make_height_decoder(*info))->full_scale(), 1023);
    EXPECT_FALSE(find_device("gpio:gpiochip0:11,10,9,8:mcp3008:9"));
}

TEST(GpioAdc, SaysThatItsChipIsNotThere)
{
    auto const source = open_device({ .location = "gpio:no such chip:11,10,9,8:mcp3208:0" });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
}

DeviceInfo const kRecorded { .name = "MCP3208 channel 0 on gpiochip0", .bus = 0x1c };

TEST(GpioAdcDecoder, IsChosenForARecordedDevice)
{
    auto const decoder = make_height_decoder(kRecorded);
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_EQ((*decoder)->full_scale(), 4095);
}

TEST(GpioAdcDecoder, DecodesALogAsItDidTheLiveDevice)
{
    SimulatedConverter converter;
    converter.inputs[5] = 1234.5 / 4096;
    auto const source = open(converter).value();
    std::ostringstream text;
    LogWriter writer(text, { .devices = { source->info() } });
    auto const live = source->read(seconds(1)).value().value();
    writer.write_report(0, live.received, live.bytes());

    auto const log = parse_log(text.str(), "gpio").value();
    auto const decoder = make_height_decoder(log.devices.at(0));
    ASSERT_TRUE(decoder) << decoder.error().message;
    std::vector<HeightSample> samples;
    ASSERT_TRUE((*decoder)->decode(log.records.at(0).time, log.report(log.records[0]), samples));
    EXPECT_EQ(samples.at(0).counts, 1234);
    EXPECT_EQ(samples.at(0).full_scale, 4095);
}

TEST(GpioAdcDecoder, IsNotChosenForAHidDeviceOfThatName)
{
    auto info = kRecorded;
    info.bus = 3;
    EXPECT_FALSE(make_height_decoder(info));
}

TEST(GpioAdcDecoder, BlamesTheDeviceForBrokenReports)
{
    auto const decoder = make_height_decoder(kRecorded).value();
    std::vector<HeightSample> samples;
    EXPECT_EQ(decoder->decode({}, bytes("00 00 01"), samples).error().message,
              "MCP3208 report: 3 bytes, expected 4");
    EXPECT_EQ(decoder->decode({}, bytes("00 00 00 10"), samples).error().message,
              "MCP3208 report: 4096 counts, expected 0 to 4095");
    EXPECT_TRUE(samples.empty());
}

} // namespace
} // namespace tractus::drivers
