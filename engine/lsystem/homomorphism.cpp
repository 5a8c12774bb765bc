#include "engine/lsystem/homomorphism.h"

#include "engine/lsystem/call_stack.h"
#include "engine/lsystem/expander.h"

#include <fmt/core.h>
#include <memory>
#include <vector>

namespace tractus {

namespace {

class Homomorphism {
public:
    Homomorphism(Model const& model, ModuleString const& string, HomomorphismOptions const& options)
        : model_(model)
        , string_(string)
        , options_(options)
        , machine_(model, string)
        , stack_(model, machine_)
    {
        machine_.set_time_limit(&options.time);
        bool has_contexts = false;
        for (std::size_t i = 0; i <= model.subsystems.size(); ++i) {
            auto const& system = stack_.system(i);
            stack_.machine(i).set_time_limit(&options.time);
            expanders_.push_back(
                std::make_unique<Expander>(model, system, system.homomorphism, stack_.machine(i)));
            has_contexts = has_contexts || expanders_.back()->has_contexts();
        }
        if (has_contexts)
            find_branches(model, string, branches_);
    }

    Result<ModuleString> run();

private:
    Result<std::size_t> expand(Modules const& modules, std::size_t at, std::size_t parameter);
    bool is_full() const
    {
        return result_.size() > options_.limit.modules
            || result_.byte_size() > options_.limit.bytes;
    }

    Model const& model_;
    ModuleString const& string_;
    HomomorphismOptions const& options_;
    Machine machine_;
    CallStack stack_;
    std::vector<std::unique_ptr<Expander>> expanders_;
    Branches branches_;
    std::size_t next_call_ = 0;
    ModuleString result_;
};

Result<ModuleString> Homomorphism::run()
{
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < string_.size();) {
        Modules const rest { string_.kinds.data() + i, string_.parameters.data() + parameter,
                             string_.size() - i };
        auto const count = TRY(expand(rest, i, parameter));
        for (std::size_t k = 0; k < count; ++k) {
            auto const kind = rest.kinds[k];
            if (stack_.is_call(kind) && next_call_ < string_.calls.size())
                stack_.enter(string_.calls[next_call_++]);
            else if (stack_.is_end(kind) && stack_.depth() > 0)
                stack_.leave();
            parameter += model_.alphabet[kind].parameter_count;
        }
        i += count;
    }
    result_.globals = string_.globals;
    result_.arrays = string_.arrays;
    result_.calls = string_.calls;
    result_.seed = string_.seed;
    return std::move(result_);
}

// Appends what the first module becomes; returns how many have been read.
Result<std::size_t> Homomorphism::expand(Modules const& modules, std::size_t at,
                                         std::size_t parameter)
{
    auto& machine = stack_.machine(stack_.current());
    machine.begin_module(kHomomorphismStep, at);
    Surroundings const around {
        &string_,  &branches_, at,
        parameter, at + 1,     parameter + model_.alphabet[modules.kinds[0]].parameter_count
    };
    auto const count = expanders_[stack_.current()]->expand(
        modules, around, [&](Modules const& drawn) -> std::size_t {
            result_.kinds.append(drawn.kinds, 1);
            result_.parameters.append(drawn.parameters,
                                      model_.alphabet[drawn.kinds[0]].parameter_count);
            return !is_full();
        });
    TRY(machine.check());
    if (is_full())
        return fail(Fault::User,
                    fmt::format("{}: the homomorphism makes more than {} modules, or {} MB of "
                                "them; derive fewer steps or raise the limit",
                                model_.name, options_.limit.modules, options_.limit.bytes >> 20));
    return count;
}

} // namespace

Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        HomomorphismOptions const& options)
{
    return Homomorphism(model, string, options).run();
}

} // namespace tractus
