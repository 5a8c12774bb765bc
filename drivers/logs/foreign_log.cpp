#include "drivers/logs/foreign_log.h"

#include "drivers/logs/lent_descriptors.h"
#include "drivers/logs/log_text.h"
#include "engine/base/file.h"

#include <fmt/core.h>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace tractus::drivers {

// Number of bytes at a text's start that are searched for its format.
static constexpr std::size_t kHeadBytes = std::size_t { 1 } << 16;

std::optional<LogFormat> guess_log_format(std::string_view text)
{
    text = text.substr(0, kHeadBytes);
    while (!text.empty()) {
        auto const end = text.find('\n');
        auto const line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (begins_usbhid_dump_block(line))
            return LogFormat::UsbhidDump;
        if (begins_evemu_recording(line))
            return LogFormat::Evemu;
        if (line.starts_with("ndevices:") || line.starts_with("libinput:"))
            return LogFormat::LibinputRecord;
        if (line.starts_with("R:"))
            return LogFormat::TractusLog;
    }
    return std::nullopt;
}

static Result<Log> parse_foreign_log(LogFormat format, std::istream& in, std::string_view name)
{
    switch (format) {
    case LogFormat::UsbhidDump:
        return parse_usbhid_dump(in, name);
    case LogFormat::LibinputRecord:
        return parse_libinput_record(in, name);
    default:
        return parse_evemu(in, name);
    }
}

std::optional<LogFormat> guess_file_format(std::filesystem::path const& path)
{
    std::error_code no_file;
    std::ifstream in;
    if (std::filesystem::is_regular_file(path, no_file))
        in.open(path, std::ios::binary);
    if (!in.is_open())
        return std::nullopt;
    std::string head(kHeadBytes, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return guess_log_format(head);
}

namespace {

// A recording read from a pipe, which cannot be read a second time once its format is known.
class PipedRecording {
public:
    explicit PipedRecording(std::string name)
        : name_(std::move(name))
        , log_(name_, kMaxPipedLogBytes)
    {
    }

    Result<void> feed(std::string_view piece)
    {
        if (format_ != LogFormat::TractusLog)
            text_ += piece;
        if (!format_ && text_.size() >= kHeadBytes)
            TRY(begin());
        else if (format_ == LogFormat::TractusLog)
            TRY(log_.feed(piece));
        if (!log_.rest() && text_.size() <= kMaxPipedLogBytes)
            return {};
        return fail(Fault::User,
                    fmt::format("{} is no file, and more comes from it than is kept in memory: "
                                "save it in a file first",
                                name_));
    }

    Result<Log> take_log()
    {
        if (!format_)
            TRY(begin());
        if (format_ == LogFormat::TractusLog) {
            TRY(log_.end());
            return log_.take_log();
        }
        std::istringstream in(std::move(text_));
        return parse_foreign_log(*format_, in, name_);
    }

private:
    Result<void> begin()
    {
        format_ = guess_log_format(text_).value_or(LogFormat::TractusLog);
        return format_ == LogFormat::TractusLog ? log_.feed(std::exchange(text_, {}))
                                                : Result<void>();
    }

    std::string name_;
    LogText log_;
    std::optional<LogFormat> format_; // Recognised format; no value before that.
    // The text read before the format was recognised. For formats other than ours, the whole text.
    std::string text_;
};

} // namespace

static Result<Log> read_as_recorded(std::filesystem::path const& path)
{
    if (std::error_code no_file; !std::filesystem::is_regular_file(path, no_file)) {
        PipedRecording recording(path.string());
        TRY(read_file_in_pieces(path, std::numeric_limits<std::size_t>::max(),
                                [&](std::string_view piece) { return recording.feed(piece); }));
        return recording.take_log();
    }
    auto const format = guess_file_format(path).value_or(LogFormat::TractusLog);
    if (format == LogFormat::TractusLog)
        return read_log_file(path);
    std::ifstream in(path, std::ios::binary);
    return parse_foreign_log(format, in, path.string());
}

Result<Log> read_log(std::filesystem::path const& path)
{
    auto log = TRY(read_as_recorded(path));
    lend_descriptors(log);
    return log;
}

} // namespace tractus::drivers
