#include "app/view/stroke_previews.h"

#include "app/tools/stroke_previewer.h"

#include <utility>

namespace tractus::view {

class StrokePreviews::Previewer {
public:
    StrokePreview show(StrokeInProgress const& stroke)
    {
        auto* const make = stroke.tool.kind().previewer;
        if (!make)
            return { .stroke = stroke.number };
        if (made_by_ != make) {
            previewer_ = make();
            made_by_ = make;
        }
        auto lines = previewer_->show({ stroke.scene, stroke.tool, stroke.ink, stroke.orders });
        if (lines.empty())
            last_.reset();
        else if (!last_ || *last_ != lines)
            last_ = std::make_shared<std::vector<tools::SkeletonLine> const>(std::move(lines));
        return { last_, previewer_->note(), previewer_->paper(), stroke.number };
    }

private:
    std::unique_ptr<tools::StrokePreviewer> (*made_by_)() = nullptr;
    std::unique_ptr<tools::StrokePreviewer> previewer_ {};
    std::shared_ptr<std::vector<tools::SkeletonLine> const> last_ {};
};

std::function<StrokePreview(StrokeInProgress const&)> StrokePreviews::previewer()
{
    // Held by shared_ptr, as std::function requires a function object that can be copied.
    return [previewer = std::make_shared<Previewer>()](StrokeInProgress const& stroke) {
        return previewer->show(stroke);
    };
}

FirstPlant StrokePreviews::first_plant_of(StrokeInProgress const& stroke)
{
    auto const edits = stroke.tool.edits_for({ stroke.ink }, *stroke.scene);
    if (!edits || edits->empty())
        return { nullptr, stroke.number };
    auto scene = scene::apply_edits(*stroke.scene, *edits);
    if (!scene || scene->plants.empty())
        return { nullptr, stroke.number };
    return { std::make_shared<scene::Scene const>(*std::move(scene)), stroke.number };
}

void StrokePreviews::want(StrokeInProgress const& stroke)
{
    if (stroke.tool.kind().previewer && stroke.scene->plants.empty())
        first_plant_.want(stroke);
    preview_.want(stroke);
}

void StrokePreviews::settle()
{
    preview_.settle();
    first_plant_.settle();
}

} // namespace tractus::view
