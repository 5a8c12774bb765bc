#pragma once

#include "drivers/reports/report_source.h"

#include <cstdint>
#include <memory>

namespace tractus::drivers {

// Reads a source on its own thread, so that reports are stamped on arrival and not only when the
// program reads them. Unread reports wait in a ring of kRingReports.
//
// All functions must be called from the thread that called start().
class ThreadedSource final : public ReportSource {
public:
    // Size of the ring: two seconds of a fast tablet's reports.
    static constexpr std::size_t kRingReports = 2048;

    // Takes ownership of the source and starts reading. Fails with a station error if no thread can
    // be created.
    static Result<std::unique_ptr<ThreadedSource>> start(std::unique_ptr<ReportSource> source);

    // Stops reading within about 50 ms and discards unread reports.
    ~ThreadedSource() override;

    DeviceInfo const& info() const override;

    // Returns the oldest waiting report. After a failure of the source, its error follows the last
    // report.
    Result<std::optional<RawReport>> read(Duration timeout) override;

    // Number of reports dropped since the start because the ring was full or they were longer than
    // a RawReport.
    std::uint64_t lost_count() const;

private:
    struct Shared;
    explicit ThreadedSource(std::unique_ptr<Shared>);

    std::unique_ptr<Shared> shared_;
};

} // namespace tractus::drivers
