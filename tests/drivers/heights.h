#pragma once

#include "drivers/reports/height_decoder.h"

#include <vector>

namespace tractus::drivers {

// Decodes a single report.
inline Result<std::vector<HeightSample>> decode_heights(HeightDecoder& decoder, Timestamp received,
                                                        std::span<std::byte const> report)
{
    std::vector<HeightSample> samples;
    TRY(decoder.decode(received, report, samples));
    return samples;
}

inline Result<std::vector<HeightSample>> decode_heights(HeightDecoder& decoder,
                                                        RawReport const& report)
{
    return decode_heights(decoder, report.received, report.bytes());
}

} // namespace tractus::drivers
