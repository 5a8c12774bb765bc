#include "app/methods/commands/all_checks.h"

#include "app/methods/sketch_lsystem/commands/model_rule_file.h"

#include <array>

namespace tractus::methods {

std::string describe_uses(std::filesystem::path const& model, scene::LoadOptions const& options)
{
    static constexpr std::array kDescribe { sketch::describe_contract };
    std::string text;
    for (auto const describe : kDescribe)
        text += describe(model, options);
    return text;
}

} // namespace tractus::methods
