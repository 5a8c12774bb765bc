#include "app/station/pressing.h"

namespace tractus::station {

namespace {

struct Pressing { };

Result<std::vector<scene::Edit>> press(tools::Tool const&, Stroke const&, scene::Scene const&)
{
    return std::vector<scene::Edit> {};
}

constexpr tools::ToolKind kPressing { .word = "press",
                                      .label = "",
                                      .title = "Press",
                                      .done = "",
                                      .help = "",
                                      .group = "",
                                      .options = tools::options_type<Pressing>(),
                                      .edits_for = press };

} // namespace

tools::Tool const& pressing()
{
    static tools::Tool const tool(kPressing);
    return tool;
}

} // namespace tractus::station
