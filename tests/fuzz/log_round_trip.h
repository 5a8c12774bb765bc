#pragma once

#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "engine/base/check.h"

#include <algorithm>
#include <sstream>

namespace tractus {

// Checks that a log is equal after it was written and read again.
inline void check_log_round_trip(drivers::Log const& log)
{
    std::ostringstream text;
    drivers::LogWriter writer(text, { .devices = log.devices, .rig_text = log.rig_text });
    for (auto const& record : log.records)
        writer.write_report(record.device, record.time, log.report(record));
    auto const again = drivers::parse_log(text.str(), "again");
    CHECK(again);
    CHECK(again->records.size() == log.records.size());
    for (std::size_t i = 0; i < log.records.size(); ++i)
        CHECK(std::ranges::equal(again->report(again->records[i]), log.report(log.records[i])));
    CHECK(again->devices.size() == log.devices.size());
    CHECK(again->rig_text == log.rig_text);
}

} // namespace tractus
