#include "drivers/logs/log.h"
#include "drivers/logs/log_remainder.h"

#include <cerrno>
#include <cstring>
#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

// Reads the reports that are not in memory, one piece of the file at a time.
class LogCursor::Rest {
public:
    Rest(std::string_view name, LogRemainder const& rest)
        : rest_(rest)
        , text_(name, rest.place)
        , offset_(rest.place.offset)
    {
    }

    // Returns the next record; null after the last one.
    Result<LogRecord const*> peek()
    {
        while (next_ == text_.log().records.size() && !has_ended_)
            TRY(read_piece());
        return next_ < text_.log().records.size() ? &text_.log().records[next_] : nullptr;
    }
    void skip() { ++next_; }
    std::span<std::byte const> bytes_of(LogRecord const& record) const
    {
        return text_.log().report(record);
    }

private:
    Result<void> read_piece()
    {
        text_.forget_records();
        next_ = 0;
        auto const size
            = ::pread(rest_.file, piece_.data(), piece_.size(), static_cast<off_t>(offset_));
        if (size < 0)
            return fail(
                Fault::User,
                fmt::format("cannot read {} again: {}", text_.log().name, std::strerror(errno)));
        offset_ += static_cast<std::uint64_t>(size);
        has_ended_ = size == 0;
        return has_ended_
            ? text_.end()
            : text_.feed(std::string_view(piece_).substr(0, static_cast<std::size_t>(size)));
    }

    LogRemainder const& rest_;
    LogText text_;
    std::uint64_t offset_;
    std::size_t next_ = 0; // Index of the next record in the text's log.
    bool has_ended_ = false;
    std::string piece_ = std::string(std::size_t { 1 } << 16, '\0');
};

LogCursor::LogCursor(Log const& log)
    : log_(&log)
{
}

LogCursor::LogCursor(LogCursor&&) noexcept = default;
LogCursor& LogCursor::operator=(LogCursor&&) noexcept = default;
LogCursor::~LogCursor() = default;

Result<LogReport const*> LogCursor::peek()
{
    auto const show = [this](LogRecord const& record, std::span<std::byte const> bytes) {
        report_ = { record.time, record.device, bytes };
        return &report_;
    };
    if (position_ < log_->records.size())
        return show(log_->records[position_], log_->report(log_->records[position_]));
    if (!log_->rest)
        return nullptr;
    if (!rest_)
        rest_ = std::make_unique<Rest>(log_->name, *log_->rest);
    auto const* const record = TRY(rest_->peek());
    if ((record != nullptr) != (position_ < log_->record_count()))
        return fail(Fault::User,
                    fmt::format("{} has changed while it was read: read it again", log_->name));
    return record ? show(*record, rest_->bytes_of(*record)) : nullptr;
}

void LogCursor::skip()
{
    ++position_;
    if (rest_)
        rest_->skip();
}

Result<LogReport const*> LogCursor::next()
{
    auto const* const report = TRY(peek());
    if (report)
        skip();
    return report;
}

} // namespace tractus::drivers
