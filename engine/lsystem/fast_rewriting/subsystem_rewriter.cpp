#include "engine/lsystem/fast_rewriting/subsystem_rewriter.h"

#include <algorithm>

namespace tractus::lsystem {

SubsystemRewriter::SubsystemRewriter(Model const& model, VirtualMachine& main,
                                     Branches const& branches)
    : model_(model)
    , main_(main)
    , stack_(model, main)
{
    for (std::size_t i = 0; i <= model.subsystems.size(); ++i) {
        plans_.push_back(std::make_unique<RulePlan>(model, stack_.system(i)));
        rewriters_.push_back(
            std::make_unique<RangeRewriter>(*plans_.back(), stack_.machine(i), branches));
        auto& stays = stays_.emplace_back();
        for (std::size_t k = 0; k < model.alphabet.kinds.size(); ++k) {
            auto const kind = static_cast<KindId>(k);
            stays[k] = plans_.back()->way(kind) == RulePlan::Way::Copy && !stack_.is_call(kind)
                && !stack_.is_end(kind);
            parameter_counts_[k] = model.alphabet[kind].parameter_count;
        }
    }
}

bool SubsystemRewriter::has_contexts() const
{
    return std::any_of(rewriters_.begin(), rewriters_.end(),
                       [](auto const& rewriter) { return rewriter->has_contexts(); });
}

Result<void> SubsystemRewriter::add_calls(ModuleString& string, std::size_t from,
                                          std::size_t from_parameter) const
{
    auto const* parameters = string.parameters.data() + from_parameter;
    for (auto i = from; i < string.size(); ++i) {
        auto const kind = string.kinds[i];
        if (stack_.is_call(kind)) {
            auto const subsystem = TRY(stack_.find(*parameters));
            string.calls.push_back(CallStack::new_call(model_, subsystem));
        }
        parameters += model_.alphabet[kind].parameter_count;
    }
    return {};
}

SubsystemRewriter::Run SubsystemRewriter::staying(std::size_t system, std::size_t at) const
{
    auto const& stays = stays_[system];
    Run run;
    for (auto i = at; i < in_->size() && stays[in_->kinds[i]]; ++i) {
        ++run.modules;
        run.parameters += parameter_counts_[in_->kinds[i]];
    }
    return run;
}

Result<void> SubsystemRewriter::rewrite(RangeRewriter::Task const& task, bool is_last_step)
{
    in_ = &task.in;
    out_ = &task.out;
    is_last_step_ = is_last_step;
    next_call_ = 0;
    out_->calls.clear();
    auto const* parameters = in_->parameters.data();
    for (std::size_t i = 0; i < in_->size();) {
        auto const system = stack_.current();
        // Runs that stay unchanged make up most of a string, so they are copied as a whole.
        if (auto const run = staying(system, i); run.modules > 0) {
            out_->kinds.append(in_->kinds.data() + i, run.modules);
            out_->parameters.append(parameters, run.parameters);
            main_.spend(run.modules);
            if (main_.has_stopped())
                return {};
            i += run.modules;
            parameters += run.parameters;
            continue;
        }
        auto const from = out_->size();
        auto const from_parameter = out_->parameters.size();
        auto const first_new_call = out_->calls.size();
        auto const parameter = static_cast<std::size_t>(parameters - in_->parameters.data());
        auto const count = rewriters_[system]->rewrite_module(task, i, parameter);
        main_.stop_too(stack_.machine(system).stop());
        if (main_.has_stopped() || out_->size() > task.limit.modules
            || out_->byte_size() > task.limit.bytes)
            return {};
        TRY(add_calls(*out_, from, from_parameter));
        bool const is_cut = model_.alphabet[in_->kinds[i]].symbol == '%' && out_->size() == from;
        auto const read = in_->kinds.span().subspan(i, count);
        TRY(follow(read, parameters, first_new_call, is_cut ? Read::Cut : Read::Rewritten));
        for (auto const kind : read)
            parameters += model_.alphabet[kind].parameter_count;
        i += count;
    }
    while (stack_.depth() > 0) // Sub-L-systems that no $ has ended end here.
        leave();
    return {};
}

Result<void> SubsystemRewriter::follow(std::span<KindId const> kinds, float const* parameters,
                                       std::size_t first_new_call, Read read)
{
    auto next = first_new_call;
    for (auto const kind : kinds) {
        if (stack_.is_call(kind)) {
            auto const subsystem = TRY(stack_.find(*parameters));
            bool const goes_on
                = next < out_->calls.size() && out_->calls[next].subsystem == subsystem;
            enter(goes_on ? next++ : kGone, read);
        } else if (stack_.is_end(kind) && stack_.depth() > 0) {
            leave();
        }
        parameters += model_.alphabet[kind].parameter_count;
    }
    return {};
}

void SubsystemRewriter::enter(std::size_t target, Read read)
{
    auto const& call = in_->calls[next_call_++];
    stack_.enter(call);
    targets_.push_back(target);
    auto const& system = stack_.system(stack_.current());
    if (read == Read::Cut)
        return;
    if (!call.has_started)
        run(system.start);
    run(system.start_each);
}

void SubsystemRewriter::leave()
{
    auto const& system = stack_.system(stack_.current());
    auto const target = targets_.back();
    targets_.pop_back();
    run(system.end_each);
    if (target == kGone || is_last_step_)
        run(system.end);
    auto call = stack_.leave();
    if (target != kGone)
        out_->calls[target] = std::move(call);
}

void SubsystemRewriter::run(Block const& block)
{
    auto& machine = stack_.machine(stack_.current());
    machine.run(block);
    main_.stop_too(machine.stop());
}

} // namespace tractus::lsystem
