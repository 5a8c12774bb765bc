#include "app/verbs/replay.h"

#include "app/console.h"
#include "app/job.h"
#include "app/progress.h"
#include "app/resources.h"
#include "app/verbs/checks.h"

#include <memory>

namespace tractus {

void add_replay_verb(CLI::App& root, Action& action)
{
    struct Arguments {
        JobOptions job;
        std::string model;
        std::string rig;
        std::string height;
    };
    auto arguments = std::make_shared<Arguments>();
    auto* const verb = root.add_subcommand(
        "replay",
        "Replay a recorded drawing onto a plant model and make a collection of varied plants");
    verb->add_option("LOG", arguments->job.log,
                     "The drawing: a .tractus-log, or anybody's hid-recorder file")
        ->required();
    verb->add_option("--plant", arguments->model,
                     "The plant's model: an L-system file (.l), or broadleaf, conifer, daisy or "
                     "shrub")
        ->type_name("MODEL")
        ->required();
    verb->add_option("--rig", arguments->rig,
                     "The rig's calibration, a .rig.toml; without it, the log's own")
        ->type_name("FILE");
    verb->add_option("--height", arguments->height,
                     "The surface's height in place of the log's height sensor: millimetres above "
                     "the desk, or a made-up movement: rise, fall, arch or sway")
        ->type_name("MM|MOVEMENT")
        ->check(height_scenario());
    verb->add_option("--seed", arguments->job.seed,
                     "Chooses the variations: another seed, other plants")
        ->type_name("N")
        ->check(seed_number())
        ->capture_default_str();
    verb->add_option("--count", arguments->job.variations, "Plants in the collection, 1 to 100")
        ->type_name("N")
        ->check(whole_number(1, 100))
        ->capture_default_str();
    verb->add_option("-o,--output", arguments->job.folder,
                     "The folder for pictures, glTF and report; made if it is not there")
        ->type_name("FOLDER")
        ->capture_default_str();
    verb->footer(
        "Writes base.png (the plant as its model gives it), strokes.png (what was drawn),\n"
        "varied.png (one variation), collection.png and collection.glb (all of them) and\n"
        "report.txt, which is printed, too. The same seed gives the same plants.");
    verb->callback([arguments, &action] {
        action = [arguments]() -> Result<void> {
            auto job = arguments->job;
            job.model = TRY(find_model(arguments->model));
            if (!arguments->rig.empty())
                job.rig = arguments->rig;
            if (!arguments->height.empty())
                job.height = arguments->height;
            Progress progress;
            return print_out(print_report(TRY(run_job(job, progress))));
        };
    });
}

} // namespace tractus
