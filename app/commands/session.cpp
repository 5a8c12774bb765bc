#include "app/commands/session.h"

#include "app/batch/session_export.h"
#include "app/batch/session_plant.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/options/checks.h"
#include "app/session/session_repair.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"

#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <memory>
#include <set>

namespace tractus::commands {

namespace {

struct SessionArguments {
    scene::EditKinds kinds; // Kinds of edits that this program can apply.
    std::filesystem::path file;
    std::filesystem::path folder = ".";
    std::filesystem::path repaired {};
    std::string plant {}; // Name or path of a model that replaces the session's lost plant.
};

// Formats the date in UTC, so that the output does not depend on the time zone.
std::string date_text(std::chrono::sys_seconds time)
{
    constexpr std::int64_t kEndOfYear9999 = 253'402'300'799;
    auto const seconds = time.time_since_epoch().count();
    if (seconds <= 0 || seconds > kEndOfYear9999)
        return "at an unknown time";
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

// The readable part of a session, and the error if the session is damaged.
struct ReadSession {
    session::SessionContents contents;
    Result<void> whole {};
};

// Reads a session. If the file is damaged, reads all edits that are intact.
Result<ReadSession> read_what_is_whole(SessionArguments const& arguments)
{
    auto contents = session::read_session(arguments.file, arguments.kinds);
    if (contents)
        return ReadSession { *std::move(contents) };
    auto const damage = contents.error();
    auto const salvaged = session::salvage_session(arguments.file, arguments.kinds);
    if (!salvaged)
        return tl::unexpected(damage);
    return ReadSession { session::contents_of(*salvaged), tl::unexpected(damage) };
}

Result<void> print_info(SessionArguments const& arguments)
{
    auto const [contents, whole] = TRY(read_what_is_whole(arguments));
    auto const [scene, edits, unknown, skipped_steps] = TRY(batch::fold_session(contents));
    // A set counts a stroke once, even if it shapes several branches.
    std::set<Timestamp> strokes;
    std::size_t orphans = 0;
    std::size_t segments = 0;
    std::size_t branches = 0;
    std::size_t indicators = 0;
    for (auto const& plant : scene.plants) {
        segments += plant->base->segment_count();
        branches += plant->associations.size();
        indicators += plant->indicators.size();
        for (auto const& [id, association, at] : plant->associations) {
            strokes.insert(association.stroke.tips.front().time);
            orphans += association.is_orphaned;
        }
        for (auto const& indicator : plant->indicators)
            orphans += indicator.what.is_orphaned;
    }
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
    line("plants", scene.plants.size());
    line("segments", segments);
    line("strokes", strokes.size());
    line("branches with strokes", branches);
    line("motion indicators", indicators);
    line("without a branch", orphans);
    if (unknown.count > 0)
        line("edits not known", fmt::format("{} ({})", unknown.count, unknown.first));
    if (skipped_steps > 0)
        line("steps that need more", skipped_steps);
    TRY(terminal::print_out(text));
    return whole;
}

Result<void> print_log(SessionArguments const& arguments)
{
    auto const [contents, whole] = TRY(read_what_is_whole(arguments));
    std::string text;
    for (auto const& [step, edit, made, place] : contents.edits)
        text += fmt::format("{:>5}  step {:<5} {:<23}  {}{}\n", place.number, step, date_text(made),
                            edit.describe(), step > contents.step ? " (undone)" : "");
    TRY(terminal::print_out(text));
    return whole;
}

// Formats a list of numbers, with ranges, as "3, 7 to 9 and 12".
std::string print_numbers(std::vector<std::int64_t> const& numbers)
{
    std::vector<std::string> ranges;
    for (std::size_t i = 0; i < numbers.size();) {
        auto end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
        ranges.push_back(end - i == 1 ? fmt::format("{}", numbers[i])
                                      : fmt::format("{} to {}", numbers[i], numbers[end - 1]));
        i = end;
    }
    std::string text = fmt::format("{}", fmt::join(ranges.begin(), ranges.end() - 1, ", "));
    return text + (text.empty() ? "" : " and ") + ranges.back();
}

std::string print_lost(session::SalvagedSession const& session)
{
    auto const last = session.rows.back().place.number;
    auto text = session.missing.empty()
        ? fmt::format("none of edits 1 to {} is missing\n", last)
        : fmt::format("lost: edits {} of {}\n", print_numbers(session.missing), last);
    if (!session.missing.empty())
        text += "what they did is not done; look whether the strokes after them shape what you "
                "meant\n";
    text += fmt::format("if there were edits after {}, they are lost\n", last);
    if (!session.step)
        text += "which steps were undone is lost: all count\n";
    return text;
}

bool has_beginning(session::SalvagedSession const& session)
{
    auto const& first = session.rows.front();
    return first.step == 0 && first.record.kind.starts_with("load_");
}

Result<void> repair(SessionArguments const& arguments)
{
    TRY(check_writable(arguments.repaired));
    auto const session = TRY(session::salvage_session(arguments.file, arguments.kinds));
    std::vector<scene::Edit> beginning;
    if (!arguments.plant.empty()) {
        auto const model = TRY(files::find_model(arguments.plant));
        beginning.push_back(TRY(io::load_plant_edit(model)));
    } else if (!has_beginning(session)) {
        terminal::print_warning(fmt::format(
            "the plant itself is lost: give it with --plant, {} it was", session.origin.plant));
    }
    TRY(session::write_repaired(session, beginning, arguments.repaired));
    return terminal::print_out(fmt::format("{}: {} edits\n{}", arguments.repaired.string(),
                                           session.rows.size() + beginning.size(),
                                           print_lost(session)));
}

Result<void> export_files(SessionArguments const& arguments)
{
    TRY(check_writable(arguments.folder / "strokes.txt"));
    std::string text;
    for (auto const& file :
         TRY(batch::export_session(arguments.file, arguments.folder, arguments.kinds)))
        text += fmt::format("wrote {}\n", file.string());
    return terminal::print_out(text);
}

using Run = Result<void> (*)(SessionArguments const&);

CLI::App& add_part(CLI::App& command, std::string const& name, std::string const& description,
                   std::pair<options::Action&, Run> const& run,
                   std::shared_ptr<SessionArguments> const& arguments)
{
    auto* const part = command.add_subcommand(name, description);
    part->add_option("FILE", arguments->file, "The session (.tractus)")->required();
    part->callback([arguments, &action = run.first, run = run.second] {
        action = [arguments, run] { return run(*arguments); };
    });
    return *part;
}

} // namespace

void add_session_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    // Shared with the commands' actions, which run after this function has returned.
    auto const arguments = std::make_shared<SessionArguments>();
    arguments->kinds = methods.edits;
    auto* const command = root.add_subcommand("session", "Look into what the station has kept");
    command->require_subcommand(1);
    add_part(*command, "info", "Say what a session is and holds", { action, print_info },
             arguments);
    add_part(*command, "log", "List what was done in it, edit by edit", { action, print_log },
             arguments);
    auto& to_repair = add_part(*command, "repair",
                               "Bring back what is whole of a damaged session, as a new one",
                               { action, repair }, arguments);
    to_repair
        .add_option("-o,--output", arguments->repaired,
                    "The new session; the old one stays as it is")
        ->type_name("NEW.tractus")
        ->check(options::name_ending_in({ ".tractus" }))
        ->required();
    to_repair
        .add_option("--plant", arguments->plant,
                    "Begin with this model, where the session's own plant is lost")
        ->type_name("MODEL");
    to_repair.footer("Looks at every byte of the file, and of the log beside it (FILE-wal), for "
                     "edits that are as\n"
                     "they were written, whatever else is damaged, and names those that are "
                     "missing among them.");
    auto& to_files
        = add_part(*command, "export", "Write its model and its strokes as files of their own",
                   { action, export_files }, arguments);
    to_files
        .add_option("-o,--output", arguments->folder,
                    "The folder for them; made if it is not there")
        ->type_name("FOLDER")
        ->capture_default_str();
    to_files.footer(
        "Writes the model's rules (.l), view (.v) and what they include, the skeleton's lines\n"
        "(.obj) or the measured tree's file; and strokes.txt, one stroke after the other,\n"
        "which \"tractus replay\" reads. \"tractus grow\", \"render\" and \"vary\" take a\n"
        "session in the place of a model.");
}

} // namespace tractus::commands
