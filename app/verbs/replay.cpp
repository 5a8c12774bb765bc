#include "app/verbs/replay.h"

#include "app/job.h"
#include "app/progress.h"
#include "app/resources.h"

#include <fmt/core.h>
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
    verb->add_option("log", arguments->job.log, "A .tractus-log, or anybody's hid-recorder file")
        ->required();
    verb->add_option("--plant", arguments->model,
                     "The model: an L-system file, or the name of one of ours")
        ->required();
    verb->add_option("--rig", arguments->rig,
                     "The rig's calibration (.rig.toml); default: the log's own");
    verb->add_option("--height", arguments->height,
                     "In place of a height sensor: millimetres, or rise, fall, arch or sway");
    verb->add_option("--seed", arguments->job.seed, "Of the variations")->capture_default_str();
    verb->add_option("--count", arguments->job.variations, "Plants in the collection")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
    verb->add_option("-o,--output", arguments->job.folder,
                     "The folder for pictures, glTF and report")
        ->capture_default_str();
    verb->callback([arguments, &action] {
        action = [arguments]() -> Result<void> {
            auto job = arguments->job;
            job.model = TRY(find_model(arguments->model));
            if (!arguments->rig.empty())
                job.rig = arguments->rig;
            if (!arguments->height.empty())
                job.height = arguments->height;
            Progress progress;
            fmt::print("{}", print_report(TRY(run_job(job, progress))));
            return {};
        };
    });
}

} // namespace tractus
