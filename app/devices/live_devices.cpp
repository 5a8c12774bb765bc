#include "app/devices/live_devices.h"

#include "app/files/resources.h"
#include "app/play/paced_log.h"
#include "drivers/device_kind.h"
#include "drivers/device_list.h"
#include "drivers/logs/log.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace tractus::devices {

static constexpr std::string_view kSimulated = "simulated";

std::string_view device_name_help()
{
    return "an address that \"tractus devices\" lists (/dev/hidrawN, libusb:BUS-PORTS:INTERFACE, "
           "usb:BUS-PORTS, /dev/ttyACM0@BAUD,max=NUMBER, iio:DEVICE:CHANNEL), "
           "gpio:CHIP:CLK,DIN,DOUT,CS:mcp3208:CHANNEL, a log's file name, or simulated";
}

std::vector<drivers::DeviceInfo> find_pens_and_height_sensors()
{
    auto devices = drivers::list_devices();
    std::erase_if(devices, [](auto const& info) {
        return drivers::describe_device(info).kind == drivers::DeviceKind::Other;
    });
    return devices;
}

Result<LiveDevices> LiveDevices::start(std::vector<std::unique_ptr<drivers::ReportSource>> sources)
{
    LiveDevices devices;
    for (auto& source : sources)
        TRY(devices.add(std::move(source), nullptr));
    return devices;
}

LiveDevices LiveDevices::open_usable(std::vector<drivers::DeviceInfo> const& infos,
                                     std::vector<RefusedDevice>& refused)
{
    LiveDevices devices;
    auto const reconnection = drivers::system_reconnection();
    for (auto const& info : infos)
        if (auto const added = devices.add_real(info, reconnection); !added)
            refused.push_back({ info, added.error() });
    return devices;
}

Result<LiveDevices> LiveDevices::open_named(std::span<std::string const> names)
{
    LiveDevices devices;
    auto const reconnection = drivers::system_reconnection();
    for (auto const& name : names) {
        std::error_code ignored;
        if (name == kSimulated || std::filesystem::is_regular_file(name, ignored))
            TRY(devices.add_log(name));
        else if (auto info = drivers::find_device(name))
            TRY(devices.add_real(*std::move(info), reconnection));
        else
            return tl::unexpected(std::move(info).error());
    }
    return devices;
}

Result<void> LiveDevices::add(std::unique_ptr<drivers::ReportSource> source,
                              drivers::ReconnectingSource const* reconnecting)
{
    auto threaded = TRY(drivers::ThreadedSource::start(std::move(source)));
    auto const* const observed = threaded.get();
    infos_.push_back(threaded->info());
    devices_.push_back({ std::move(threaded), observed, reconnecting });
    return {};
}

Result<void> LiveDevices::add_real(drivers::DeviceInfo info,
                                   drivers::Reconnection const& reconnection)
{
    auto source = TRY(drivers::ReconnectingSource::open(std::move(info), reconnection));
    auto const* const observed = source.get();
    return add(std::move(source), observed);
}

// Adds the devices of a log. The name "simulated" stands for the log of a demonstration.
Result<void> LiveDevices::add_log(std::string const& name)
{
    auto const demo = files::find_resource("demo/broadleaf.tractus-log");
    if (name == kSimulated && !demo)
        return tl::unexpected(demo.error());
    auto read = TRY(drivers::read_log(name == kSimulated ? *demo : std::filesystem::path(name)));
    auto const log = std::make_shared<drivers::Log const>(std::move(read));
    if (rig_text_.empty())
        rig_text_ = log->rig_text;
    auto const pace = play::pace_from_now(log->begin());
    for (std::size_t i = 0; i < log->devices.size(); ++i)
        TRY(add(play::open_paced(log, i, pace), nullptr));
    return {};
}

Result<LiveDevices> LiveDevices::play_log(std::string const& name,
                                          std::function<Timestamp()> const& now)
{
    auto read = TRY(drivers::read_log(name));
    auto const log = std::make_shared<drivers::Log const>(std::move(read));
    LiveDevices devices;
    devices.rig_text_ = log->rig_text;
    play::Pace const pace {
        .data_begin = log->begin(),
        .real_begin = now(),
        .now = now,
        .wait = [](Duration) {}, // Nothing waits, as the log is read without blocking.
    };
    for (std::size_t i = 0; i < log->devices.size(); ++i)
        devices.add_source_without_thread(play::open_paced(log, i, pace));
    return devices;
}

Result<LiveDevices> LiveDevices::play_hand(std::function<Timestamp()> const& now,
                                           std::string const& recording)
{
    auto const file = TRY(files::find_resource(recording));
    auto read = TRY(drivers::read_log(file));
    auto const log = std::make_shared<drivers::Log const>(std::move(read));
    LiveDevices devices;
    devices.rig_text_ = log->rig_text;
    devices.hand_.emplace(log, now);
    for (auto& source : devices.hand_->open_sources())
        devices.add_source_without_thread(std::move(source));
    return devices;
}

void LiveDevices::start_simulated_hand()
{
    if (hand_)
        hand_->begin();
}

std::vector<drivers::LogTool> LiveDevices::take_hand_tools()
{
    return hand_ ? hand_->take_tools() : std::vector<drivers::LogTool>();
}

void LiveDevices::add_source_without_thread(std::unique_ptr<drivers::ReportSource> source)
{
    infos_.push_back(source->info());
    devices_.push_back({ std::move(source), nullptr, nullptr });
}

LiveDevices::State LiveDevices::state(std::size_t device) const
{
    auto const& one = devices_.at(device);
    if (!one.source)
        return State::Ended;
    return !one.reconnecting || one.reconnecting->is_connected() ? State::Connected : State::Away;
}

std::string LiveDevices::refusal(std::size_t device) const
{
    auto const& one = devices_.at(device);
    return one.source && one.reconnecting ? one.reconnecting->refusal() : std::string();
}

bool LiveDevices::any_left() const
{
    return std::any_of(devices_.begin(), devices_.end(),
                       [](auto const& device) { return device.source != nullptr; });
}

void LiveDevices::take(std::vector<LiveReport>& reports)
{
    reports.clear();
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        auto& [source, threaded, reconnecting] = devices_[i];
        while (source) {
            auto const report = source->read(Duration::zero());
            if (report && !*report)
                break;
            if (report) {
                reports.push_back({ i, **report });
                auto& received = reports.back().report.received;
                received = std::chrono::floor<std::chrono::microseconds>(received);
                continue;
            }
            if (threaded)
                lost_by_ended_ += threaded->lost_count();
            source.reset();
        }
    }
    std::stable_sort(reports.begin(), reports.end(), [](auto const& a, auto const& b) {
        return a.report.received < b.report.received;
    });
}

std::uint64_t LiveDevices::lost_count() const
{
    auto count = lost_by_ended_;
    for (auto const& device : devices_)
        count += device.source && device.threaded ? device.threaded->lost_count() : 0;
    return count;
}

} // namespace tractus::devices
