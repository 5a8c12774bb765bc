#include "app/commands/derive.h"

#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/options/checks.h"
#include "app/options/model_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/rewriting/homomorphism.h"

#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace tractus::commands {

namespace {

struct DeriveArguments {
    options::ModelOptions model;
    document::ModelCost cost;
    io::ModelCompanions companions;
    bool homomorphism = false;
    bool counts = false;
    bool string = false;
};

Result<void> run(DeriveArguments const& arguments)
{
    auto const path = TRY(files::find_model(arguments.model.model));
    auto const model = TRY(io::load_model(path, arguments.companions));
    for (auto const& warning : model.warnings)
        terminal::print_warning(warning);
    io::warn_of_unused_companions(path, arguments.companions);
    auto const options = options::derive_options(arguments.model, arguments.cost);
    auto string = TRY(lsystem::derive(model, options));
    if (arguments.homomorphism) {
        lsystem::HomomorphismOptions how;
        how.limit = { options.limits.max_modules, options.limits.max_memory_bytes };
        how.time = options.limits.time;
        how.print = options.print;
        string = TRY(lsystem::apply_homomorphism(model, string, how));
    }
    if (arguments.counts)
        return terminal::print_out(nlohmann::json(lsystem::count_symbols(model, string)).dump()
                                   + "\n");
    return terminal::print_out(lsystem::to_string(model, string) + "\n");
}

} // namespace

void add_derive_command(CLI::App& root, options::Action& action)
{
    // Shared with the command's action, which runs after this function has returned.
    auto const arguments = std::make_shared<DeriveArguments>();
    auto* const command = root.add_subcommand(
        "derive", "Derive an L-system and print its string or its symbols' counts");
    command->footer(
        "A model is in cpfg's language; MODEL.v beside MODEL.l, where there is one, gives\n"
        "angles, materials and organs. The same model and seed always give the same string.");
    options::add_model_options(*command, arguments->model);
    options::add_cost_options(*command, arguments->cost);
    options::add_companion_options(*command, arguments->companions);
    command->add_flag("--homomorphism", arguments->homomorphism,
                      "Apply the homomorphism rules first: what the turtle reads");
    auto* const counts
        = command->add_flag("--count", arguments->counts,
                            "Print how often each symbol stands in the string, as a JSON object");
    command->add_flag("--string", arguments->string, "Print the string as cpfg does, on one line")
        ->excludes(counts);
    command->callback([&action, arguments] {
        if (!arguments->counts && !arguments->string)
            throw CLI::RequiredError("--count or --string");
        action = [arguments] { return run(*arguments); };
    });
}

} // namespace tractus::commands
