#pragma once

#include "drivers/reports/pen_decoder.h"

#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <vector>

namespace tractus::drivers {

// Returns the sample of a report that can contain only one; no value if the report is not about a
// pen.
inline Result<std::optional<PenSample>> decode_one(PenDecoder& decoder, Timestamp received,
                                                   std::span<std::byte const> report)
{
    std::vector<PenSample> samples;
    TRY(decoder.decode(received, report, samples));
    EXPECT_LE(samples.size(), 1u);
    return samples.empty() ? std::nullopt : std::optional(samples.back());
}

} // namespace tractus::drivers
