#include "sim/uhid_device.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <linux/uhid.h>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace tractus::sim {

namespace {

constexpr auto kNode = "/dev/uhid";

// Copies a text, truncated if it is too long; the field's last byte stays 0.
template<std::size_t Size> void copy_text(std::string_view text, __u8 (&field)[Size])
{
    std::memcpy(field, text.data(), std::min(text.size(), Size - 1));
}

std::span<std::byte const> bytes_of(__u8 const* data, std::size_t size)
{
    return { reinterpret_cast<std::byte const*>(data), size };
}

Result<void> write_event(FileDescriptor const& file, uhid_event const& event)
{
    if (::write(file.number(), &event, sizeof event) >= 0)
        return {};
    return fail(Fault::User, fmt::format("{} refuses an event: {}", kNode, std::strerror(errno)));
}

uhid_event answer_get(uhid_get_report_req const& request, UhidAnswers const& answers)
{
    uhid_event reply {};
    reply.type = UHID_GET_REPORT_REPLY;
    auto& fields = reply.u.get_report_reply;
    fields.id = request.id;
    auto const report = answers.get_feature ? answers.get_feature(request.rnum) : std::nullopt;
    if (report) {
        fields.size = static_cast<__u16>(std::min<std::size_t>(report->size(), UHID_DATA_MAX));
        std::memcpy(fields.data, report->data(), fields.size);
    } else {
        fields.err = EIO;
    }
    return reply;
}

uhid_event answer_set(uhid_set_report_req const& request, UhidAnswers const& answers)
{
    uhid_event reply {};
    reply.type = UHID_SET_REPORT_REPLY;
    reply.u.set_report_reply.id = request.id;
    auto const size = std::min<std::size_t>(request.size, UHID_DATA_MAX);
    bool const is_taken = answers.set_feature && answers.set_feature(bytes_of(request.data, size));
    reply.u.set_report_reply.err = is_taken ? 0 : EIO;
    return reply;
}

} // namespace

UhidDevice::UhidDevice(FileDescriptor file, UhidAnswers answers)
    : file_(std::move(file))
    , answers_(std::move(answers))
{
}

Result<std::unique_ptr<UhidDevice>> UhidDevice::create(drivers::DeviceInfo const& info,
                                                       UhidAnswers answers)
{
    auto file
        = TRY(open_kernel_file(kNode, O_RDWR | O_NONBLOCK,
                               "try \"sudo modprobe uhid\", and sudo: only root may make devices"));
    if (info.report_descriptor.empty() || info.report_descriptor.size() > HID_MAX_DESCRIPTOR_SIZE)
        return fail(Fault::User,
                    fmt::format("{} cannot be played: its report descriptor has {} bytes, and the "
                                "kernel takes 1 to {}",
                                info.name, info.report_descriptor.size(), HID_MAX_DESCRIPTOR_SIZE));
    uhid_event event {};
    event.type = UHID_CREATE2;
    auto& fields = event.u.create2;
    copy_text(info.name, fields.name);
    copy_text(info.physical_path, fields.phys);
    copy_text(info.serial_number, fields.uniq);
    fields.bus = info.bus;
    fields.vendor = info.vendor_id;
    fields.product = info.product_id;
    fields.rd_size = static_cast<__u16>(info.report_descriptor.size());
    std::memcpy(fields.rd_data, info.report_descriptor.data(), info.report_descriptor.size());
    TRY(write_event(file, event));
    return std::unique_ptr<UhidDevice>(new UhidDevice(std::move(file), std::move(answers)));
}

void UhidDevice::add_files_to(std::vector<pollfd>& files) const
{
    files.push_back({ .fd = file_.number(), .events = POLLIN, .revents = 0 });
}

Result<void> UhidDevice::serve()
{
    // Maximum number of events handled at once, since a program that sends requests quickly enough
    // would keep this loop running for ever.
    constexpr int kAtOnce = 16;
    uhid_event event {};
    for (int i = 0; i < kAtOnce; ++i) {
        if (::read(file_.number(), &event, sizeof event) > 0)
            TRY(serve(event));
        else if (errno == EAGAIN || errno == EINTR)
            return {};
        else
            return fail(Fault::User,
                        fmt::format("cannot read {}: {}", kNode, std::strerror(errno)));
    }
    return {};
}

Result<void> UhidDevice::serve(uhid_event const& event)
{
    switch (event.type) {
    case UHID_OPEN:
        is_open_ = true;
        return {};
    case UHID_CLOSE:
        is_open_ = false;
        return {};
    case UHID_OUTPUT:
        return reply_to(bytes_of(event.u.output.data, event.u.output.size));
    case UHID_GET_REPORT:
        return write_event(file_, answer_get(event.u.get_report, answers_));
    case UHID_SET_REPORT:
        return write_event(file_, answer_set(event.u.set_report, answers_));
    default: // UHID_START and UHID_STOP: a driver was bound or unbound.
        return {};
    }
}

Result<void> UhidDevice::reply_to(std::span<std::byte const> output)
{
    if (!answers_.output)
        return {};
    auto const reply = answers_.output(output);
    return reply.empty() ? Result<void>() : send(reply);
}

Result<void> UhidDevice::send(std::span<std::byte const> report)
{
    uhid_event event {};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<__u16>(std::min<std::size_t>(report.size(), UHID_DATA_MAX));
    std::memcpy(event.u.input2.data, report.data(), event.u.input2.size);
    return write_event(file_, event);
}

} // namespace tractus::sim
