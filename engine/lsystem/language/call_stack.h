#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/language/virtual_machine.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::lsystem {

// The stack of L-systems that are active at a position in a string: the main one, and each
// sub-L-system whose call ?(...) comes before the position and whose $ has not been reached yet.
class CallStack {
public:
    // The model must outlive the stack. `main` runs the programs of the main L-system and must
    // outlive it, too.
    CallStack(Model const& model, VirtualMachine& main);

    // Returns the index of the active L-system: 0 for the main one, k for Model::subsystems[k - 1].
    std::size_t current() const { return at_work_.back(); }
    std::size_t depth() const { return at_work_.size() - 1; }
    VirtualMachine& machine(std::size_t system) { return *machines_[system]; }
    LSystem const& system(std::size_t index) const
    {
        return index == 0 ? static_cast<LSystem const&>(model_) : model_.subsystems[index - 1];
    }

    // Returns a call with the initial values of its variables, for a ?(...) that has not been
    // rewritten yet.
    static SubsystemCall new_call(Model const& model, std::uint16_t subsystem);

    // Returns the index in Model::subsystems of the L-system with this id, which is the first
    // parameter of a ?(...). Fails with a user error if the model has no such L-system or if it is
    // already active.
    Result<std::uint16_t> find(float id) const;

    // is_call() is true if a module of this kind calls a sub-L-system, is_end() if it ends a call.
    bool is_call(KindId kind) const
    {
        auto const& module = model_.alphabet[kind];
        return module.symbol == '?' && module.parameter_count > 0;
    }
    bool is_end(KindId kind) const { return model_.alphabet[kind].symbol == '$'; }

    // Makes the L-system that is called the active one, with the variables stored in `call`.
    void enter(SubsystemCall const& call);
    // Ends the innermost call and returns its variables. A call must be active.
    SubsystemCall leave();

private:
    template<typename Pass> void for_each_external(Pass const& pass);

    Model const& model_;
    std::vector<std::unique_ptr<VirtualMachine>> subsystem_machines_;
    std::vector<VirtualMachine*> machines_;
    std::vector<std::size_t> at_work_ { 0 }; // Indices of the active L-systems, the innermost last.
};

} // namespace tractus::lsystem
