#include "app/command_line.h"
#include "app/terminal/console.h"
#include "drivers/file.h"

int main(int argc, char** argv)
{
    tractus::prepare_console();
    tractus::remove_unfinished_file_on_signals();
    return tractus::run_command_line(argc, argv);
}
