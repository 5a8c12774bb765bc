#include "app/verbs/derive.h"

#include "app/console.h"
#include "app/model_file.h"
#include "app/resources.h"
#include "app/verbs/checks.h"
#include "engine/lsystem/derive.h"
#include "engine/lsystem/print.h"

#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace tractus {

namespace {

struct Arguments {
    std::string model;
    int steps = -1;
    DeriveOptions options;
    bool counts = false;
    bool string = false;
};

Result<void> run(Arguments const& arguments)
{
    auto const path = TRY(find_model(arguments.model));
    auto const model = TRY(load_model(path));
    for (auto const& warning : model.warnings)
        print_error(fmt::format("warning: {}\n", warning));
    auto options = arguments.options;
    if (arguments.steps >= 0)
        options.steps = arguments.steps;
    auto const string = TRY(derive(model, options));
    if (arguments.counts)
        return print_out(nlohmann::json(count_symbols(model, string)).dump() + "\n");
    return print_out(to_string(model, string) + "\n");
}

} // namespace

void add_derive_verb(CLI::App& root, Action& action)
{
    // Shared with the callback, which outlives this.
    auto const arguments = std::make_shared<Arguments>();
    auto* const verb = root.add_subcommand(
        "derive", "Derive an L-system and print its string or its symbols' counts");
    verb->footer(
        "A model is in cpfg's language; MODEL.v beside MODEL.l, where there is one, gives\n"
        "angles, materials and organs. The same model and seed always give the same string.");
    verb->add_option("MODEL", arguments->model,
                     "An L-system file (.l), or one of our plants by its name, such as birch, "
                     "broadleaf, conifer, "
                     "daisy, fern, grass, leaf, magnolia, palm, poplar, shrub, sunflower or vine")
        ->required();
    verb->add_option("-n,--steps", arguments->steps,
                     "Derivation steps; without it, the model's own")
        ->type_name("STEPS")
        ->check(whole_number(0, 1'000'000'000));
    verb->add_option("--seed", arguments->options.seed,
                     "Of the model's stochastic rules: another seed, another string")
        ->type_name("N")
        ->check(seed_number())
        ->capture_default_str();
    verb->add_option("--max-modules", arguments->options.max_modules,
                     "Stop with an error beyond this many modules")
        ->type_name("N")
        ->check(whole_number(1, 1'000'000'000))
        ->capture_default_str();
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
