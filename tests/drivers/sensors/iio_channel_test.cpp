// Tests the driver of industrial I/O with a folder that imitates the kernel's.

#include "drivers/sensors/iio_channel.h"

#include "drivers/device_kind.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "tests/drivers/heights.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class IioChannel : public testing::Test {
protected:
    void SetUp() override
    {
        fs::remove_all(folder_);
        write("iio:device0/name", "accel_3d");
        write("iio:device0/in_accel_x_raw", "17");
        write("iio:device1/name", "ads1015");
        write("iio:device1/in_voltage0_raw", "1024");
        write("iio:device1/in_voltage0-voltage1_raw", "-3");
        write("iio:device1/in_voltage0_scale", "3.0");
        write("iio:device1/scan_elements/in_voltage0_type", "be:s12/16>>4");
        write("iio:device2/name", "vl53l0x");
        write("iio:device2/in_distance_raw", "245");
        write("trigger0/name", "sysfstrig0");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(std::string const& file, std::string const& text) const
    {
        fs::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file) << text << '\n';
    }

    Result<std::unique_ptr<ReportSource>> open(std::string const& address,
                                               std::string settings = "") const
    {
        auto info = TRY(describe_iio_channel(address, folder_));
        info.settings = std::move(settings);
        return open_iio_channel(std::move(info), folder_);
    }

    // Returns the next reading of an open channel.
    static Result<HeightSample> next(ReportSource& source)
    {
        auto const report = TRY(source.read(60s)); // Returns at the next request.
        auto decoder = TRY(make_height_decoder(source.info()));
        return TRY(decode_heights(*decoder, report.value())).at(0);
    }

    fs::path folder_ = fs::temp_directory_path() / ("tractus_iio_" + std::to_string(::getpid()));
};

TEST_F(IioChannel, IsListedWhereItMayBeAHeight)
{
    std::vector<std::string> places;
    for (auto const& info : list_iio_channels(folder_)) {
        places.push_back(info.location);
        EXPECT_EQ(describe_device(info).kind, DeviceKind::Other) << "nobody has named it";
    }
    EXPECT_EQ(places,
              (std::vector<std::string> { "iio:device1:voltage0", "iio:device1:voltage0-voltage1",
                                          "iio:device2:distance" }));
    EXPECT_TRUE(list_iio_channels(folder_ / "none").empty());
}

TEST_F(IioChannel, GivesWhatTheConverterReads)
{
    auto const source = open("iio:ads1015:voltage0").value();
    EXPECT_EQ(source->info().name, "ads1015 voltage0");
    auto const first = next(*source).value();
    EXPECT_EQ(first.counts, 1024);
    EXPECT_EQ(first.full_scale, 2047) << "its type tells 12 bits with a sign";
    write("iio:device1/in_voltage0_raw", "1030");
    EXPECT_EQ(next(*source)->counts, 1030);
    write("iio:device1/in_voltage0_raw", "-2");
    EXPECT_EQ(next(*source)->counts, 0);
}

TEST_F(IioChannel, TakesWhatItsUserSays)
{
    EXPECT_EQ(next(*open("iio:device2:distance", "max=2000,10us").value())->full_scale, 2000);
    EXPECT_EQ(next(*open("iio:device1:voltage0", "max=1500").value())->full_scale, 1500);
    EXPECT_EQ(next(*open("iio:device2:distance").value())->full_scale, 32767);
    for (std::string const settings : { "0us", "max=0", "2ms", "115200", "200000us" })
        EXPECT_FALSE(open("iio:device2:distance", settings)) << settings;
}

TEST_F(IioChannel, SaysWhatIsNotThere)
{
    auto const message = [&](std::string const& address) { return open(address).error().message; };
    EXPECT_NE(message("iio:device7:voltage0").find("no industrial I/O device device7"),
              std::string::npos);
    EXPECT_NE(message("iio:ads1015:voltage9").find("has no channel voltage9"), std::string::npos);
    EXPECT_NE(message("/dev/hidraw0").find("not the address"), std::string::npos);
}

TEST_F(IioChannel, ReplaysFromALogAsItWasRead)
{
    auto const source = open("iio:ads1015:voltage0").value();
    auto const report = source->read(60s).value().value();
    std::ostringstream out;
    LogWriter writer(out, { .devices = { source->info() } });
    writer.write_report(0, {}, report.bytes());
    ASSERT_TRUE(writer.flush());
    auto const log = parse_log(out.str(), "log").value();
    EXPECT_EQ(describe_device(log.devices.at(0)).kind, DeviceKind::Height);
    auto decoder = make_height_decoder(log.devices[0]).value();
    auto const samples = decode_heights(*decoder, {}, log.report(log.records[0])).value();
    EXPECT_EQ(samples.at(0).counts, 1024);
    EXPECT_EQ(samples.at(0).full_scale, 2047);
}

} // namespace
} // namespace tractus::drivers
