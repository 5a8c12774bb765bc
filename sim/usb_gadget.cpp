#include "sim/usb_gadget.h"

#include "engine/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tractus::sim {

namespace fs = std::filesystem;

namespace {

constexpr auto kConfiguration = "configs/c.1";
constexpr auto kAsRoot = "only root may make USB devices: try sudo";

std::vector<fs::path> entries_of(fs::path const& folder)
{
    std::vector<fs::path> entries;
    std::error_code ignored; // A missing folder means that there are no entries.
    for (fs::directory_iterator entry(folder, ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        entries.push_back(entry->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

Result<void> make_config_folder(fs::path const& folder)
{
    if (::mkdir(folder.c_str(), 0755) == 0)
        return {};
    int const error = errno;
    return fail(
        Fault::User,
        fmt::format("cannot make {}: {} ({})", folder.string(), std::strerror(error),
                    error == EACCES || error == EPERM ? kAsRoot : "does the kernel know it?"));
}

fs::path mount_of(UsbGadgetPlace const& place, fs::path const& gadget)
{
    return place.mounts / fmt::format("{}-gadget", gadget.filename().string());
}

// Removes a gadget, from its innermost parts outwards. Attributes disappear with their folders.
// Errors are ignored, since parts may be missing.
void remove_gadget(UsbGadgetPlace const& place, fs::path const& gadget)
{
    static_cast<void>(write_attribute(gadget / "UDC", "\n"));
    auto const mount = mount_of(place, gadget);
    ::umount2(mount.c_str(), MNT_DETACH);
    ::rmdir(mount.c_str());
    std::error_code ignored;
    for (auto const& entry : entries_of(gadget / kConfiguration))
        if (fs::is_symlink(entry, ignored))
            ::unlink(entry.c_str());
    for (auto const* const strings : { "configs/c.1/strings", "configs", "functions", "strings" })
        for (auto const& folder : entries_of(gadget / strings))
            ::rmdir(folder.c_str());
    ::rmdir(gadget.c_str());
}

Result<void> check_kernel(UsbGadgetPlace const& place)
{
    std::error_code ignored;
    if (fs::is_directory(place.configfs / "usb_gadget", ignored))
        return {};
    if (fs::is_empty(place.configfs, ignored) || !fs::exists(place.configfs, ignored))
        return fail(Fault::User,
                    fmt::format("{} is empty, so no USB device can be made there: try \"sudo mount "
                                "-t configfs none {}\" and \"sudo modprobe libcomposite\"",
                                place.configfs.string(), place.configfs.string()));
    return fail(Fault::User,
                fmt::format("there is no {}/usb_gadget, so no USB device can be made there: try "
                            "\"sudo modprobe libcomposite\"",
                            place.configfs.string()));
}

// Locks the gadget's folder; the system releases the lock when the process ends. Returns an empty
// descriptor if another program holds the lock.
FileDescriptor lock_folder(fs::path const& folder)
{
    FileDescriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file && ::flock(file.number(), LOCK_EX | LOCK_NB) != 0)
        file.close();
    return file;
}

Result<std::string> find_free_port(fs::path const& ports)
{
    auto const all = entries_of(ports);
    for (auto const& port : all)
        if (auto const function = read_file(port / "function"); !function || function->size() <= 1)
            return port.filename().string();
    return fail(
        Fault::User,
        all.empty()
            ? "this computer has no USB device port: on a PC try \"sudo modprobe dummy_hcd\", "
              "which plays port and host; on a Raspberry Pi add the line \"dtoverlay=dwc2\" to "
              "config.txt, restart and \"sudo modprobe dwc2\""
            : fmt::format("the computer's USB device port {} is taken by another gadget: see {}",
                          all.front().filename().string(), ports.string()));
}

} // namespace

Result<void> write_attribute(fs::path const& path, std::string_view value)
{
    FileDescriptor const file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file && ::write(file.number(), value.data(), value.size()) >= 0)
        return {};
    int const error = errno;
    return fail(
        Fault::User,
        fmt::format("cannot write {}: {}{}", path.string(), std::strerror(error),
                    error == EACCES || error == EPERM ? fmt::format(" ({})", kAsRoot) : ""));
}

UsbGadget::UsbGadget(UsbGadgetPlace place, fs::path folder, FileDescriptor lock)
    : place_(std::move(place))
    , folder_(std::move(folder))
    , lock_(std::move(lock))
{
}

UsbGadget::~UsbGadget()
{
    remove_gadget(place_, folder_);
}

Result<std::unique_ptr<UsbGadget>> UsbGadget::create(UsbGadgetIdentity const& identity,
                                                     UsbGadgetPlace const& place)
{
    TRY(check_kernel(place));
    auto const folder = place.configfs / "usb_gadget" / identity.name;
    if (std::error_code ignored; fs::exists(folder, ignored)) {
        if (!lock_folder(folder))
            return fail(Fault::User,
                        fmt::format("another program plays the gadget {}: end it first, or give "
                                    "this one another name",
                                    folder.string()));
        remove_gadget(place, folder);
    }
    TRY(make_config_folder(folder));
    auto lock = lock_folder(folder);
    auto gadget = std::unique_ptr<UsbGadget>(new UsbGadget(place, folder, std::move(lock)));
    TRY(gadget->fill(identity));
    return gadget;
}

Result<void> UsbGadget::fill(UsbGadgetIdentity const& identity)
{
    TRY(write_attribute(folder_ / "idVendor", fmt::format("{:#06x}", identity.vendor_id)));
    TRY(write_attribute(folder_ / "idProduct", fmt::format("{:#06x}", identity.product_id)));
    TRY(write_attribute(folder_ / "bcdDevice", fmt::format("{:#06x}", identity.release)));
    TRY(write_attribute(folder_ / "bcdUSB", "0x0200"));
    auto const strings = folder_ / "strings/0x409"; // Language English (US).
    TRY(make_config_folder(strings));
    TRY(write_attribute(strings / "manufacturer", identity.manufacturer));
    TRY(write_attribute(strings / "product", identity.product));
    TRY(write_attribute(strings / "serialnumber", identity.serial_number));
    TRY(make_config_folder(folder_ / kConfiguration));
    return write_attribute(folder_ / kConfiguration / "MaxPower", "100");
}

Result<fs::path> UsbGadget::add_function(std::string const& function,
                                         std::vector<Attribute> const& attributes)
{
    auto const folder = folder_ / "functions" / function;
    TRY(make_config_folder(folder));
    // Attributes must be written first: they are fixed once the function is in a configuration.
    for (auto const& attribute : attributes)
        TRY(write_attribute(folder / attribute.name, attribute.value));
    std::error_code error;
    fs::create_symlink(folder, folder_ / kConfiguration / function, error);
    if (error)
        return fail(Fault::User,
                    fmt::format("cannot put {} into the gadget's configuration: {}", function,
                                error.message()));
    return folder;
}

Result<fs::path> UsbGadget::add_file_system_function()
{
    // Names of FunctionFS functions are global to the system, so the gadget's name is used.
    auto const name = folder_.filename().string();
    TRY(add_function("ffs." + name));
    auto const mount = mount_of(place_, folder_);
    TRY(make_config_folder(mount));
    if (::mount(name.c_str(), mount.c_str(), "functionfs", 0, nullptr) != 0)
        return fail(
            Fault::User,
            fmt::format("cannot mount FunctionFS at {}: {}", mount.string(), std::strerror(errno)));
    return mount;
}

Result<void> UsbGadget::plug_in(std::string const& port)
{
    auto const chosen = port.empty() ? TRY(find_free_port(place_.ports)) : port;
    return write_attribute(folder_ / "UDC", chosen);
}

Result<void> UsbGadget::unplug()
{
    return write_attribute(folder_ / "UDC", "\n");
}

} // namespace tractus::sim
