#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/language/virtual_machine.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::lsystem {

// The L-systems that are at work at a place in a string: the main one, and those that ?(…) have
// called and whose $ has not come yet.
class CallStack {
public:
    // The model must outlive it. `main` runs the main L-system's programs and outlives it, too.
    CallStack(Model const& model, VirtualMachine& main);

    // Index of the L-system at work: 0 is the main one, k the subsystem k - 1.
    std::size_t current() const { return at_work_.back(); }
    std::size_t depth() const { return at_work_.size() - 1; }
    VirtualMachine& machine(std::size_t system) { return *machines_[system]; }
    LSystem const& system(std::size_t index) const
    {
        return index == 0 ? static_cast<LSystem const&>(model_) : model_.subsystems[index - 1];
    }

    // The variables of a ?(…) that is in a string, but has not been rewritten yet.
    static SubsystemCall new_call(Model const& model, std::uint16_t subsystem);

    // Index into Model::subsystems of the one that a ?(…) calls by its first parameter. Fails, as
    // the user's fault, when the model has none or it is at work already.
    Result<std::uint16_t> find(float id) const;

    // Whether a module of this kind calls a sub-L-system; whether it ends a call.
    bool is_call(KindId kind) const
    {
        auto const& module = model_.alphabet[kind];
        return module.symbol == '?' && module.parameter_count > 0;
    }
    bool is_end(KindId kind) const { return model_.alphabet[kind].symbol == '$'; }

    // Puts the L-system of a call to work, with the variables of `call`.
    void enter(SubsystemCall const& call);
    // Ends the innermost call and returns its variables. There must be one.
    SubsystemCall leave();

private:
    template<typename Pass> void for_each_external(Pass const& pass);

    Model const& model_;
    std::vector<std::unique_ptr<VirtualMachine>> subsystem_machines_;
    std::vector<VirtualMachine*> machines_;
    std::vector<std::size_t> at_work_ { 0 }; // Indices, the innermost last.
};

} // namespace tractus::lsystem
