#include "engine/methods/sketch_lsystem/segment_lengths.h"

namespace tractus::sketch {

SegmentLengths lengths_of(Rule const& rule)
{
    return { { rule.first_length_mm }, rule.length_ratio, rule.shortest_mm, rule.most_segments };
}

double length_after(SegmentLengths const& lengths, std::size_t number, double length_mm)
{
    return number + 1 < lengths.first_mm.size() ? lengths.first_mm[number + 1]
                                                : length_mm * lengths.ratio;
}

} // namespace tractus::sketch
