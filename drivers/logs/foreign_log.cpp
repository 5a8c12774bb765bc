#include "drivers/logs/foreign_log.h"

#include "engine/base/file.h"

#include <fstream>
#include <sstream>
#include <string>

namespace tractus::drivers {

LogFormat guess_log_format(std::string_view text)
{
    constexpr int kLines = 20;
    for (int i = 0; i < kLines && !text.empty(); ++i) {
        auto const end = text.find('\n');
        auto const line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (begins_usbhid_dump_block(line))
            return LogFormat::UsbhidDump;
        if (line.starts_with("ndevices:") || line.starts_with("libinput:"))
            return LogFormat::LibinputRecord;
    }
    return LogFormat::TractusLog;
}

static Result<Log> parse_foreign_log(LogFormat format, std::istream& in, std::string_view name)
{
    return format == LogFormat::UsbhidDump ? parse_usbhid_dump(in, name)
                                           : parse_libinput_record(in, name);
}

// Keeps a log that cannot be read again while its format is guessed.
static Result<Log> read_piped_log(std::filesystem::path const& path)
{
    auto const text = TRY(read_text_file(path, kMostPipedLogBytes));
    auto const format = guess_log_format(text);
    if (format == LogFormat::TractusLog)
        return parse_log(text, path.string());
    std::istringstream in(text);
    return parse_foreign_log(format, in, path.string());
}

Result<Log> read_any_log(std::filesystem::path const& path)
{
    if (std::error_code no_file; !std::filesystem::is_regular_file(path, no_file))
        return read_piped_log(path);
    std::ifstream in(path, std::ios::binary);
    std::string begin(std::size_t { 1 } << 16, '\0');
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    auto const format = guess_log_format(begin);
    if (format == LogFormat::TractusLog)
        return read_log(path);
    in.clear();
    in.seekg(0);
    return parse_foreign_log(format, in, path.string());
}

} // namespace tractus::drivers
