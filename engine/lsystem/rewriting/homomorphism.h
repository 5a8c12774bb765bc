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

// Reads a string from beginning to end and replaces each module by its homomorphic image. Uses the
// rules of the L-system that is active at the module's place. The turtle interprets the images.
class HomomorphismWalk {
public:
    // The arguments must outlive this object. `main` runs the programs of the main L-system.
    HomomorphismWalk(Model const& model, ModuleString const& string, VirtualMachine& main);

    bool is_at_end() const { return at_ >= string_.size(); }
    // Returns the index of the next module.
    std::size_t at() const { return at_; }

    // Passes the image of the next module to `sink`, as Expander::expand() does. Returns false if
    // the sink has returned 0. Fails with a user error if a loop in a rule does not end or the main
    // machine's time limit is exceeded.
    using Sink = std::function<std::size_t(Modules const& modules)>;
    Result<bool> read(Sink const& sink);

    // Returns true if the modules given to a sink are those of the string, false if a rule made
    // them.
    bool is_in_string(Modules const& modules) const
    {
        return modules.kinds == string_.kinds.data() + at_;
    }

    // Skips the rest of the present branch.
    void cut();

private:
    void pass(std::size_t count);

    Model const& model_;
    ModuleString const& string_;
    CallStack stack_;
    std::vector<std::unique_ptr<Expander>> expanders_;
    // Matching brackets of the string; only filled if homomorphism rules have contexts.
    Branches branches_;
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
    std::size_t next_call_ = 0;
};

struct HomomorphismOptions {
    StringLimit limit {};
    TimeLimit time {};
    std::function<void(std::string_view text)> print {}; // Receives the output of printf.
    // Which % modules the result contains. A % in the string itself cuts its branch. A % made by a
    // rule has no effect, and KeepThoseOfTheString leaves it out.
    enum class Cuts { Keep, KeepThoseOfTheString };
    Cuts cuts = Cuts::Keep;
};

// Returns the homomorphic image of the whole string. Fails with a user error if a limit in the
// options is exceeded or a loop does not end.
Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        HomomorphismOptions const& options = {});

} // namespace tractus::lsystem
