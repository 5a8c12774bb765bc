#include "app/verbs/lsystem.h"

#include "app/plants/model_file.h"
#include "app/resources.h"
#include "app/terminal/console.h"
#include "app/verbs/checks.h"
#include "app/verbs/model_options.h"
#include "engine/lsystem/derive.h"
#include "engine/lsystem/features.h"
#include "engine/lsystem/interpret.h"

#include <fmt/format.h>
#include <memory>

namespace tractus {

namespace {

struct LsystemArguments {
    ModelOptions model;
    ModelCost cost;
};

std::string features_text(Model const& model)
{
    std::string text = fmt::format("{}: understood\n\nUses\n", model.name);
    for (auto const& feature : features_used(model))
        text += fmt::format("  {}\n", feature);
    return text;
}

// What the turtle leaves out is known only once it has drawn.
Result<std::string> drawing_text(Model const& model, ModuleString const& string,
                                 LoadOptions const& run)
{
    auto const drawn = TRY(
        interpret_with_warnings(model, string, { .time = run.limits.time, .print = run.print }));
    auto const& plant = drawn.plant;
    std::string text = fmt::format("\nDraws {} segments on {} axes, {} organs, {} polygons\n",
                                   plant.segment_count(), plant.axes.size(), plant.organs.size(),
                                   plant.polygons.size());
    auto warnings = model.warnings;
    warnings.insert(warnings.end(), drawn.warnings.begin(), drawn.warnings.end());
    text += warnings.empty() ? "\nNo warnings\n" : "\nWarnings\n";
    for (auto const& warning : warnings)
        text += fmt::format("  {}\n", warning);
    return text;
}

Result<void> check(LsystemArguments const& arguments)
{
    auto const path = TRY(find_model(arguments.model.model));
    auto const model = TRY(load_model(path));
    TRY(print_out(features_text(model) + "\nStep      modules   parameters\n"));
    DeriveOptions options;
    options.steps = arguments.model.steps;
    options.seed = arguments.model.seed.value_or(1);
    auto const run = load_options(arguments.cost);
    options.limits = run.limits;
    options.print = run.print;
    Result<void> printed;
    options.on_step = [&](int step, ModuleString const& string) {
        if (printed)
            printed = print_out(
                fmt::format("{:4} {:12} {:12}\n", step, string.size(), string.parameters.size()));
    };
    auto const string = TRY(derive(model, options));
    TRY(std::move(printed));
    auto const drawing = TRY(drawing_text(model, string, run));
    return print_out(drawing);
}

} // namespace

void add_lsystem_verb(CLI::App& root, Action& action)
{
    auto* const verb = root.add_subcommand("lsystem", "Check an L-system");
    verb->require_subcommand(1);
    auto* const check_verb = verb->add_subcommand(
        "check", "List what a model uses, its warnings, and the modules after each step");
    // Shared with the callback, which outlives this.
    auto const arguments = std::make_shared<LsystemArguments>();
    add_model_options(*check_verb, arguments->model);
    add_cost_options(*check_verb, arguments->cost);
    check_verb->callback(
        [&action, arguments] { action = [arguments] { return check(*arguments); }; });
}

} // namespace tractus
