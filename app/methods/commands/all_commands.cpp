#include "app/methods/commands/all_commands.h"

#include "app/methods/construction_lines/commands/construct_command.h"
#include "app/methods/leaves/commands/leaves_command.h"
#include "app/methods/silhouettes/commands/silhouette_command.h"
#include "app/methods/sketch_lsystem/commands/sketch_command.h"

#include <array>

namespace tractus {

Methods with_commands(Methods methods)
{
    static constexpr std::array<AddCommand, 4> kCommands {
        add_sketch_command,
        add_construct_command,
        add_silhouette_command,
        add_leaves_command,
    };
    methods.commands = kCommands;
    return methods;
}

} // namespace tractus
