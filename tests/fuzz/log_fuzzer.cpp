// Fuzzes device logs. A log that can be read must be equal after it was written and read again.

#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "engine/base/check.h"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    auto const log = drivers::parse_log({ reinterpret_cast<char const*>(data), size }, "fuzz");
    if (!log)
        return 0;

    std::ostringstream text;
    drivers::LogWriter writer(text, { .devices = log->devices, .rig_text = log->rig_text });
    for (auto const& record : log->records)
        writer.write_report(record.device, record.time, log->report(record));
    auto const again = drivers::parse_log(text.str(), "again");
    CHECK(again);
    CHECK(again->records.size() == log->records.size());
    CHECK(again->bytes == log->bytes);
    CHECK(again->devices.size() == log->devices.size());
    CHECK(again->rig_text == log->rig_text);
    return 0;
}
