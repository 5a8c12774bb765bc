#include "engine/lsystem/fast_rewriting/block_scan.h"

#include "engine/base/check.h"
#include "engine/base/random_blocks.h"
#include "engine/lsystem/language/virtual_machine.h"

#include <algorithm>

namespace tractus::lsystem {

// Without branches, since processors could not predict which modules change.
void BlockScan::find(Kinds const& kinds, std::span<KindId const> modules)
{
    CHECK(modules.size() <= kMax);
    std::uint32_t parameter = 0;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < modules.size(); ++i) {
        auto const& kind = kinds[modules[i]];
        changes_[count] = { i, parameter };
        count += kind.changes;
        parameter += kind.parameter_count;
    }
    std::size_t drawing_count = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        drawing_[drawing_count] = i;
        drawing_count += kinds[modules[changes_[i].module]].draws;
    }
    count_ = count;
    drawing_count_ = drawing_count;
    parameter_count_ = parameter;
}

void BlockScan::draw(std::uint64_t seed, std::uint32_t step, std::size_t begin)
{
    auto const first = static_cast<std::uint32_t>(begin);
    RandomBlocks::Words indices {};
    for (std::size_t done = 0; done < drawing_count_; done += RandomBlocks::kCount) {
        auto const count = std::min(RandomBlocks::kCount, drawing_count_ - done);
        for (std::size_t i = 0; i < count; ++i)
            indices[i] = first + changes_[drawing_[done + i]].module;
        auto const blocks = random_blocks(seed, step, {}, indices);
        for (std::size_t i = 0; i < count; ++i)
            numbers_[drawing_[done + i]] = unit_number(blocks.words[0][i], blocks.words[1][i]);
    }
}

} // namespace tractus::lsystem
