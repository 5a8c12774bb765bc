#include "engine/lsystem/rewriting/homomorphism.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::lsystem {

HomomorphismWalk::HomomorphismWalk(Model const& model, ModuleString const& string,
                                   VirtualMachine& main)
    : model_(model)
    , string_(string)
    , stack_(model, main)
{
    for (std::size_t i = 0; i <= model.subsystems.size(); ++i) {
        auto const& system = stack_.system(i);
        expanders_.push_back(
            std::make_unique<Expander>(model, system, system.homomorphism, stack_.machine(i)));
    }
    if (std::any_of(expanders_.begin(), expanders_.end(),
                    [](auto const& expander) { return expander->has_contexts(); }))
        find_branches(model, string, branches_);
}

Result<bool> HomomorphismWalk::read(Sink const& sink)
{
    Modules const rest { string_.kinds.data() + at_, string_.parameters.data() + parameter_,
                         string_.size() - at_ };
    auto& machine = stack_.machine(stack_.current());
    machine.begin_module(kHomomorphismStep, at_);
    Surroundings const around {
        &string_,   &branches_, at_,
        parameter_, at_ + 1,    parameter_ + model_.alphabet[rest.kinds[0]].parameter_count
    };
    auto const count = expanders_[stack_.current()]->expand(rest, around, sink);
    TRY(machine.check());
    pass(count);
    return count > 0;
}

void HomomorphismWalk::cut()
{
    pass(cut_end(model_, string_, at_) - at_);
}

void HomomorphismWalk::pass(std::size_t count)
{
    for (; count > 0; --count) {
        auto const kind = string_.kinds[at_++];
        if (stack_.is_call(kind) && next_call_ < string_.calls.size())
            stack_.enter(string_.calls[next_call_++]);
        else if (stack_.is_end(kind) && stack_.depth() > 0)
            stack_.leave();
        parameter_ += model_.alphabet[kind].parameter_count;
    }
}

Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        HomomorphismOptions const& options)
{
    using Cuts = HomomorphismOptions::Cuts;
    VirtualMachine machine(model, string);
    machine.set_time_limit(&options.time);
    machine.set_memory_limit(options.limit.bytes);
    machine.set_printer(&options.print);
    HomomorphismWalk walk(model, string, machine);
    ModuleString result;
    auto const append = [&](Modules const& modules) -> std::size_t {
        auto const& kind = model.alphabet[modules.kinds[0]];
        if (kind.symbol == '%' && options.cuts != Cuts::Keep && !walk.is_in_string(modules))
            return 1;
        result.kinds.append(modules.kinds, 1);
        result.parameters.append(modules.parameters, kind.parameter_count);
        return result.size() <= options.limit.modules && result.byte_size() <= options.limit.bytes;
    };
    while (!walk.is_at_end())
        if (!TRY(walk.read(append)))
            return fail(Fault::User,
                        fmt::format("{}: the homomorphism makes more than {} modules, or {} MB of "
                                    "them; derive fewer steps or raise the limit",
                                    model.name, options.limit.modules, options.limit.bytes >> 20));
    result.globals = string.globals;
    result.arrays = string.arrays;
    result.calls = string.calls;
    result.turtles = string.turtles;
    result.seed = string.seed;
    return result;
}

} // namespace tractus::lsystem
