#include "app/methods/commands/all_commands.h"

#include "app/methods/construction_lines/commands/construct_command.h"
#include "app/methods/leaves/commands/leaves_command.h"
#include "app/methods/self_organising/commands/brush_command.h"
#include "app/methods/silhouettes/commands/silhouette_command.h"
#include "app/methods/sketch_lsystem/commands/sketch_command.h"

#include <array>

namespace tractus::methods {

tools::Methods with_commands(tools::Methods methods)
{
    static constexpr std::array<tools::AddCommand, 5> kCommands {
        sketch::add_sketch_command,         lines::add_construct_command,
        silhouette::add_silhouette_command, leaf::add_leaves_command,
        self_organising::add_brush_command,
    };
    methods.commands = kCommands;
    return methods;
}

} // namespace tractus::methods
