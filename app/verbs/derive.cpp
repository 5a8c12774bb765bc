#include "app/verbs/derive.h"

#include "app/model_file.h"
#include "engine/lsystem/derive.h"
#include "engine/lsystem/print.h"

#include <cstdio>
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

// Standard output may be a full disk or a closed pipe.
Result<void> print_line(std::string const& text)
{
    bool const written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size()
        && std::fputc('\n', stdout) != EOF && std::fflush(stdout) == 0;
    if (!written)
        return fail(Fault::User, "cannot write to standard output");
    return {};
}

Result<void> run(Arguments const& arguments)
{
    auto const model = TRY(load_model(arguments.model));
    for (auto const& warning : model.warnings)
        fmt::print(stderr, "warning: {}\n", warning);
    auto options = arguments.options;
    if (arguments.steps >= 0)
        options.steps = arguments.steps;
    auto const string = TRY(derive(model, options));
    if (arguments.counts)
        return print_line(nlohmann::json(count_symbols(model, string)).dump());
    return print_line(to_string(model, string));
}

} // namespace

void add_derive_verb(CLI::App& root, Action& action)
{
    auto const arguments
        = std::make_shared<Arguments>(); // Shared with the callback, which outlives this.
    auto* const verb = root.add_subcommand(
        "derive", "Derive an L-system and print its string or its symbols' counts");
    verb->footer(
        "MODEL.l is in cpfg's language; MODEL.v beside it, where there is one, gives angles,\n"
        "materials and organs. The same model and seed always give the same string.");
    verb->add_option("MODEL.l", arguments->model, "The model's rules")->required();
    verb->add_option("-n,--steps", arguments->steps,
                     "Derivation steps (default: the model's derivation length)")
        ->check(CLI::Range(0, 1'000'000'000));
    verb->add_option("--seed", arguments->options.seed, "Seed of stochastic rules")
        ->capture_default_str();
    verb->add_option("--max-modules", arguments->options.max_modules,
                     "Stop with an error beyond this many modules")
        ->capture_default_str();
    auto* const output = verb->add_option_group("output");
    output->add_flag("--count", arguments->counts,
                     "Print how often each symbol stands in the string, as a JSON object");
    output->add_flag("--string", arguments->string, "Print the string as cpfg does, on one line");
    output->require_option(1);
    verb->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

} // namespace tractus
