#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/call_stack.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/rewriting/expander.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Reads a string from one end to the other, each module replaced by what the homomorphism rules
// make of it, those of the L-system that is at work at its place: what the turtle reads.
class HomomorphismWalk {
public:
    // All must outlive it; `main` runs the main L-system's programs.
    HomomorphismWalk(Model const& model, ModuleString const& string, VirtualMachine& main);

    bool is_at_end() const { return at_ >= string_.size(); }
    // The place of the module that comes next.
    std::size_t at() const { return at_; }

    // Hands what the next module becomes to `sink`, as Expander::expand() does. False when the sink
    // has returned 0. Fails, as the user's fault, when a loop in a rule does not end or the main
    // machine's time is over.
    using Sink = std::function<std::size_t(Modules const& modules)>;
    Result<bool> read(Sink const& sink);

    // Whether modules that a sink is given stand in the string, or come from a rule.
    bool is_in_string(Modules const& modules) const
    {
        return modules.kinds == string_.kinds.data() + at_;
    }

    // Passes over the rest of the branch.
    void cut();

private:
    void pass(std::size_t count);

    Model const& model_;
    ModuleString const& string_;
    CallStack stack_;
    std::vector<std::unique_ptr<Expander>> expanders_;
    Branches branches_; // Where homomorphism rules have contexts.
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
    std::size_t next_call_ = 0;
};

struct HomomorphismOptions {
    StringLimit limit {};
    TimeLimit time {};
    std::function<void(std::string_view text)> print {}; // Takes what printf prints.
    // % means something where it stands in the string, and nothing where a rule makes it.
    enum class Cuts { Keep, KeepThoseOfTheString };
    Cuts cuts = Cuts::Keep;
};

// The whole string, so replaced. Fails, as the user's fault, beyond a limit in the options and when
// a loop does not end.
Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        HomomorphismOptions const& options = {});

} // namespace tractus::lsystem
