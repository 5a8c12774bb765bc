#include "sim/gadget_hid.h"

#include "drivers/reports/report_descriptor.h"
#include "engine/base/file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fmt/core.h>
#include <optional>
#include <string_view>
#include <unistd.h>

namespace tractus::sim {

namespace fs = std::filesystem;

namespace {

// Returns the endpoint's packet size, which must exceed the size of every report. A transfer of
// exactly the packet size would have to be ended by an empty packet, which some readers see as a
// report without bytes. Below high speed, the greatest packet size is 64.
std::size_t packet_bytes(drivers::HidReportDescriptor const& descriptor)
{
    std::size_t bytes = 64;
    for (auto const& report : descriptor.reports)
        bytes = std::max(bytes, report.bytes + 1);
    return bytes;
}

// Kind of an interface (HID 1.11, sections 4.2 and 4.3). A tablet that starts as a mouse also
// supports the boot mouse's reports, which a computer understands before it has read a descriptor.
struct InterfaceKind {
    char const* subclass = "0";
    char const* protocol = "0";
};

InterfaceKind interface_kind(drivers::HidReportDescriptor const& descriptor)
{
    constexpr drivers::HidUsage kMouse = 0x0001'0002;
    bool const is_mouse
        = !descriptor.collections.empty() && descriptor.collections.front().usage == kMouse;
    return is_mouse ? InterfaceKind { "1", "2" } : InterfaceKind {};
}

// Returns the node that the kernel makes for the function when the gadget is plugged in.
std::optional<fs::path> node_of(fs::path const& folder)
{
    auto numbers = read_file(folder / "dev");
    if (!numbers)
        return std::nullopt;
    while (numbers->ends_with('\n'))
        numbers->pop_back();
    auto const event = read_file(fs::path("/sys/dev/char") / *numbers / "uevent");
    constexpr std::string_view kKey = "DEVNAME=";
    auto const found = event ? event->find(kKey) : std::string::npos;
    if (found == std::string::npos)
        return std::nullopt;
    auto const begin = found + kKey.size();
    return fs::path("/dev") / event->substr(begin, event->find('\n', begin) - begin);
}

std::string as_text(std::span<std::byte const> bytes)
{
    return { reinterpret_cast<char const*>(bytes.data()), bytes.size() };
}

} // namespace

GadgetHid::GadgetHid(fs::path folder)
    : folder_(std::move(folder))
{
}

Result<std::unique_ptr<GadgetHid>> GadgetHid::add_to(UsbGadget& gadget, std::string const& name,
                                                     drivers::DeviceInfo const& info)
{
    if (info.report_descriptor.empty())
        return fail(Fault::User,
                    fmt::format("{} cannot be played as a USB device: its report "
                                "descriptor is not known",
                                info.name));
    auto const descriptor = TRY(drivers::parse_report_descriptor(info.report_descriptor));
    auto const kind = interface_kind(descriptor);
    auto const folder
        = TRY(gadget.add_function("hid." + name,
                                  { { "protocol", kind.protocol },
                                    { "subclass", kind.subclass },
                                    { "report_length", std::to_string(packet_bytes(descriptor)) },
                                    { "report_desc", as_text(info.report_descriptor) } }));
    return std::unique_ptr<GadgetHid>(new GadgetHid(folder));
}

void GadgetHid::add_files_to(std::vector<pollfd>& files) const
{
    if (!file_)
        return;
    short const events = in_flight_ ? POLLIN | POLLOUT : POLLIN;
    files.push_back({ .fd = file_.number(), .events = events, .revents = 0 });
}

Result<void> GadgetHid::serve()
{
    if (!file_)
        return {};
    discard_output();
    if (in_flight_ && is_taken()) {
        in_flight_ = false;
        // The first report that is taken may be discarded while the host configures the device.
        is_read_ = ++taken_count_ > 1;
        was_read_ |= is_read_;
    }
    if (!in_flight_ && !waiting_.empty())
        write_next();
    return {};
}

Result<void> GadgetHid::send(std::span<std::byte const> report)
{
    if (!file_ && !open()) {
        lose(1);
        return {};
    }
    if (waiting_.size() == kMaxWaiting) {
        waiting_.pop_front();
        lose(1);
    }
    waiting_.emplace_back(report.begin(), report.end());
    return serve();
}

bool GadgetHid::open()
{
    if (auto const node = node_of(folder_))
        file_ = FileDescriptor(::open(node->c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
    return static_cast<bool>(file_);
}

bool GadgetHid::is_taken() const
{
    pollfd file { .fd = file_.number(), .events = POLLOUT, .revents = 0 };
    return ::poll(&file, 1, 0) > 0 && (file.revents & POLLOUT);
}

void GadgetHid::discard_output()
{
    std::array<std::byte, 512> report;
    while (::read(file_.number(), report.data(), report.size()) > 0) { }
}

void GadgetHid::write_next()
{
    auto const& report = waiting_.front();
    if (::write(file_.number(), report.data(), report.size()) >= 0) {
        waiting_.pop_front();
        in_flight_ = true;
    } else if (errno == EAGAIN) {
        in_flight_ = true;
    } else if (errno != EINTR) {
        leave();
    }
}

void GadgetHid::lose(std::size_t count)
{
    if (was_read_)
        lost_count_ += count;
}

// Discards the waiting reports and resets the state, because the host has gone.
void GadgetHid::leave()
{
    lose(waiting_count());
    waiting_.clear();
    in_flight_ = false;
    is_read_ = false;
    taken_count_ = 0;
    file_.close();
}

} // namespace tractus::sim
