#include "app/methods/all_methods.h"

#include "app/methods/indicators/delete_indicator_tool.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/methods/indicators/move_indicator_tool.h"
#include "app/tools/delete_tool.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/oversketch_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/smooth_tool.h"
#include "engine/scene/edit.h"

#include <array>

namespace tractus {

Methods all_methods()
{
    // In the order of their buttons; the first is in hand at first.
    static constexpr std::array kTools {
        &DrawInOrderTool::kKind, &DrawTool::kKind,          &OversketchTool::kKind,
        &SmoothTool::kKind,      &DeleteTool::kKind,        &SelectTool::kKind,
        &IndicateTool::kKind,    &MoveIndicatorTool::kKind, &DeleteIndicatorTool::kKind,
        &EraseTool::kKind,
    };
    return { .edits = core_edit_kinds(), .tools = kTools };
}

} // namespace tractus
