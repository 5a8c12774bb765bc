#include "engine/lsystem/language/local_variables.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tractus::lsystem {

static bool reads(Instruction const& instruction, Register variable)
{
    auto const [op, target, left, right] = instruction;
    switch (op) {
    case Op::Halt:
    case Op::LoadGlobal:
    case Op::Jump:
        return false;
    case Op::LoadArray:
        return right == variable;
    case Op::Print:
        return variable >= left && variable - left < right;
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Remainder:
    case Op::Power:
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
    case Op::Equal:
    case Op::NotEqual:
    case Op::Atan2:
    case Op::Normal:
    case Op::Beta:
    case Op::Binomial:
    case Op::Function:
    case Op::CurveX:
    case Op::CurveY:
    case Op::CurveZ:
    case Op::StoreArray:
        return left == variable || right == variable;
    default:
        return left == variable;
    }
}

static bool sets(Instruction const& instruction, Register variable)
{
    auto const op = instruction.op;
    bool const has_result = op != Op::Halt && op != Op::Print && op != Op::StoreGlobal
        && op != Op::StoreArray && op != Op::Jump && op != Op::JumpIfZero;
    return has_result && instruction.target == variable;
}

namespace {

enum class Reaches { Read, End, Neither };

// Determines what the program may reach before it sets the variable: an instruction that reads the
// variable, the program's end, or neither.
Reaches follow(Program const& program, Register variable)
{
    std::vector<bool> seen(program.size() + 1);
    std::vector<std::size_t> open { 0 };
    bool reaches_end = false;
    while (!open.empty()) {
        auto const at = open.back();
        open.pop_back();
        if (at >= program.size() || program[at].op == Op::Halt) {
            reaches_end = true;
            continue;
        }
        if (seen[at])
            continue;
        seen[at] = true;
        auto const& instruction = program[at];
        if (reads(instruction, variable))
            return Reaches::Read;
        if (sets(instruction, variable))
            continue;
        if (instruction.op == Op::Jump || instruction.op == Op::JumpIfZero)
            open.push_back(instruction.target);
        if (instruction.op != Op::Jump)
            open.push_back(at + 1);
    }
    return reaches_end ? Reaches::End : Reaches::Neither;
}

} // namespace

bool is_read_before_set(Rule const& rule, Register variable)
{
    struct Part {
        Program const& program;
        bool has_result;
        Register result;
    };
    for (auto const& [program, has_result, result] :
         { Part { rule.condition, rule.has_condition, rule.condition_result },
           Part { rule.probability, rule.has_probability, rule.probability_result },
           Part { rule.successor_program, false, 0 } }) {
        auto const reached = follow(program, variable);
        if (reached == Reaches::Neither)
            return false;
        if (reached == Reaches::Read || (has_result && result == variable))
            return true;
    }
    auto const& parameters = rule.successor.parameters;
    return std::find(parameters.begin(), parameters.end(), variable) != parameters.end();
}

} // namespace tractus::lsystem
