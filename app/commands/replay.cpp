#include "app/commands/replay.h"

#include "app/batch/job.h"
#include "app/files/resources.h"
#include "app/options/checks.h"
#include "app/options/glb_options.h"
#include "app/options/growth_options.h"
#include "app/options/picture_options.h"
#include "app/options/recordings_help.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "app/terminal/progress.h"
#include "engine/base/file.h"

#include <fmt/core.h>
#include <memory>

namespace tractus::commands {

namespace {

struct ReplayArguments {
    batch::JobOptions job;
    std::string model;
    std::string rig;
    std::string height;
    bool is_forced = false;
};

Result<void> replay(ReplayArguments const& arguments, tools::Methods const& methods)
{
    auto job = arguments.job;
    job.drawing.methods = methods;
    if (job.folder.empty())
        job.folder = std::filesystem::path(job.drawing.log).stem().string() + "-plants";
    TRY(check_writable(job.folder / "report.txt"));
    if (!arguments.is_forced)
        TRY(batch::check_job_folder(job.folder));
    job.model = TRY(files::find_plant(arguments.model));
    if (!arguments.rig.empty())
        job.drawing.rig = arguments.rig;
    if (!arguments.height.empty())
        job.drawing.height = arguments.height;
    terminal::Progress progress;
    return terminal::print_out(batch::print_report(TRY(batch::run_job(job, progress))));
}

} // namespace

void add_replay_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<ReplayArguments>();
    auto* const command = root.add_subcommand(
        "replay",
        "Replay a recorded drawing onto a plant model and make a collection of varied plants");
    command
        ->add_option("LOG", arguments->job.drawing.log,
                     fmt::format("The drawing: {}; or strokes in space: .tilt (Open Brush), "
                                 ".strokes or .txt",
                                 options::kRecordings))
        ->required();
    options::add_plant_option(*command, arguments->model);
    options::add_rig_option(*command, arguments->rig);
    options::add_height_option(*command, arguments->height);
    options::add_seed_option(*command, arguments->job.seed);
    command
        ->add_option("--speed", arguments->job.drawing.speed,
                     "Replay at the pace of the hand, 1, or so many times as fast; without it, as "
                     "fast as the log can be read")
        ->type_name("X")
        ->check(options::number(0.01, 1000));
    command->add_option("--count", arguments->job.variations, "Plants in the collection, 1 to 100")
        ->type_name("N")
        ->check(options::whole_number(1, 100))
        ->capture_default_str();
    options::add_growth_options(*command, arguments->job.growth, "usual, or as in a session");
    options::add_individuality_options(*command, arguments->job.individuality);
    options::add_age_option(*command, arguments->job.age);
    command->add_flag("--seasons", arguments->job.all_seasons,
                      "Show what was drawn also in spring, summer, autumn and winter");
    arguments->job.folder.clear();
    options::add_folder_option(*command, arguments->job.folder)
        ->description("The folder for pictures, glTF and report; made if it is not there; without "
                      "it, one in the current folder: LOG-plants");
    options::add_picture_size_option(*command, arguments->job.picture);
    options::add_force_option(*command, arguments->is_forced);
    options::add_glb_options(*command, arguments->job.glb);
    command
        ->add_option("--session", arguments->job.session,
                     "Keep what is drawn in a new session, each stroke as soon as it ends")
        ->type_name("FILE.tractus")
        ->check(options::name_ending_in({ ".tractus" }));
    command->footer(options::job_footer());
    command->callback([arguments, methods, &action] {
        action = [arguments, methods] { return replay(*arguments, methods); };
    });
}

} // namespace tractus::commands
