#include "app/verbs/session.h"

#include "app/plants/session_export.h"
#include "app/plants/session_plant.h"
#include "app/session/describe_edit.h"
#include "app/terminal/console.h"

#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <memory>
#include <set>

namespace tractus {

namespace {

struct SessionArguments {
    std::filesystem::path file;
    std::filesystem::path folder = ".";
};

// In UTC, so that a session says the same everywhere.
std::string date_text(std::chrono::sys_seconds time)
{
    constexpr std::int64_t kEndOfYear9999 = 253'402'300'799;
    auto const seconds = time.time_since_epoch().count();
    if (seconds <= 0 || seconds > kEndOfYear9999)
        return "at an unknown time";
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

Result<void> print_info(SessionArguments const& arguments)
{
    auto const contents = TRY(read_session(arguments.file));
    auto const scene = TRY(load_session_scene(arguments.file));
    std::set<Timestamp> strokes; // One that shapes several branches counts once.
    std::size_t orphans = 0;
    for (auto const& association : scene.associations) {
        strokes.insert(association.stroke.tips.front().time);
        orphans += association.is_orphaned;
    }
    for (auto const& indicator : scene.indicators)
        orphans += indicator.is_orphaned;
    std::error_code ignored;
    std::string text;
    auto const line = [&](char const* name, auto const& value) {
        text += fmt::format("{:<22}{}\n", name, value);
    };
    line("session", arguments.file.string());
    line("bytes", std::filesystem::file_size(arguments.file, ignored));
    line("plant", contents.origin.plant);
    line("begun", date_text(contents.origin.created));
    line("by", "tractus " + contents.origin.program);
    line("last step", date_text(contents.edits.back().made));
    line("edits", contents.edits.size());
    line("steps to undo", contents.step);
    line("steps to redo", contents.last_step() - contents.step);
    line("segments", scene.base->segment_count());
    line("strokes", strokes.size());
    line("branches with strokes", scene.associations.size());
    line("motion indicators", scene.indicators.size());
    line("without a branch", orphans);
    return print_out(text);
}

Result<void> print_log(SessionArguments const& arguments)
{
    auto const contents = TRY(read_session(arguments.file));
    std::string text;
    for (auto const& [step, edit, made, place] : contents.edits)
        text += fmt::format("{:>5}  step {:<5} {:<23}  {}{}\n", place.number, step, date_text(made),
                            describe_edit(edit), step > contents.step ? " (undone)" : "");
    return print_out(text);
}

Result<void> export_files(SessionArguments const& arguments)
{
    std::string text;
    for (auto const& file : TRY(export_session(arguments.file, arguments.folder)))
        text += fmt::format("wrote {}\n", file.string());
    return print_out(text);
}

using Run = Result<void> (*)(SessionArguments const&);

CLI::App& add_part(CLI::App& verb, std::string const& name, std::string const& description,
                   std::pair<Action&, Run> const& run,
                   std::shared_ptr<SessionArguments> const& arguments)
{
    auto* const part = verb.add_subcommand(name, description);
    part->add_option("FILE", arguments->file, "The session (.tractus)")->required();
    part->callback([arguments, &action = run.first, run = run.second] {
        action = [arguments, run] { return run(*arguments); };
    });
    return *part;
}

} // namespace

void add_session_verb(CLI::App& root, Action& action)
{
    // Shared with the callbacks, which outlive this.
    auto const arguments = std::make_shared<SessionArguments>();
    auto* const verb = root.add_subcommand("session", "Look into what the station has kept");
    verb->require_subcommand(1);
    add_part(*verb, "info", "Say what a session is and holds", { action, print_info }, arguments);
    add_part(*verb, "log", "List what was done in it, edit by edit", { action, print_log },
             arguments);
    auto& to_files
        = add_part(*verb, "export", "Write its model and its strokes as files of their own",
                   { action, export_files }, arguments);
    to_files
        .add_option("-o,--output", arguments->folder,
                    "The folder for them; made if it is not there")
        ->type_name("FOLDER")
        ->capture_default_str();
    to_files.footer(
        "Writes the model's rules (.l), view (.v) and what they include, or the skeleton's\n"
        "lines (.obj); and strokes.txt, one stroke after the other, which \"tractus replay\"\n"
        "reads. \"tractus grow\", \"render\" and \"vary\" take a session in the place of a model.");
}

} // namespace tractus
