#include "app/options/model_options.h"

#include "app/options/checks.h"

namespace tractus::options {

void add_model_options(CLI::App& command, ModelOptions& options)
{
    command
        .add_option("MODEL", options.model,
                    "An L-system file (.l), or one of ours by its name: broadleaf, palm, …; "
                    "the manual shows them all")
        ->required();
    command
        .add_option("-n,--steps", options.steps, "Derivation steps; without it, the model's own")
        ->type_name("STEPS")
        ->check(whole_number(0, 1'000'000'000));
    command
        .add_option("--seed", options.seed,
                    "Of the model's stochastic rules: another seed, another plant; without it, 1")
        ->type_name("N")
        ->check(seed_number());
}

void add_companion_options(CLI::App& command, io::ModelCompanions& companions)
{
    command
        .add_option("--view", companions.view,
                    "The model's view; without it, MODEL.v beside MODEL.l")
        ->type_name("FILE")
        ->check(CLI::ExistingFile);
    command
        .add_option("--colors", companions.colors,
                    "The model's colours, .mat or .map; without it, those beside it")
        ->type_name("FILE")
        ->check(CLI::ExistingFile);
    command
        .add_option("--environment", companions.environment,
                    "What answers the model's ?E modules: light, space, terrain or water, and its "
                    "numbers, such as light:cell=2,shade=0.1; the manual names them")
        ->type_name("NAME[:KEY=NUMBER,...]");
    command
        .add_option("--dialect", companions.dialect,
                    "Notation of the rules: cpfg, or book, as The Algorithmic Beauty of Plants "
                    "prints them")
        ->type_name("DIALECT")
        ->check(one_of({ std::string(io::kCpfgDialect), std::string(io::kBookDialect) }))
        ->capture_default_str();
}

void add_cost_options(CLI::App& command, document::ModelCost& cost)
{
    command
        .add_option(
            "--max-modules", cost.max_modules,
            "Stop with an error when the model's string, or what is drawn of it, has more than "
            "this many modules")
        ->type_name("N")
        ->check(whole_number(1, 1'000'000'000))
        ->capture_default_str();
    command
        .add_option(
            "--max-memory", cost.max_memory_mb,
            "Stop with an error when its string, or what is drawn of it, needs more than this "
            "many megabytes; without it, half of what the machine has")
        ->type_name("MB")
        ->check(whole_number(1, 1'000'000'000));
    command
        .add_option("--max-seconds", cost.max_seconds,
                    "Stop with an error when the string is not done after so many seconds; 0 for "
                    "as long as it takes")
        ->type_name("SECONDS")
        ->check(number(0, 1e9))
        ->capture_default_str();
}

lsystem::DeriveOptions derive_options(ModelOptions const& model, document::ModelCost const& cost)
{
    lsystem::DeriveOptions options;
    options.steps = model.steps;
    options.seed = model.seed.value_or(1);
    auto const run = document::load_options(cost);
    options.limits = run.limits;
    options.print = run.print;
    return options;
}

} // namespace tractus::options
