#include "app/commands/demo.h"

#include "app/batch/job.h"
#include "app/files/resources.h"
#include "app/options/checks.h"
#include "app/options/glb_options.h"
#include "app/options/picture_options.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "app/terminal/progress.h"
#include "engine/base/file.h"

#include <algorithm>
#include <fmt/core.h>
#include <memory>

namespace tractus::commands {

void add_demo_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    struct DemoArguments {
        batch::JobOptions job;
        std::string plant = "station";
        bool is_forced = false;
    };
    auto arguments = std::make_shared<DemoArguments>();
    arguments->job.folder = "tractus-demo";
    auto* const command = root.add_subcommand(
        "demo",
        "See what the station is for: a drawing recorded on the simulated rig varies plants");
    options::add_folder_option(*command, arguments->job.folder)->capture_default_str();
    options::add_picture_size_option(*command, arguments->job.picture);
    options::add_force_option(*command, arguments->is_forced);
    options::add_glb_options(*command, arguments->job.glb);
    command->footer(options::job_footer());
    command
        ->add_option(
            "--plant", arguments->plant,
            "Which drawing: one on our broadleaf, conifer, daisy or shrub, or station: three "
            "plants drawn by every method, also in four seasons")
        ->type_name("NAME")
        ->check(options::one_of({ "broadleaf", "conifer", "daisy", "shrub", "station" }))
        ->capture_default_str();
    options::add_seed_option(*command, arguments->job.seed);
    command->callback([arguments, methods, &action] {
        action = [arguments, methods]() -> Result<void> {
            auto job = arguments->job;
            job.drawing.methods = methods;
            TRY(check_writable(job.folder / "report.txt"));
            if (!arguments->is_forced)
                TRY(batch::check_job_folder(job.folder));
            bool const is_station = arguments->plant == "station";
            job.model = TRY(files::find_model(is_station ? "birch" : arguments->plant));
            job.all_seasons = is_station;
            job.has_page = true;
            // The first file that a new user opens contains 16 variations of three plants, so
            // meshes are coarse and leaves are cards: every program opens it quickly.
            if (is_station) {
                job.growth.season.emplace();
                job.mesh = { .min_sides = 3,
                             .max_sides = 6,
                             .subdivision = 1,
                             .ends = mesh::MeshOptions::Ends::Open,
                             .sections = mesh::MeshOptions::Sections::SameArea,
                             .organs = mesh::MeshOptions::Organs::Cards };
                job.detail = 0.25;
                job.glb.vertices
                    = std::max(job.glb.vertices, exports::GlbOptions::Vertices::Quantized);
            }
            job.drawing.log
                = TRY(files::find_resource(fmt::format("demo/{}.tractus-log", arguments->plant)));
            terminal::Progress progress;
            return terminal::print_out(batch::print_report(TRY(batch::run_job(job, progress))));
        };
    });
}

} // namespace tractus::commands
