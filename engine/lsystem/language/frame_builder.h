#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/program.h"

#include <cstdint>
#include <map>
#include <vector>

namespace tractus::lsystem {

// Allocates registers in the frame that the programs of a rule or block share, and appends
// instructions to these programs. Fails with a user error at the cursor's position if the frame or
// a program becomes too large.
class FrameBuilder {
public:
    explicit FrameBuilder(Cursor const& cursor)
        : cursor_(cursor)
    {
    }

    // Allocates a register that is never freed.
    Result<Register> add(double value = 0);
    // Returns the register of a constant, which is allocated if it is new.
    Result<Register> constant(double value);
    // Allocates a register for an intermediate result.
    Result<Register> temporary();
    // Frees a temporary register; does nothing for other registers.
    void release(Register reg);

    bool is_constant(Register reg) const { return kinds_[reg] == Kind::Constant; }
    double value(Register reg) const { return frame_[reg]; }

    // Returns the index of the next instruction of `program`, as a jump target.
    Result<std::uint16_t> label(Program const& program) const;
    // Appends an instruction and frees those of its operands that are temporary. Returns the
    // register of the result. Operations on constants are evaluated at compile time.
    Result<Register> emit(Op op, Register left, Register right, Program& program);

    // Returns the initial values of the registers. Must be the last call.
    RegisterFile take_frame() { return std::move(frame_); }

private:
    enum class Kind : std::uint8_t { Own, Constant, Temporary };

    Cursor const& cursor_;
    RegisterFile frame_;
    std::vector<Kind> kinds_; // Kind of each register of the frame.
    std::map<double, Register> constants_;
    std::vector<Register> free_temporaries_;
};

} // namespace tractus::lsystem
