#pragma once

#include "app/tools/skeleton_line.h"
#include "app/tools/tool.h"
#include "engine/base/newest_job.h"
#include "engine/scene/paper.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::view {

// A stroke in progress.
struct StrokeInProgress {
    // Scene on which the stroke is drawn. Immutable and shared.
    std::shared_ptr<scene::Scene const> scene;
    tools::Tool tool {};
    std::vector<TipSample> ink {};
    std::uint32_t orders = 0; // Branching order below which branches are considered.
    std::size_t number = 0;   // Number of strokes finished before this one.
};

// The effect that a stroke in progress would have if it ended now.
struct StrokePreview {
    // The previewed branches; null if there is no preview. Immutable; shared by equal previews.
    std::shared_ptr<std::vector<tools::SkeletonLine> const> lines {};
    std::string note {};                  // See tools::StrokePreviewer::note().
    std::optional<scene::Paper> paper {}; // See tools::StrokePreviewer::paper().
    std::size_t stroke = 0;               // StrokeInProgress::number.
};

// The scene after a stroke in progress that makes its first plant.
struct FirstPlant {
    // Null if the stroke makes no plant. Immutable; shared with the thread that grows the plant.
    std::shared_ptr<scene::Scene const> scene;
    std::size_t stroke = 0; // StrokeInProgress::number.
};

// Previews strokes in progress in the background (NewestJob), as often as that can be computed.
class StrokePreviews {
public:
    // Requests the preview of a stroke and, if the scene has no plant, its first plant. Tools
    // without a previewer give neither.
    void want(StrokeInProgress const& stroke);

    // Return what was finished since the last call.
    std::optional<StrokePreview> take() { return preview_.take(); }
    std::optional<FirstPlant> take_first_plant() { return first_plant_.take(); }

    // Waits until everything requested is finished.
    void settle();

private:
    // Previews strokes. Previewers cache data between strokes, so the previewer is reused as long
    // as the tool's kind stays the same.
    class Previewer;

    NewestJob<StrokeInProgress, StrokePreview> preview_ { previewer() };
    NewestJob<StrokeInProgress, FirstPlant> first_plant_ { first_plant_of, Urgency::Later };

    static std::function<StrokePreview(StrokeInProgress const&)> previewer();
    static FirstPlant first_plant_of(StrokeInProgress const& stroke);
};

} // namespace tractus::view
