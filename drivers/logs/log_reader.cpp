#include "drivers/logs/log.h"

#include "drivers/logs/log_remainder.h"
#include "drivers/logs/log_text.h"
#include "engine/base/file.h"

#include <algorithm>
#include <fcntl.h>
#include <fmt/core.h>
#include <limits>

namespace tractus::drivers {

Result<Log> parse_log(std::string_view text, std::string_view name)
{
    if (text.size() > std::numeric_limits<std::uint32_t>::max())
        return fail(Fault::User, fmt::format("{} is larger than 4 GiB", name));
    LogText reader(name);
    reader.expect(text.size());
    TRY(reader.feed(text));
    TRY(reader.end());
    return reader.take_log();
}

Result<Log> read_log_file(std::filesystem::path const& path)
{
    // The file is opened before it is read, so that later reads get the same file even if its name
    // is reused.
    auto rest = std::make_shared<LogRemainder>(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    LogText text(path.string(), kMaxLogBytes);
    std::error_code no_file;
    text.expect(std::min<std::size_t>(std::filesystem::file_size(path, no_file), kMaxLogBytes * 2));
    TRY(read_file_in_pieces(path, std::numeric_limits<std::size_t>::max(),
                            [&](std::string_view piece) { return text.feed(piece); }));
    TRY(text.end());
    bool const is_in_memory = !text.rest();
    rest->place = text.rest().value_or(LogPlace {});
    rest->totals = text.totals();
    auto log = TRY(text.take_log());
    if (!is_in_memory)
        log.rest = std::move(rest);
    return log;
}

std::size_t Log::record_count() const
{
    return rest ? rest->totals.count : records.size();
}

Timestamp Log::begin() const
{
    return records.empty() ? Timestamp {} : records.front().time;
}

Timestamp Log::end() const
{
    if (rest)
        return rest->totals.end;
    return records.empty() ? Timestamp {} : records.back().time;
}

std::string summarize_warnings(Log const& log)
{
    if (log.warnings.empty())
        return {};
    auto const& first = log.warnings.front();
    if (log.warning_count == 1)
        return fmt::format("{}:{}: {}", log.name, first.line, first.message);
    return fmt::format("{}: {} odd lines, the first is line {}: {}", log.name, log.warning_count,
                       first.line, first.message);
}

} // namespace tractus::drivers
