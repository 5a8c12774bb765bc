#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// One register of a program's frame.
using Register = std::uint16_t;

// Operation of an instruction with the registers `left` and `right`; the result goes to `target`.
// Angles are in degrees, comparisons give 0 or 1, and division by zero gives the dividend, as cpfg
// has it.
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
    IsTrue, // 1 unless zero.
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
    Round, // cpfg's trunc(): to the nearest integer, halves up.
    Abs,
    Sign,
    Sqrt,
    Random,   // Uniform in [0, left).
    Normal,   // Mean left, standard deviation right.
    Beta,     // Beta distribution with the parameters left and right.
    Binomial, // left trials that succeed with probability right.
    SeedRandom,
    Function, // The value at `right` of the model's function number `left`, from 1.
    CurveX,   // X of the point at `right` of the model's curve number `left`, from 1.
    CurveY,
    CurveZ,
    CurveLength, // Length of the model's curve number `left`, from 1.
    Print,       // Prints by the model's format number `target`: `right` registers from `left` on.
    LoadGlobal,  // target <- global left.
    StoreGlobal, // global target <- left.
    LoadArray,   // target <- array left at index right.
    StoreArray,  // array target at index left <- right.
    Jump,        // Goes to instruction `target`.
    JumpIfZero,  // Goes to instruction `target` when register left is 0.
};

struct Instruction {
    Op op = Op::Halt;
    std::uint16_t target = 0;
    std::uint16_t left = 0;
    std::uint16_t right = 0;
};

// A piece of a rule (its condition, its successor's parameters) or a block of statements, compiled
// to three-address code over a frame of registers. Empty when there is nothing to do.
using Program = std::vector<Instruction>;

// Whether running it can be noticed elsewhere, so that the order of programs matters.
inline bool has_effects(Program const& program)
{
    return std::any_of(program.begin(), program.end(), [](Instruction const& instruction) {
        return instruction.op == Op::StoreGlobal || instruction.op == Op::StoreArray
            || instruction.op == Op::SeedRandom || instruction.op == Op::Print;
    });
}

// The registers that the programs of one rule share. The first hold the parameters of the matched
// modules, the others constants, local variables and intermediate results. Constants never change,
// so a frame is copied from here once and used for every match.
using RegisterFile = std::vector<double>;

} // namespace tractus::lsystem
