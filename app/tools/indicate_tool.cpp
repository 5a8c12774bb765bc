#include "app/tools/tool.h"

namespace tractus {

Result<std::vector<Edit>> indicate_edits(Stroke const& stroke)
{
    return std::vector<Edit> { Indicate { TRY(motion_indicator(stroke)) } };
}

} // namespace tractus
