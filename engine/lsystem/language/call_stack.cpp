#include "engine/lsystem/language/call_stack.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

CallStack::CallStack(Model const& model, VirtualMachine& main)
    : model_(model)
    , machines_ { &main }
{
    for (auto const& subsystem : model.subsystems) {
        auto machine = std::make_unique<VirtualMachine>(model, subsystem, main.seed());
        machine->set_printer(main.printer());
        machine->set_time_limit(main.time_limit());
        machine->set_memory_limit(main.memory_limit());
        machines_.push_back(machine.get());
        subsystem_machines_.push_back(std::move(machine));
    }
}

Result<std::uint16_t> CallStack::find(float id) const
{
    auto const& subsystems = model_.subsystems;
    auto const found
        = std::find_if(subsystems.begin(), subsystems.end(), [&](LSystem const& subsystem) {
              return static_cast<double>(subsystem.id) == std::trunc(static_cast<double>(id));
          });
    if (found == subsystems.end())
        return fail(Fault::User,
                    fmt::format("{}: found ?({}), expected the number of one of the file's "
                                "sub-L-systems",
                                model_.name, id));
    auto const index = static_cast<std::size_t>(found - subsystems.begin());
    if (std::find(at_work_.begin(), at_work_.end(), index + 1) != at_work_.end())
        return fail(Fault::User,
                    fmt::format("{}: found ?({}) between another ?({}) and its $; a sub-L-system "
                                "cannot call itself",
                                model_.name, id, id));
    return static_cast<std::uint16_t>(index);
}

void CallStack::enter(SubsystemCall const& call)
{
    auto const& caller = machine(current());
    at_work_.push_back(call.subsystem + std::size_t { 1 });
    auto& called = machine(current());
    called.globals = call.globals;
    called.arrays = call.arrays;
    called.share(caller);
    for_each_external([](auto& inner, auto const& outer) { inner = outer; });
}

SubsystemCall CallStack::leave()
{
    for_each_external([](auto const& inner, auto& outer) { outer = inner; });
    auto const index = current();
    auto& called = machine(index);
    at_work_.pop_back();
    machine(current()).share(called);
    return { static_cast<std::uint16_t>(index - 1), true, std::move(called.globals),
             std::move(called.arrays) };
}

// Calls `pass` for each external name of the active L-system. Its arguments are the variable or
// array of that name in the active L-system, and that in the nearest caller that has one.
template<typename Pass> void CallStack::for_each_external(Pass const& pass)
{
    auto const& inner = system(current());
    auto& machine = this->machine(current());
    for (auto const& external : inner.externals)
        for (auto caller = at_work_.rbegin() + 1; caller != at_work_.rend(); ++caller) {
            auto const& outer = system(*caller);
            auto& outer_machine = *machines_[*caller];
            if (external.is_array) {
                auto const& array = inner.arrays[external.index];
                auto const found = std::find_if(
                    outer.arrays.begin(), outer.arrays.end(), [&](ArrayVariable const& other) {
                        return other.name == array.name
                            && other.values.size() == array.values.size();
                    });
                if (found == outer.arrays.end())
                    continue;
                pass(machine.arrays[external.index],
                     outer_machine.arrays[static_cast<std::size_t>(found - outer.arrays.begin())]);
            } else {
                auto const& name = inner.globals[external.index];
                auto const found = std::find(outer.globals.begin(), outer.globals.end(), name);
                if (found == outer.globals.end())
                    continue;
                pass(
                    machine.globals[external.index],
                    outer_machine.globals[static_cast<std::size_t>(found - outer.globals.begin())]);
            }
            break;
        }
}

SubsystemCall CallStack::new_call(Model const& model, std::uint16_t subsystem)
{
    auto const& system = model.subsystems[subsystem];
    SubsystemCall call;
    call.subsystem = subsystem;
    call.globals.resize(system.globals.size());
    for (auto const& array : system.arrays)
        call.arrays.push_back(array.values);
    return call;
}

} // namespace tractus::lsystem
