#pragma once

#include "app/tools/skeleton_line.h"
#include "engine/scene/paper.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::tools {

class Tool;

// An unfinished stroke, and the scene on which it is drawn.
struct UnfinishedStroke {
    std::shared_ptr<scene::Scene const> scene; // Immutable; shared with the window.
    Tool const& tool;
    std::span<TipSample const> ink;
    std::uint32_t orders = 0; // Only branches of an order below this number are shown.
};

// Previews what a stroke would do if it ended now. It may cache data between calls.
class StrokePreviewer {
public:
    virtual ~StrokePreviewer() = default;

    // Lines of the preview; empty if the tool would refuse the stroke.
    virtual std::vector<SkeletonLine> show(UnfinishedStroke const& stroke) = 0;

    // A sentence for the user about the last preview, for example on what the preview leaves out;
    // may be empty.
    virtual std::string note() const { return {}; }

    // The paper on which the plant of the last preview stands. No value if the stroke is not read
    // as drawn on paper, or if there was no preview.
    virtual std::optional<scene::Paper> paper() const { return {}; }
};

} // namespace tractus::tools
