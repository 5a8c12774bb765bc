#include "app/verbs/derive.h"

#include "app/plants/model_file.h"
#include "app/resources.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/verbs/checks.h"
#include "app/verbs/model_options.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/rewriting/homomorphism.h"

#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace tractus {

namespace {

struct DeriveArguments {
    ModelOptions model;
    ModelCost cost;
    ModelCompanions companions;
    bool homomorphism = false;
    bool counts = false;
    bool string = false;
};

Result<void> run(DeriveArguments const& arguments)
{
    auto const path = TRY(find_model(arguments.model.model));
    warn_of_unused_companions(path, arguments.companions);
    auto const model = TRY(load_model(path, arguments.companions));
    for (auto const& warning : model.warnings)
        print_warning(warning);
    DeriveOptions options;
    options.steps = arguments.model.steps;
    options.seed = arguments.model.seed.value_or(1);
    auto const run = load_options(arguments.cost);
    options.limits = run.limits;
    options.print = run.print;
    auto string = TRY(derive(model, options));
    if (arguments.homomorphism) {
        HomomorphismOptions how;
        how.limit = { run.limits.max_modules, run.limits.max_memory_bytes };
        how.time = run.limits.time;
        how.print = run.print;
        string = TRY(apply_homomorphism(model, string, how));
    }
    if (arguments.counts)
        return print_out(nlohmann::json(count_symbols(model, string)).dump() + "\n");
    return print_out(to_string(model, string) + "\n");
}

} // namespace

void add_derive_verb(CLI::App& root, Action& action)
{
    // Shared with the callback, which outlives this.
    auto const arguments = std::make_shared<DeriveArguments>();
    auto* const verb = root.add_subcommand(
        "derive", "Derive an L-system and print its string or its symbols' counts");
    verb->footer(
        "A model is in cpfg's language; MODEL.v beside MODEL.l, where there is one, gives\n"
        "angles, materials and organs. The same model and seed always give the same string.");
    add_model_options(*verb, arguments->model);
    add_cost_options(*verb, arguments->cost);
    add_companion_options(*verb, arguments->companions);
    verb->add_flag("--homomorphism", arguments->homomorphism,
                   "Apply the homomorphism rules first: what the turtle reads");
    auto* const counts
        = verb->add_flag("--count", arguments->counts,
                         "Print how often each symbol stands in the string, as a JSON object");
    verb->add_flag("--string", arguments->string, "Print the string as cpfg does, on one line")
        ->excludes(counts);
    verb->callback([&action, arguments] {
        if (!arguments->counts && !arguments->string)
            throw CLI::RequiredError("--count or --string");
        action = [arguments] { return run(*arguments); };
    });
}

} // namespace tractus
