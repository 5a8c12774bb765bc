#include "sim/function_fs_device.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <initializer_list>
#include <linux/usb/functionfs.h>
#include <sys/eventfd.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace tractus::sim {

namespace fs = std::filesystem;

namespace {

// Wrappers for system calls that the C library does not provide.
long io_setup(unsigned count, aio_context_t* context)
{
    return ::syscall(SYS_io_setup, count, context);
}

long io_submit(aio_context_t context, iocb* request)
{
    return ::syscall(SYS_io_submit, context, 1L, &request);
}

long io_getevents(aio_context_t context, std::span<io_event> events)
{
    timespec at_once {};
    return ::syscall(SYS_io_getevents, context, 0L, static_cast<long>(events.size()), events.data(),
                     &at_once);
}

void append(std::vector<std::byte>& bytes, std::initializer_list<unsigned> values)
{
    for (unsigned const value : values)
        bytes.push_back(static_cast<std::byte>(value));
}

void append_u32(std::vector<std::byte>& bytes, std::size_t value)
{
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::byte>(value >> shift & 0xff));
}

// Writes the size of a complete block into the second 32-bit number of its header.
void set_length(std::vector<std::byte>& block)
{
    for (unsigned i = 0; i < 4; ++i)
        block[4 + i] = static_cast<std::byte>(block.size() >> (8 * i) & 0xff);
}

// Counts the descriptors in `bytes`, each of which begins with its length.
std::size_t count_descriptors(std::vector<std::byte> const& bytes)
{
    std::size_t count = 0;
    for (std::size_t at = 0; at < bytes.size(); ++count)
        at += std::max<std::size_t>(1, std::to_integer<std::size_t>(bytes[at]));
    return count;
}

// Builds the descriptor block specified in linux/usb/functionfs.h.
std::vector<std::byte> block_of(UsbFunctionDescriptors const& descriptors)
{
    std::vector<std::byte> block;
    append_u32(block, FUNCTIONFS_DESCRIPTORS_MAGIC_V2);
    append_u32(block, 0);
    // With FUNCTIONFS_ALL_CTRL_RECIP, requests to the device itself are delivered, too.
    append_u32(block, FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_HAS_HS_DESC | FUNCTIONFS_ALL_CTRL_RECIP);
    append_u32(block, count_descriptors(descriptors.full_speed));
    append_u32(block, count_descriptors(descriptors.high_speed));
    block.insert(block.end(), descriptors.full_speed.begin(), descriptors.full_speed.end());
    block.insert(block.end(), descriptors.high_speed.begin(), descriptors.high_speed.end());
    set_length(block);
    return block;
}

// Builds the string block with one English string, the interface's name.
std::vector<std::byte> strings_of(std::string const& name)
{
    std::vector<std::byte> block;
    append_u32(block, FUNCTIONFS_STRINGS_MAGIC);
    append_u32(block, 0);
    append_u32(block, 1);
    append_u32(block, 1);
    append(block, { 0x09, 0x04 });
    for (char const letter : name)
        append(block, { static_cast<unsigned char>(letter) });
    append(block, { 0 });
    set_length(block);
    return block;
}

Result<void> write_block(FileDescriptor const& control, std::vector<std::byte> const& block)
{
    if (::write(control.number(), block.data(), block.size()) >= 0)
        return {};
    return fail(
        Fault::User,
        fmt::format("the kernel's FunctionFS refuses our descriptors: {}", std::strerror(errno)));
}

UsbSetup request_of(usb_ctrlrequest const& setup)
{
    return {
        .request_type = setup.bRequestType,
        .request = setup.bRequest,
        // The kernel's structure is little-endian, as PCs and Raspberry Pis are.
        .value = setup.wValue,
        // The kernel's structure is little-endian, as PCs and Raspberry Pis are.
        .index = setup.wIndex,
        .length = setup.wLength,
    };
}

} // namespace

FunctionFsDevice::FunctionFsDevice(FileDescriptor control, UsbControlAnswers answers)
    : control_(std::move(control))
    , answers_(std::move(answers))
{
}

FunctionFsDevice::~FunctionFsDevice()
{
    // Cancels pending transfers, and waits for them to end.
    if (context_)
        ::syscall(SYS_io_destroy, context_);
}

Result<std::unique_ptr<FunctionFsDevice>>
FunctionFsDevice::add_to(UsbGadget& gadget, UsbFunctionDescriptors const& descriptors,
                         UsbControlAnswers answers)
{
    auto const mount = TRY(gadget.add_file_system_function());
    auto control = TRY(open_kernel_file(mount / "ep0", O_RDWR | O_NONBLOCK,
                                        "is another program playing the gadget?"));
    TRY(write_block(control, block_of(descriptors)));
    TRY(write_block(control, strings_of(descriptors.name)));
    std::unique_ptr<FunctionFsDevice> device(
        new FunctionFsDevice(std::move(control), std::move(answers)));
    TRY(device->open_endpoint(mount));
    return device;
}

