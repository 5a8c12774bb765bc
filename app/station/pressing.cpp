#include "app/station/pressing.h"

namespace tractus::station {

namespace {

struct Pressing { };

Result<std::vector<Edit>> press(Tool const&, Stroke const&, Scene const&)
{
    return std::vector<Edit> {};
}

constexpr ToolKind kPressing { .word = "press",
                               .label = "",
                               .title = "Press",
                               .done = "",
                               .help = "",
                               .group = "",
                               .options = options_type<Pressing>(),
                               .mean = press };

} // namespace

Tool const& pressing()
{
    static Tool const tool(kPressing);
    return tool;
}

} // namespace tractus::station
