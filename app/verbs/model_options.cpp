#include "app/verbs/model_options.h"

#include "app/verbs/checks.h"

namespace tractus {

void add_model_options(CLI::App& verb, ModelOptions& options)
{
    verb.add_option("MODEL", options.model,
                    "An L-system file (.l), or one of ours by its name: broadleaf, palm, …; "
                    "app/models/README.md shows them all")
        ->required();
    verb.add_option("-n,--steps", options.steps, "Derivation steps; without it, the model's own")
        ->type_name("STEPS")
        ->check(whole_number(0, 1'000'000'000));
    verb.add_option("--seed", options.seed,
                    "Of the model's stochastic rules: another seed, another plant")
        ->type_name("N")
        ->check(seed_number())
        ->capture_default_str();
}

} // namespace tractus
