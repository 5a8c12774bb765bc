#include "engine/base/check.h"
#include "engine/lsystem/derivation/features.h"
#include "engine/lsystem/language/model.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace tractus; // NOLINT(google-build-using-namespace): one function.

// Checks every instruction of a program: its registers must be within the frame, its jumps within
// the program, and its kinds within the alphabet.
static void check_program(lsystem::Program const& program, lsystem::RegisterFile const& frame)
{
    for (auto const& instruction : program) {
        bool const jumps
            = instruction.op == lsystem::Op::Jump || instruction.op == lsystem::Op::JumpIfZero;
        if (jumps)
            CHECK(instruction.target <= program.size());
        else if (instruction.op == lsystem::Op::Print)
            CHECK(std::size_t { instruction.left } + instruction.right <= frame.size());
        else
            CHECK(instruction.op == lsystem::Op::Halt || instruction.op == lsystem::Op::Jump
                  || instruction.op == lsystem::Op::StoreGlobal
                  || instruction.op == lsystem::Op::StoreArray
                  || instruction.target < frame.size());
    }
}

static void check_rules(lsystem::Model const& model, lsystem::RuleSet const& rules)
{
    for (auto const& rule : rules.rules) {
        CHECK(!rule.predecessor.empty());
        CHECK(rule.parameter_count <= rule.frame.size());
        std::size_t parameters = 0;
        for (auto const kind : rule.successor.kinds) {
            CHECK(kind < model.alphabet.kinds.size());
            parameters += model.alphabet[kind].parameter_count;
        }
        CHECK(parameters == rule.successor.parameters.size());
        for (auto const reg : rule.successor.parameters)
            CHECK(reg < rule.frame.size());
        check_program(rule.condition, rule.frame);
        check_program(rule.successor_program, rule.frame);
        check_program(rule.probability, rule.frame);
    }
}

static void check_system(lsystem::Model const& model, lsystem::LSystem const& system)
{
    for (auto const* rules : { &system.rules, &system.decomposition, &system.homomorphism })
        check_rules(model, *rules);
    for (auto const* block : { &system.axiom_program, &system.start, &system.start_each,
                               &system.end_each, &system.end })
        check_program(block->program, block->frame);
    for (auto const& external : system.externals)
        CHECK(external.index < (external.is_array ? system.arrays.size() : system.globals.size()));
}

// Fuzzes the way from text to compiled model. The input is a model's rules without a view.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    lsystem::ModelSource source;
    source.text.assign(reinterpret_cast<char const*>(data), size);
    auto const model = lsystem::compile_model(source);
    if (!model) {
        CHECK(model.error().fault == Fault::User);
        CHECK(model.error().message.find("model.l:") == 0);
        return 0;
    }
    check_system(*model, *model);
    for (auto const& system : model->subsystems)
        check_system(*model, system);
    CHECK(!lsystem::features_used(*model).empty());
    return 0;
}
