#include "app/verbs/demo.h"

#include "app/job.h"
#include "app/progress.h"
#include "app/resources.h"

#include <fmt/core.h>
#include <memory>

namespace tractus {

void add_demo_verb(CLI::App& root, Action& action)
{
    struct Arguments {
        JobOptions job;
        std::string plant = "broadleaf";
    };
    auto arguments = std::make_shared<Arguments>();
    arguments->job.folder = "tractus-demo";
    auto* const verb = root.add_subcommand(
        "demo",
        "See what the station is for: a drawing recorded on the simulated rig varies a plant");
    verb->add_option("-o,--output", arguments->job.folder,
                     "The folder for pictures, glTF and report")
        ->capture_default_str();
    verb->add_option("--plant", arguments->plant,
                     "Which of our plants: broadleaf, conifer, daisy or shrub")
        ->capture_default_str()
        ->check(CLI::IsMember({ "broadleaf", "conifer", "daisy", "shrub" }));
    verb->add_option("--seed", arguments->job.seed, "Of the variations")->capture_default_str();
    verb->callback([arguments, &action] {
        action = [arguments]() -> Result<void> {
            auto job = arguments->job;
            job.model = TRY(find_model(arguments->plant));
            job.log = TRY(find_resource(fmt::format("demo/{}.tractus-log", arguments->plant)));
            Progress progress;
            fmt::print("{}", print_report(TRY(run_job(job, progress))));
            return {};
        };
    });
}

} // namespace tractus
