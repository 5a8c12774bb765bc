#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Index of a register in a program's frame.
using Register = std::uint16_t;

// Operation of an instruction on the registers `left` and `right`, whose result goes to register
// `target`. Angles are in degrees; comparisons give 0 or 1. As in cpfg, a division by zero gives
// the dividend.
enum class Op : std::uint8_t {
    Halt,
    Copy,
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder, // Remainder of the division of the operands' integer parts.
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
    Atan2, // Angle of the point (left, right), counter-clockwise from the first axis.
    Exp,
    Log,
    Floor,
    Ceil,
    Round, // Rounds to the nearest integer, halves upwards; cpfg calls it trunc().
    Abs,
    Sign,
    Sqrt,
    Random, // Random number, uniformly distributed in [0, left).
    Normal, // Random number, normally distributed with mean `left` and standard deviation `right`.
    Beta,   // Random number of the beta distribution with the parameters `left` and `right`.
    Binomial, // Random number of successes in `left` trials, each of probability `right`.
    SeedRandom,
    Function, // Value at `right` of the model's function number `left`, counted from 1.
    // X coordinate, at parameter `right`, of the model's curve number `left`, counted from 1.
    CurveX,
    CurveY,
    CurveZ,
    CurveLength, // Length of the model's curve number `left`, counted from 1.
    // Prints `right` registers, from register `left` on, by the model's format number `target`.
    Print,
    LoadGlobal,  // Register `target` = global variable number `left`.
    StoreGlobal, // Global variable number `target` = register `left`.
    // Register `target` = element, at the index in register `right`, of array number `left`.
    LoadArray,
    // Element, at the index in register `left`, of array number `target` = register `right`.
    StoreArray,
    Jump,       // Continues with instruction number `target`.
    JumpIfZero, // Continues with instruction number `target` if register `left` is 0.
};

struct Instruction {
    Op op = Op::Halt;
    std::uint16_t target = 0;
    std::uint16_t left = 0;
    std::uint16_t right = 0;
};

// Compiled code of a block of statements or of a part of a rule, such as its condition:
// three-address code that works on a frame of registers. Empty if there is nothing to compute.
using Program = std::vector<Instruction>;

// Returns true if running the program has side effects, so that the order in which programs run
// matters.
inline bool has_effects(Program const& program)
{
    return std::any_of(program.begin(), program.end(), [](Instruction const& instruction) {
        return instruction.op == Op::StoreGlobal || instruction.op == Op::StoreArray
            || instruction.op == Op::SeedRandom || instruction.op == Op::Print;
    });
}

// Initial values of the registers that a rule's programs share. First come the parameters of the
// matched modules, then constants, local variables and intermediate results. Constants never
// change, so one copy of these values serves for all matches.
using RegisterFile = std::vector<double>;

} // namespace tractus::lsystem
