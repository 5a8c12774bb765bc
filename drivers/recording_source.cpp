#include "drivers/recording_source.h"

namespace tractus {

namespace {

class RecordingSource final : public ReportSource {
public:
    RecordingSource(LogWriter& log, std::size_t device, std::unique_ptr<ReportSource> source)
        : log_(log)
        , device_(device)
        , source_(std::move(source))
    {
    }

    DeviceInfo const& info() const override { return source_->info(); }

    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        auto report = source_->read(timeout);
        if (report && *report)
            log_.write_report(device_, (*report)->received, (*report)->bytes());
        return report;
    }

private:
    LogWriter& log_;
    std::size_t device_;
    std::unique_ptr<ReportSource> source_;
};

} // namespace

std::unique_ptr<ReportSource> record_to(LogWriter& log, std::size_t device,
                                        std::unique_ptr<ReportSource> source)
{
    return std::make_unique<RecordingSource>(log, device, std::move(source));
}

} // namespace tractus
