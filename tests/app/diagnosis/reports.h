#pragma once

#include "drivers/reports/report_source.h"
#include "tests/drivers/bytes.h"

#include <algorithm>
#include <string>

namespace tractus::diagnosis {

inline drivers::RawReport report_at_ms(std::int64_t milliseconds, std::string const& hex)
{
    auto const content = drivers::bytes(hex);
    drivers::RawReport report { .received = timestamp_ns(milliseconds * 1'000'000),
                                .size = content.size() };
    std::copy(content.begin(), content.end(), report.storage.begin());
    return report;
}

// A report of simple_pen() that touches at 100 mm from the left edge and 50 mm from the far edge.
constexpr char const* kTouching = "02 21 10 27 88 13 00 04 00 00";

} // namespace tractus::diagnosis
