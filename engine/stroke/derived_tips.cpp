#include "engine/stroke/derived_tips.h"

#include "engine/stroke/oversketch.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace tractus {

using Tips = SharedVector<TipSample>;

namespace {

class RedrawnStroke final : public ElementSource<TipSample> {
public:
    RedrawnStroke(Tips::Source drawn, Tips::Source over)
        : drawn_(std::move(drawn))
        , over_(std::move(over))
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        auto drawn = TRY(drawn_->read());
        auto over = TRY(over_->read());
        return TRY(oversketch({ std::move(drawn) }, { std::move(over) })).tips.vector();
    }

private:
    Tips::Source drawn_;
    Tips::Source over_;
};

class ErasedStroke final : public ElementSource<TipSample> {
public:
    ErasedStroke(Tips::Source drawn, std::vector<TipRange> ranges)
        : drawn_(std::move(drawn))
        , ranges_(std::move(ranges))
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        auto drawn = TRY(drawn_->read());
        return TRY(erase_tips({ std::move(drawn) }, ranges_)).tips.vector();
    }

private:
    Tips::Source drawn_;
    std::vector<TipRange> ranges_;
};

class ReversedStroke final : public ElementSource<TipSample> {
public:
    explicit ReversedStroke(Tips::Source drawn)
        : drawn_(std::move(drawn))
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        return reversed_tips(TRY(drawn_->read()));
    }

private:
    Tips::Source drawn_;
};

} // namespace

Tips::Source redrawn_source(Tips::Source drawn, Tips::Source over)
{
    if (!drawn || !over)
        return nullptr;
    return std::make_shared<RedrawnStroke>(std::move(drawn), std::move(over));
}

Tips::Source erased_source(Tips::Source drawn, std::vector<TipRange> ranges)
{
    if (!drawn)
        return nullptr;
    return std::make_shared<ErasedStroke>(std::move(drawn), std::move(ranges));
}

Tips::Source reversed_source(Tips::Source drawn)
{
    if (!drawn)
        return nullptr;
    return std::make_shared<ReversedStroke>(std::move(drawn));
}

std::vector<TipSample> reversed_tips(std::vector<TipSample> tips)
{
    std::reverse(tips.begin(), tips.end());
    for (std::size_t i = 0; i < tips.size() / 2; ++i)
        std::swap(tips[i].time, tips[tips.size() - 1 - i].time);
    return tips;
}

} // namespace tractus
