#include "app/devices/live_recorder.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/file.h"

#include <cerrno>
#include <cstring>
#include <fmt/core.h>
#include <fstream>
#include <utility>

namespace tractus::devices {

Result<void> check_new_file(std::filesystem::path const& path)
{
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored))
        return fail(Fault::User,
                    fmt::format("{} is already there: choose another name, a recording "
                                "is never written over",
                                path.string()));
    return check_writable(path);
}

Result<LiveRecorder> LiveRecorder::create(std::filesystem::path const& path,
                                          drivers::LogHeader const& header)
{
    TRY(check_new_file(path));
    if (path.has_parent_path())
        TRY(make_folder(path.parent_path()));
    // The file has its final name from the start, as a log that was cut short is still valid.
    auto out = std::make_unique<std::ofstream>(path, std::ios::binary);
    if (!*out)
        return fail(Fault::User,
                    fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
    LiveRecorder recorder(std::move(out), header);
    TRY(recorder.flush());
    return recorder;
}

LiveRecorder::LiveRecorder(std::unique_ptr<std::ostream> out, drivers::LogHeader const& header)
    : out_(std::move(out))
    , log_(std::make_unique<drivers::LogWriter>(*out_, header))
    , next_flush_(header.start + kFlushEvery)
{
    for (auto const& info : header.devices) {
        auto decoder = drivers::make_pen_decoder(info);
        pens_.push_back({ .decoder = decoder ? *std::move(decoder) : nullptr });
    }
}

void LiveRecorder::write(LiveReport const& report)
{
    log_->write_report(report.device, report.report.received, report.report.bytes());
    report_count_ += report.report.size > 0;
    stroke_ended_ |= ends_stroke(report);
}

bool LiveRecorder::ends_stroke(LiveReport const& report)
{
    auto& [decoder, touching] = pens_[report.device];
    if (report.report.size == 0)
        return std::exchange(touching, false);
    if (!decoder)
        return false;
    samples_.clear();
    (void)decoder->decode(report.report, samples_);
    bool ends = false;
    for (auto const& sample : samples_)
        ends |= std::exchange(touching, sample.touching) && !sample.touching;
    return ends;
}

void LiveRecorder::write_tool(Timestamp time, std::string_view tool, std::string_view arguments)
{
    log_->write_tool(time, tool, arguments);
}

Result<void> LiveRecorder::flush_if_due(Timestamp now)
{
    if (!stroke_ended_ && now < next_flush_)
        return {};
    stroke_ended_ = false;
    next_flush_ = now + kFlushEvery;
    return flush();
}

Result<void> LiveRecorder::flush()
{
    TRY(log_->flush());
    byte_count_ = static_cast<std::uint64_t>(std::streamoff(out_->tellp()));
    return {};
}

} // namespace tractus::devices
