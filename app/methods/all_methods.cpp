#include "app/methods/all_methods.h"

#include "app/methods/construction_lines/construction_curves.h"
#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/layer_nodes_tool.h"
#include "app/methods/construction_lines/layer_organs_tool.h"
#include "app/methods/construction_lines/line_layers.h"
#include "app/methods/construction_lines/line_organ_tool.h"
#include "app/methods/construction_lines/line_pattern_tool.h"
#include "app/methods/construction_lines/line_role_tool.h"
#include "app/methods/construction_lines/line_tool.h"
#include "app/methods/fill_crown_tool.h"
#include "app/methods/indicators/delete_indicator_tool.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/methods/indicators/indicator_curves.h"
#include "app/methods/indicators/indicator_layer.h"
#include "app/methods/indicators/move_indicator_tool.h"
#include "app/methods/indicators/turn_indicator_tool.h"
#include "app/methods/leaves/erase_leaf_tool.h"
#include "app/methods/leaves/leaf_layers.h"
#include "app/methods/leaves/leaf_line_tool.h"
#include "app/methods/leaves/leaf_sketch_curves.h"
#include "app/methods/pictures/picture_tool.h"
#include "app/methods/plants/choose_plant_tool.h"
#include "app/methods/plants/copy_plant_tool.h"
#include "app/methods/plants/graft_plant_tool.h"
#include "app/methods/plants/hide_branch_tool.h"
#include "app/methods/plants/hide_plant_tool.h"
#include "app/methods/plants/move_plant_tool.h"
#include "app/methods/plants/remove_plant_tool.h"
#include "app/methods/plants/take_off_tool.h"
#include "app/methods/self_organising/growth_brush_curves.h"
#include "app/methods/self_organising/growth_brush_tool.h"
#include "app/methods/self_organising/prune_tool.h"
#include "app/methods/silhouettes/arrange_tool.h"
#include "app/methods/silhouettes/crown_tool.h"
#include "app/methods/silhouettes/erase_crown_tool.h"
#include "app/methods/silhouettes/erase_outline_tool.h"
#include "app/methods/silhouettes/outline_curves.h"
#include "app/methods/silhouettes/outline_layer.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "app/methods/sketch_lsystem/shorten_sketch_tool.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/methods/sketch_lsystem/sketched_curves.h"
#include "app/session/begin_empty.h"
#include "app/tools/delete_tool.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/limb_tool.h"
#include "app/tools/oversketch_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/smooth_tool.h"
#include "app/tools/turn_stroke_tool.h"
#include "app/tools/underground.h"
#include "engine/methods/construction_lines/bring_organ.h"
#include "engine/methods/construction_lines/erase_line.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/scene/edit.h"

#include <array>
#include <vector>

