#pragma once

#include "drivers/log_writer.h"
#include "drivers/report_source.h"

#include <cstddef>
#include <memory>

namespace tractus {

// The same source, with each report that it hands out also written to a log, as device `device` of
// the log's header. It lives where the log is written: around a threaded source, not within one.
// The writer must outlive it; what its stream could not take is told by LogWriter::flush().
std::unique_ptr<ReportSource> record_to(LogWriter& log, std::size_t device,
                                        std::unique_ptr<ReportSource> source);

} // namespace tractus
