#pragma once

#include "engine/lsystem/rewriting/rewriter.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Rewrites a module, and the modules of its successor, repeatedly until no rule matches or the
// maximum depth of the rule set is reached: the way in which decomposition and homomorphism rules
// are applied. Contexts are matched around the module in the original string.
class Expander {
public:
    // Makes an expander for rules of one L-system of the model; by default of the main one.
    Expander(Model const& model, LSystem const& system, RuleSet const& rules,
             VirtualMachine& machine)
        : model_(model)
        , rules_(rules)
        , machine_(machine)
        , rewriter_(model, system, rules, machine)
    {
    }
    Expander(Model const& model, RuleSet const& rules, VirtualMachine& machine)
        : Expander(model, model, rules, machine)
    {
    }

    bool has_rules(KindId kind) const { return rules_.max_depth > 0 && rewriter_.has_rules(kind); }

    bool has_contexts() const { return rewriter_.has_contexts(); }

    // Expands the first of `modules` and passes the result to `sink`. The sink is a callable that
    // takes Modules, reads one turtle symbol or module of them, and returns the number of modules
    // that it has read. Returns the number of `modules` that were read: more than one for a long
    // predecessor, and 0 if the sink has returned 0 or the machine has stopped.
    template<typename Sink>
    std::size_t expand(Modules const& modules, Surroundings const& around, Sink&& sink)
    {
        auto const* const rule
            = rules_.max_depth > 0 ? rewriter_.find(modules, around, false) : nullptr;
        if (!rule)
            return sink(modules);
        levels_.clear();
        buffer_.kinds.clear();
        buffer_.parameters.clear();
        push(*rule);
        while (!levels_.empty()) {
            auto& level = levels_.back();
            if (level.next == level.end) {
                buffer_.kinds.set_size(level.begin);
                buffer_.parameters.set_size(level.begin_parameters);
                levels_.pop_back();
                continue;
            }
            Modules const rest { buffer_.kinds.data() + level.next,
                                 buffer_.parameters.data() + level.next_parameters,
                                 level.end - level.next };
            Rule const* inner = nullptr;
            if (levels_.size() < static_cast<std::size_t>(rules_.max_depth)
                && has_rules(rest.kinds[0]))
                inner = rewriter_.find(rest, around, false);
            auto const count = inner ? inner->predecessor.size() : sink(rest);
            if (count == 0 || machine_.has_stopped())
                return 0;
            for (std::size_t i = 0; i < count; ++i)
                level.next_parameters += model_.alphabet[rest.kinds[i]].parameter_count;
            level.next += count;
            if (inner)
                push(*inner); // The push invalidates `level` and `rest`.
            if (inner && buffer_.byte_size() > machine_.memory_limit()) {
                machine_.stop_too(VirtualMachine::Stop::Memory);
                return 0;
            }
        }
        return rule->predecessor.size();
    }

private:
    // The successor of one rule, stored in buffer_. A level is removed when its last module has
    // been read.
    struct Level {
        std::size_t begin = 0;
        std::size_t begin_parameters = 0;
        std::size_t next = 0;
        std::size_t next_parameters = 0;
        std::size_t end = 0;
    };

    void push(Rule const& rule)
    {
        Level level;
        level.begin = level.next = buffer_.kinds.size();
        level.begin_parameters = level.next_parameters = buffer_.parameters.size();
        rewriter_.apply(rule, buffer_);
        machine_.spend(1);
        level.end = buffer_.kinds.size();
        levels_.push_back(level);
    }

    Model const& model_;
    RuleSet const& rules_;
    VirtualMachine& machine_;
    Rewriter rewriter_;
    ModuleString buffer_;
    std::vector<Level> levels_;
};

} // namespace tractus::lsystem
