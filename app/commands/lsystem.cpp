#include "app/commands/lsystem.h"

#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/commands/all_checks.h"
#include "app/options/checks.h"
#include "app/options/model_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"
#include "engine/base/printable.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/derivation/features.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/notations/book_text.h"
#include "engine/lsystem/notations/foreign_text.h"
#include "engine/lsystem/notations/lparser_text.h"

#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::commands {

namespace {

struct LsystemArguments {
    options::ModelOptions model;
    document::ModelCost cost;
    io::ModelCompanions companions;
};

std::string features_text(lsystem::Model const& model)
{
    std::string text = fmt::format("{}: understood\n\nUses\n", printable(model.name));
    for (auto const& feature : lsystem::features_used(model))
        text += fmt::format("  {}\n", feature);
    return text;
}

// Describes the drawn plant and lists all warnings. The string is drawn here, as warnings about
// skipped symbols arise only then.
Result<std::string> drawing_text(lsystem::Model const& model, lsystem::ModuleString const& string,
                                 lsystem::DeriveOptions const& options)
{
    auto const drawn = TRY(
        lsystem::interpret_with_warnings(model, string,
                                         { .max_modules = options.limits.max_modules,
                                           .max_memory_bytes = options.limits.max_memory_bytes,
                                           .time = options.limits.time,
                                           .print = options.print }));
    auto const& plant = drawn.plant;
    std::string text = fmt::format("\nDraws {} segments on {} axes, {} organs, {} polygons\n",
                                   plant.segment_count(), plant.axes.size(), plant.organs.size(),
                                   plant.polygons.size());
    auto warnings = model.warnings;
    warnings.insert(warnings.end(), drawn.warnings.begin(), drawn.warnings.end());
    text += warnings.empty() ? "\nNo warnings\n" : "\nWarnings\n";
    for (auto const& warning : warnings)
        text += fmt::format("  {}\n", printable(warning));
    return text;
}

Result<void> check(LsystemArguments const& arguments)
{
    auto const path = TRY(files::find_model(arguments.model.model));
    auto const model = TRY(io::load_model(path, arguments.companions));
    TRY(terminal::print_out(features_text(model) + "\nStep      modules   parameters\n"));
    auto options = options::derive_options(arguments.model, arguments.cost);
    Result<void> printed;
    options.on_step = [&](int step, lsystem::ModuleString const& string) {
        if (printed)
            printed = terminal::print_out(
                fmt::format("{:4} {:12} {:12}\n", step, string.size(), string.parameters.size()));
    };
    auto const string = TRY(lsystem::derive(model, options));
    TRY(std::move(printed));
    auto const drawing = TRY(drawing_text(model, string, options));
    TRY(terminal::print_out(
        drawing + methods::describe_uses(path, document::load_options(arguments.cost))));
    io::warn_of_unused_companions(path, arguments.companions);
    return {};
}

// Rules of the example model that `tractus lsystem new` writes. Its own comments explain each line.
constexpr std::string_view kNewModel = R"(/* A young tree. Change a number, save, and look again:
     tractus grow THIS.l -o tree.png */
#define STEPS 7     /* of growth */
#define ANGLE 30    /* between a branch and what bears it, degrees */
#define SHORTER 0.8 /* a branch than the one before */

Lsystem: 1
derivation length: STEPS
Axiom: !(1.2)F(12)A(10) /* a trunk of 12, and a bud for 10 more */

/* A bud makes two branches, each with a smaller bud at its end; the second is turned a quarter. */
A(s) --> [+(ANGLE)!(s / 16)F(s)A(s * SHORTER)]/(90)[-(ANGLE)!(s / 16)F(s)A(s * SHORTER)]/(90)

/* What the turtle draws for a bud: a leaf. Of which form ~l is, the view says, THIS.v. */
homomorphism
A(s) --> ~l(4)
endlsystem
)";

// View file of the example model that `tractus lsystem new` writes.
constexpr std::string_view kNewView
    = R"(/* How the tree looks: colours, and the organs that the rules draw by ~LETTER. */
material: 1 bark kind=bark color=0.43,0.36,0.30
material: 2 foliage kind=leaf color=0.27,0.46,0.16
initial color: 1
organ: l leaf kind=blade material=2 length=4 width=2.2 petiole=0.6
)";

// Fails if the model's path equals that of its view file, or if either file exists already.
Result<void> check_new_model(std::filesystem::path const& path, std::filesystem::path const& view)
{
    if (view == path)
        return fail(Fault::User,
                    fmt::format("{} is the name of a view; a model's ends in .l", path.string()));
    std::error_code ignored;
    for (auto const& file : { path, view })
        if (std::filesystem::exists(file, ignored))
            return fail(Fault::User,
                        fmt::format("{} is there already; choose another name", file.string()));
    return {};
}

