#include "app/commands/command_line.h"
#include "app/methods/all_methods.h"
#include "app/methods/commands/all_commands.h"
#include "app/terminal/console.h"
#include "engine/base/file.h"
#include "engine/base/worker_threads.h"

int main(int argc, char** argv)
{
    tractus::terminal::prepare_console();
    tractus::remove_unfinished_file_on_signals();
    auto const methods = tractus::methods::with_commands(tractus::methods::all_methods());
    int const exit_code = tractus::commands::run_command_line(argc, argv, methods);
    tractus::end_worker_threads();
    return exit_code;
}