Result<void> FunctionFsDevice::open_endpoint(fs::path const& mount)
{
    endpoint_ = TRY(open_kernel_file(mount / "ep1", O_RDWR | O_NONBLOCK,
                                     "is another program playing the gadget?"));
    finished_ = FileDescriptor(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    if (!finished_ || io_setup(kMaxWaiting, &context_) != 0)
        return fail(
            Fault::User,
            fmt::format("the kernel gives no asynchronous transfers: {}", std::strerror(errno)));
    return {};
}

void FunctionFsDevice::add_files_to(std::vector<pollfd>& files) const
{
    files.push_back({ .fd = control_.number(), .events = POLLIN, .revents = 0 });
    files.push_back({ .fd = finished_.number(), .events = POLLIN, .revents = 0 });
}

Result<void> FunctionFsDevice::serve()
{
    finish_transfers();
    while (serve_control()) { }
    return {};
}

Result<void> FunctionFsDevice::send(std::span<std::byte const> report)
{
    TRY(serve());
    auto const free = std::find_if(transfers_.begin(), transfers_.end(),
                                   [](Transfer const& transfer) { return !transfer.is_busy; });
    if (!is_enabled_ || free == transfers_.end() || report.size() > kMaxReportBytes) {
        ++lost_count_;
        return {};
    }
    std::copy(report.begin(), report.end(), free->bytes.begin());
    free->request = {};
    free->request.aio_data = static_cast<std::uint64_t>(free - transfers_.begin());
    free->request.aio_lio_opcode = IOCB_CMD_PWRITE;
    free->request.aio_fildes = static_cast<std::uint32_t>(endpoint_.number());
    free->request.aio_buf = reinterpret_cast<std::uintptr_t>(free->bytes.data());
    free->request.aio_nbytes = report.size();
    free->request.aio_flags = IOCB_FLAG_RESFD;
    free->request.aio_resfd = static_cast<std::uint32_t>(finished_.number());
    if (io_submit(context_, &free->request) != 1) {
        ++lost_count_;
        return {};
    }
    free->is_busy = true;
    ++waiting_count_;
    return {};
}

void FunctionFsDevice::finish_transfers()
{
    // Reading resets the eventfd. The number read is not needed, because io_getevents() counts the
    // ended transfers.
    std::uint64_t ignored = 0;
    static_cast<void>(!::read(finished_.number(), &ignored, sizeof ignored));
    std::array<io_event, kMaxWaiting> events {};
    long const count = io_getevents(context_, events);
    for (long i = 0; i < count; ++i) {
        auto const& event = events[static_cast<std::size_t>(i)];
        transfers_[event.data].is_busy = false;
        --waiting_count_;
        if (event.res >= 0)
            is_read_ = true;
        else
            ++lost_count_;
    }
}

// Handles one control event. Returns false if there was none.
bool FunctionFsDevice::serve_control()
{
    usb_functionfs_event event {};
    if (::read(control_.number(), &event, sizeof event) != static_cast<ssize_t>(sizeof event))
        return false;
    switch (event.type) {
    case FUNCTIONFS_SETUP:
        answer(request_of(event.u.setup));
        break;
    case FUNCTIONFS_ENABLE:
        is_enabled_ = true;
        break;
    case FUNCTIONFS_DISABLE:
    case FUNCTIONFS_UNBIND:
        is_enabled_ = is_read_ = false;
        if (answers_.reset)
            answers_.reset();
        break;
    default: // The device was bound, suspended or resumed.
        break;
    }
    return true;
}

// Answers a control request. To refuse it, the data stage is begun in the wrong direction. Errors
// are ignored: they mean that the host has gone, or has already made another request.
void FunctionFsDevice::answer(UsbSetup const& request)
{
    std::array<std::byte, 4096> data;
    if (request.request_type & USB_DIR_IN) {
        auto const reply = answers_.get ? answers_.get(request) : std::nullopt;
        if (reply)
            static_cast<void>(!::write(control_.number(), reply->data(),
                                       std::min<std::size_t>(reply->size(), request.length)));
        else
            static_cast<void>(!::read(control_.number(), data.data(), 0));
        return;
    }
    bool const is_without_data = request.length == 0;
    bool const may_set = answers_.set && request.length <= data.size();
    if (may_set && is_without_data) {
        if (answers_.set(request, {}))
            static_cast<void>(!::read(control_.number(), data.data(), 0));
        else
            static_cast<void>(!::write(control_.number(), data.data(), 0));
    } else if (may_set) {
        auto const size = ::read(control_.number(), data.data(), request.length);
        if (size >= 0)
            answers_.set(request, std::span(data).first(static_cast<std::size_t>(size)));
    } else {
        static_cast<void>(!::write(control_.number(), data.data(), 0));
    }
}

} // namespace tractus::sim
