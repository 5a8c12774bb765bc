#include "drivers/tablets/hidapi_libusb.h"

#include <fmt/core.h>
#include <hidapi.h>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

// Functions of the static library under their changed names.
extern "C" {
int tractus_libusb_hid_init(void);
int tractus_libusb_hid_exit(void);
hid_device_info* tractus_libusb_hid_enumerate(unsigned short vendor_id, unsigned short product_id);
void tractus_libusb_hid_free_enumeration(hid_device_info*);
hid_device* tractus_libusb_hid_open_path(char const*);
void tractus_libusb_hid_close(hid_device*);
int tractus_libusb_hid_read_timeout(hid_device*, unsigned char*, std::size_t, int);
int tractus_libusb_hid_write(hid_device*, unsigned char const*, std::size_t);
int tractus_libusb_hid_send_feature_report(hid_device*, unsigned char const*, std::size_t);
wchar_t const* tractus_libusb_hid_error(hid_device*);
}

namespace tractus::drivers {

namespace {

// Owns hidapi's libusb back end. It has one context for all devices, which does not see devices
// plugged in later if there is no udev. The context is therefore recreated whenever no device is
// open.
class Library {
public:
    static std::mutex& mutex()
    {
        static std::mutex mutex;
        return mutex;
    }

    // Recreates the context if no device is open. Requires the mutex to be locked.
    static void begin()
    {
        if (open_count == 0)
            tractus_libusb_hid_exit();
        tractus_libusb_hid_init();
    }
    static void count_opened() { ++open_count; }

    static void close(hid_device* device)
    {
        std::lock_guard const lock(mutex());
        tractus_libusb_hid_close(device);
        --open_count;
    }

private:
    static inline int open_count = 0;
};

constexpr HidBackEnd kBackEnd { .write = tractus_libusb_hid_write,
                                .read_timeout = tractus_libusb_hid_read_timeout,
                                .close = Library::close,
                                .error = tractus_libusb_hid_error };

struct FreeEnumeration {
    void operator()(hid_device_info* list) const { tractus_libusb_hid_free_enumeration(list); }
};

// Returns hidapi's path of an interface. Paths begin with the port: "1-2.3:1.0" is port 2.3 of bus
// 1, configuration 1, interface 0.
std::string find_path(LibusbAddress const& address, DeviceInfo const& info)
{
    auto const port = print_usb_port(address.port) + ":";
    std::unique_ptr<hid_device_info, FreeEnumeration> const list(
        tractus_libusb_hid_enumerate(info.vendor_id, info.product_id));
    for (auto const* device = list.get(); device; device = device->next)
        if (std::string_view(device->path).starts_with(port)
            && device->interface_number == address.interface_number)
            return device->path;
    return {};
}

unsigned char const* as_chars(std::span<std::byte const> report)
{
    return reinterpret_cast<unsigned char const*>(report.data());
}

} // namespace

Result<LibusbHid> LibusbHid::open(LibusbAddress const& address, DeviceInfo const& info)
{
    std::lock_guard const lock(Library::mutex());
    Library::begin();
    auto const path = find_path(address, info);
    if (path.empty())
        return fail(Fault::User,
                    fmt::format("there is no HID interface {} on a USB device at {} (was it "
                                "unplugged?)",
                                address.interface_number, print_usb_port(address.port)));
    auto* const device = tractus_libusb_hid_open_path(path.c_str());
    if (!device)
        return fail(Fault::User,
                    fmt::format("cannot open {} at {} through libusb: is drivers/70-tractus.rules "
                                "in /etc/udev/rules.d, and does no other program have it?",
                                info.name, info.location));
    Library::count_opened();
    return LibusbHid(HidHandle(device, Library::close));
}

Result<void> LibusbHid::check_sent(int size, std::span<std::byte const> report) const
{
    if (size < 0 || static_cast<std::size_t>(size) < report.size())
        return fail(Fault::Device,
                    fmt::format("the tablet does not take report {}",
                                std::to_integer<int>(report.front())));
    return {};
}

Result<void> LibusbHid::send_feature(std::span<std::byte const> report)
{
    return check_sent(
        tractus_libusb_hid_send_feature_report(handle_.get(), as_chars(report), report.size()),
        report);
}

Result<void> LibusbHid::send_output(std::span<std::byte const> report)
{
    return check_sent(tractus_libusb_hid_write(handle_.get(), as_chars(report), report.size()),
                      report);
}

std::unique_ptr<ReportSource> LibusbHid::into_source(DeviceInfo info) &&
{
    auto link = make_hid_link(kBackEnd, std::move(handle_), info);
    return make_hid_source(std::move(info), std::move(link));
}

} // namespace tractus::drivers
