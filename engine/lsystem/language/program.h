#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Index of a register in a program's frame.
using Register = std::uint16_t;

// Operation of an instruction on the registers `left` and `right`; the result goes to register
// `target`. Angles are in degrees and comparisons give 0 or 1. As in cpfg, division by zero gives
// the dividend.
enum class Op : std::uint8_t {
    Halt,
    Copy,
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder, // Remainder of the integer parts.
    Power,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    Negate,
    Not,
    IsTrue, // Gives 1 unless the operand is 0.
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2, // The angle of the point (left, right).
    Exp,
    Log,
    Floor,
    Ceil,
    Round, // Rounds to the nearest integer, halves upwards; cpfg calls it trunc().
    Abs,
    Sign,
    Sqrt,
    Random,   // Uniform distribution in [0, left).
    Normal,   // Normal distribution with mean `left` and standard deviation `right`.
    Beta,     // Beta distribution with the parameters left and right.
    Binomial, // Binomial distribution: `left` trials that succeed with probability `right`.
    SeedRandom,
    Function, // Value at `right` of the model's function number `left`, from 1.
    CurveX,   // X coordinate at parameter `right` of the model's curve number `left`, from 1.
    CurveY,
    CurveZ,
    CurveLength, // Length of the model's curve number `left`, from 1.
    Print,       // Prints `right` registers from `left` on by the model's format number `target`.
    LoadGlobal,  // register target <- global left.
    StoreGlobal, // global target <- register left.
    LoadArray,   // register target <- array left at index right.
    StoreArray,  // array target at index left <- register right.
    Jump,        // Jumps to instruction `target`.
    JumpIfZero,  // Jumps to instruction `target` if register `left` is 0.
};

struct Instruction {
    Op op = Op::Halt;
    std::uint16_t target = 0;
    std::uint16_t left = 0;
    std::uint16_t right = 0;
};

// Compiled code of a block of statements or of a part of a rule, such as its condition:
// three-address code over a frame of registers. Empty if there is nothing to compute.
using Program = std::vector<Instruction>;

// Returns true if running the program has side effects, so that the order of programs matters.
inline bool has_effects(Program const& program)
{
    return std::any_of(program.begin(), program.end(), [](Instruction const& instruction) {
        return instruction.op == Op::StoreGlobal || instruction.op == Op::StoreArray
            || instruction.op == Op::SeedRandom || instruction.op == Op::Print;
    });
}

// Initial values of the registers that a rule's programs share. First come the parameters of the
// matched modules, then constants, local variables and intermediate results. Constants never
// change, so a frame is copied once and used for every match.
using RegisterFile = std::vector<double>;

} // namespace tractus::lsystem
