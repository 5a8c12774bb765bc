#include "app/methods/all_commands.h"

#include "app/methods/construction_lines/construct_command.h"
#include "app/methods/leaves/leaves_command.h"
#include "app/methods/silhouettes/silhouette_command.h"
#include "app/methods/sketch_lsystem/sketch_command.h"

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
