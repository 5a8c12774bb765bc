#pragma once

#include "drivers/reports/report_source.h"

#include <cstdint>
#include <memory>

namespace tractus::drivers {

// Reads a source on a thread of its own, so that a report's time is when it came and not when
// somebody had time for it. Reports wait in a ring of kRingReports until they are read.
//
// Everything here is called from the thread that started it.
class ThreadedSource final : public ReportSource {
public:
    static constexpr std::size_t kRingReports = 2048; // Two seconds of a fast tablet.

    // Takes the source over and starts reading. Fails, as the station's fault, if the system gives
    // no thread.
    static Result<std::unique_ptr<ThreadedSource>> start(std::unique_ptr<ReportSource> source);

    // Stops reading, within some 50 ms, and forgets what was not read.
    ~ThreadedSource() override;

    DeviceInfo const& info() const override;

    // The oldest report that waits. When the source has failed, its error comes after the last
    // report.
    Result<std::optional<RawReport>> read(Duration timeout) override;

    // How many reports were dropped, since the start, because the ring was full or they were longer
    // than a RawReport holds.
    std::uint64_t lost_count() const;

private:
    struct Shared;
    explicit ThreadedSource(std::unique_ptr<Shared>);

    std::unique_ptr<Shared> shared_;
};

} // namespace tractus::drivers
