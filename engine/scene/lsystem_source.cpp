#include "engine/scene/lsystem_source.h"

#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/plant/join_axes.h"

#include <fmt/core.h>

namespace tractus::scene {

Result<BuiltSource> build_lsystem(LoadModel const& loaded, LoadOptions const& options)
{
    auto const include = [&](std::string const& name) -> Result<std::string> {
        auto const found = loaded.includes.find(name);
        if (found == loaded.includes.end())
            return fail(Fault::User,
                        fmt::format("{} includes {}, which is missing", loaded.source.name, name));
        return found->second;
    };
    auto const model = TRY(lsystem::compile_model(loaded.source, include));
    auto const string = TRY(lsystem::derive(model,
                                            { .steps = loaded.steps,
                                              .seed = loaded.seed,
                                              .limits = options.limits,
                                              .print = options.print }));
    auto turtle = TRY(
        lsystem::interpret_with_warnings(model, string,
                                         { .max_modules = options.limits.max_modules,
                                           .max_memory_bytes = options.limits.max_memory_bytes,
                                           .time = options.limits.time,
                                           .print = options.print }));
    BuiltSource built { join_axes(std::move(turtle.plant)), model.warnings };
    built.warnings.insert(built.warnings.end(), turtle.warnings.begin(), turtle.warnings.end());
    return built;
}

} // namespace tractus::scene
