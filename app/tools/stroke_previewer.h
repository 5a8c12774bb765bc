#pragma once

#include "app/tools/skeleton_line.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tractus::tools {

class Tool;

// A stroke under way, and what it is drawn on.
struct UnfinishedStroke {
    std::shared_ptr<scene::Scene const> scene; // Shared with whoever shows it; nobody changes it.
    Tool const& tool;
    std::span<TipSample const> ink;
    std::uint32_t orders = 0; // Only branches of lower orders than this are looked at.
};

// Shows what a stroke would do if it ended now. It may keep what it needs again for the next tips.
class StrokePreviewer {
public:
    virtual ~StrokePreviewer() = default;

    // None for a stroke that would be refused.
    virtual std::vector<SkeletonLine> show(UnfinishedStroke const& stroke) = 0;

    // A sentence about what was shown last: what it leaves out, say. Empty: there is nothing to
    // say.
    virtual std::string note() const { return {}; }
};

} // namespace tractus::tools