Result<void> write_new(std::filesystem::path const& path)
{
    auto view = path;
    view.replace_extension(".v");
    TRY(check_new_model(path, view));
    TRY(write_file(view, kNewView));
    TRY(write_file(path, kNewModel));
    return terminal::print_out(
        fmt::format("{} is written, with its view, {}: change them, and see the tree "
                    "with\n  tractus grow {} -o tree.png\n",
                    path.string(), view.string(), path.string()));
}

struct ImportArguments {
    std::string input;
    std::string output;
    std::string notation;
};

// Reads a model in another program's or a book's notation: the notation named by the options,
// otherwise the one that is recognised.
Result<lsystem::ImportedModel> read_imported(ImportArguments const& arguments)
{
    constexpr std::size_t kMaxFileSize = std::size_t { 16 } << 20;
    auto const text = TRY(read_text_file(arguments.input, kMaxFileSize));
    auto const foreign = lsystem::find_foreign_notation(text);
    bool const is_lparser = arguments.notation == "lparser"
        || (arguments.notation.empty() && foreign
            && foreign->notation == lsystem::Notation::LParser);
    if (is_lparser)
        return lsystem::read_lparser_model(arguments.input, text);
    if (foreign && arguments.notation.empty())
        return fail(Fault::User, lsystem::describe_foreign_text(arguments.input, *foreign));
    auto book = lsystem::read_book_model(text);
    return lsystem::ImportedModel { std::move(book.text), std::move(book.view), {} };
}

Result<void> import_model(ImportArguments const& arguments)
{
    auto const made = TRY(read_imported(arguments));
    std::filesystem::path const path(arguments.output);
    auto view = path;
    view.replace_extension(".v");
    TRY(check_new_model(path, view));
    TRY(lsystem::compile_model({ .name = arguments.input, .text = made.text }));
    TRY(write_file(path, made.text));
    if (!made.view.empty())
        TRY(write_file(view, made.view));
    for (auto const& warning : made.warnings)
        terminal::print_warning(warning);
    return terminal::print_out(
        fmt::format("{} is written{}: see it with\n  tractus grow {} -o "
                    "plant.png\n",
                    path.string(), made.view.empty() ? "" : ", with its view", path.string()));
}

void add_import_command(CLI::App& command, options::Action& action)
{
    // Shared with the command's action, which runs after this function has returned.
    auto const arguments = std::make_shared<ImportArguments>();
    auto* const import_command = command.add_subcommand(
        "import", "Make a model of one in a book's or another program's notation");
    import_command
        ->add_option("FILE", arguments->input,
                     "A model as The Algorithmic Beauty of Plants prints it, or LParser's (.ls)")
        ->required()
        ->check(CLI::ExistingFile);
    import_command
        ->add_option("-o,--output", arguments->output,
                     "Where to; neither it nor its view, .v, may be there yet")
        ->type_name("NAME.l")
        ->required();
    import_command
        ->add_option("--from", arguments->notation,
                     "The file's notation: book or lparser; without it, as the file looks")
        ->type_name("NOTATION")
        ->check(options::one_of({ "book", "lparser" }));
    import_command->callback(
        [&action, arguments] { action = [arguments] { return import_model(*arguments); }; });
}

} // namespace

void add_lsystem_command(CLI::App& root, options::Action& action)
{
    auto* const command
        = root.add_subcommand("lsystem", "Check an L-system, import one, or begin one");
    command->require_subcommand(1);
    add_import_command(*command, action);
    auto* const check_command = command->add_subcommand(
        "check", "List what a model uses, its warnings, and the modules after each step");
    // Shared with the commands' actions, which run after this function has returned.
    auto const arguments = std::make_shared<LsystemArguments>();
    options::add_model_options(*check_command, arguments->model);
    options::add_cost_options(*check_command, arguments->cost);
    options::add_companion_options(*check_command, arguments->companions);
    check_command->callback(
        [&action, arguments] { action = [arguments] { return check(*arguments); }; });
    // Path of the new file; shared with the command's action.
    auto const new_path = std::make_shared<std::string>();
    auto* const new_command
        = command->add_subcommand("new", "Write a commented L-system and its view to begin with");
    new_command->add_option("FILE.l", *new_path, "Where to; neither it nor FILE.v may be there yet")
        ->required();
    new_command->callback(
        [&action, new_path] { action = [new_path] { return write_new(*new_path); }; });
}

} // namespace tractus::commands