namespace tractus::methods {

namespace {

// All tools in the order of their buttons. The first one is selected at the start.
constexpr std::array kTools {
    &tools::DrawInOrderTool::kKind,
    &tools::DrawTool::kKind,
    &tools::LimbTool::kKind,
    &tools::OversketchTool::kKind,
    &tools::SmoothTool::kKind,
    &tools::TurnStrokeTool::kKind,
    &tools::DeleteTool::kKind,
    &tools::SelectTool::kKind,
    &indicators::IndicateTool::kKind,
    &indicators::MoveIndicatorTool::kKind,
    &indicators::TurnIndicatorTool::kKind,
    &indicators::DeleteIndicatorTool::kKind,
    &tools::EraseTool::kKind,
    &sketch::SketchTool::kKind,
    &sketch::ShortenSketchTool::kKind,
    &silhouette::OutlineTool::kKind,
    &silhouette::CrownTool::kKind,
    &silhouette::EraseCrownTool::kKind,
    &silhouette::ArrangeTool::kKind,
    &silhouette::EraseOutlineTool::kKind,
    &self_organising::GrowthBrushTool::kKind,
    &self_organising::PruneTool::kKind,
    &FillCrownTool::kKind,
    &lines::LineTool::kKind,
    &lines::LinePatternTool::kKind,
    &lines::LayerNodesTool::kKind,
    &lines::LineRoleTool::kKind,
    &lines::LineOrganTool::kKind,
    &lines::LayerOrgansTool::kKind,
    &lines::EraseLineTool::kKind,
    &leaf::LeafLineTool::kKind,
    &leaf::EraseLeafTool::kKind,
    &plants::ChoosePlantTool::kKind,
    &plants::MovePlantTool::kKind,
    &plants::CopyPlantTool::kKind,
    &plants::HidePlantTool::kKind,
    &plants::RemovePlantTool::kKind,
    &plants::GraftPlantTool::kKind,
    &plants::TakeOffTool::kKind,
    &plants::HideBranchTool::kKind,
    &pictures::PictureTool::kKind,
};

constexpr std::array kLayers {
    &silhouette::kTrianglesLayer,   &silhouette::kSeenLayer,      &silhouette::kOutlineLayer,
    &silhouette::kTrunkLayer,       &lines::kStemLayer,           &lines::kBoundaryLayer,
    &lines::kInclinationLayer,      &lines::kOtherStemLayer,      &lines::kOtherBoundaryLayer,
    &lines::kOtherInclinationLayer, &lines::kUnsureLayer,         &lines::kOrganLayer,
    &lines::kLinesToDrawLayer,      &leaf::kLeafOutlineLayer,     &leaf::kLeafVeinLayer,
    &leaf::kLeafOtherLayer,         &indicators::kIndicatorLayer, &tools::kUndergroundLayer
};

constexpr std::array<tools::ListDrawnCurves, 6> kCurves {
    sketch::sketched_curves,  silhouette::outline_curves,           lines::construction_curves,
    leaf::leaf_sketch_curves, self_organising::growth_brush_curves, indicators::indicator_curves,
};

std::vector<scene::EditKind const*> edit_kinds()
{
    auto const core = scene::core_edit_kinds();
    std::vector<scene::EditKind const*> all(core.begin(), core.end());
    all.push_back(&session::BeginEmpty::kKind);
    all.insert(all.end(),
               { &sketch::GrowAlongStroke::kKind, &sketch::ChangeSketch::kKind,
                 &sketch::ShortenSketch::kKind, &sketch::RedrawSketch::kKind });
    all.push_back(&silhouette::DrawTree::kKind);
    all.push_back(&silhouette::EraseTreePart::kKind);
    all.push_back(&silhouette::DeclareLeaf::kKind);
    all.push_back(&silhouette::ChooseStyles::kKind);
    all.push_back(&silhouette::FormTree::kKind);
    all.insert(all.end(),
               { &lines::AddLine::kKind, &lines::SetLayerNodes::kKind,
                 &lines::SetLinePattern::kKind, &lines::SetLineRole::kKind,
                 &lines::RedrawLine::kKind, &lines::BendStem::kKind, &lines::TurnLine::kKind,
                 &lines::DrawOrgan::kKind, &lines::SetLayerOrgan::kKind, &lines::EraseLine::kKind,
                 &lines::BringOrgan::kKind, &lines::PaintOrgan::kKind });
    all.insert(all.end(),
               { &leaf::AddLeafLine::kKind, &leaf::EraseLeafLine::kKind, &leaf::FormLeaf::kKind });
    all.insert(all.end(),
               { &self_organising::PlantTree::kKind, &self_organising::GrowOn::kKind,
                 &self_organising::GrowFrom::kKind, &self_organising::ChangeHabit::kKind,
                 &self_organising::GrowStand::kKind, &self_organising::TurnBrushStroke::kKind });
    return all;
}

} // namespace

tools::Methods all_methods()
{
    static auto const edits = edit_kinds();
    return { .edits = edits, .tools = kTools, .layers = kLayers, .curves = kCurves };
}

} // namespace tractus::methods
