#include "app/methods/self_organising/commands/brush_command.h"

#include "app/methods/self_organising/case_file.h"
#include "app/terminal/console.h"

#include <filesystem>
#include <memory>

namespace tractus::self_organising {

namespace {

struct BrushArguments {
    std::filesystem::path example;
    bool report = false;
};

Result<void> brush(BrushArguments const& arguments)
{
    auto example = TRY(load_case(arguments.example));
    auto const laws = example.laws;
    auto const grown = TRY(grow_case(std::move(example)));
    return terminal::print_out(print_case_report(grown, laws));
}

} // namespace

void add_brush_command(CLI::App& root, options::Action& action, tools::Methods const&)
{
    auto arguments = std::make_shared<BrushArguments>();
    auto* const command = root.add_subcommand("brush", "Grow a tree into the volume of a brush");
    auto* const example
        = command->add_option("--case", arguments->example, "An example of the laws, a JSON file")
              ->type_name("CASE")
              ->required();
    command
        ->add_flag("--report", arguments->report,
                   "Print as JSON what each step did and the nodes of the tree")
        ->needs(example);
    command->callback([arguments, &action] { action = [arguments] { return brush(*arguments); }; });
}

} // namespace tractus::self_organising
