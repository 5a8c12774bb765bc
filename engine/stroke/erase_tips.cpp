#include "engine/stroke/erase_tips.h"

#include "engine/stroke/polyline.h"

#include <fmt/format.h>
#include <utility>
#include <vector>

namespace tractus {

static Result<void> check_ranges(std::size_t tip_count, std::span<TipRange const> ranges)
{
    if (ranges.empty())
        return fail(Fault::User, "no tips are given that should be erased: give at least one");
    std::size_t free_from = 0; // Index of the first tip after the previous range.
    for (auto const& [first, last] : ranges) {
        if (first < free_from || last < first || last >= tip_count)
            return fail(Fault::User,
                        fmt::format("tips {} to {} cannot be erased: give ranges in order that "
                                    "share none of the stroke's {} tips",
                                    first + 1, last + 1, tip_count));
        free_from = last + 1;
    }
    return {};
}

Result<Stroke> erase_tips(Stroke const& drawn, std::span<TipRange const> ranges)
{
    auto const& tips = drawn.tips.vector();
    TRY(check_ranges(tips.size(), ranges));
    std::vector<TipSample> kept;
    kept.reserve(tips.size());
    std::size_t from = 0;
    auto const keep_until = [&](std::size_t end) {
        kept.insert(kept.end(), tips.begin() + static_cast<std::ptrdiff_t>(from),
                    tips.begin() + static_cast<std::ptrdiff_t>(end));
    };
    for (auto const& [first, last] : ranges) {
        keep_until(first);
        from = last + 1;
    }
    keep_until(tips.size());
    Stroke rest { std::move(kept) };
    TRY(stroke_points(rest));
    return rest;
}

} // namespace tractus
