#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/program.h"

#include <cstdint>
#include <map>
#include <vector>

namespace tractus::lsystem {

// Hands out the registers of the frame that the programs of a rule, or a block, share, and appends
// instructions to programs. Fails, as the user's fault and at the cursor's place, when there are
// more than a frame or a program can have.
class FrameBuilder {
public:
    explicit FrameBuilder(Cursor const& cursor)
        : cursor_(cursor)
    {
    }

    // A register of its own, behind all others.
    Result<Register> add(double value = 0);
    // The register of a number that never changes.
    Result<Register> constant(double value);
    // A register for an intermediate result.
    Result<Register> temporary();
    // The register is not needed any more; nothing happens unless it is a temporary one.
    void release(Register reg);

    bool is_constant(Register reg) const { return kinds_[reg] == Kind::Constant; }
    double value(Register reg) const { return frame_[reg]; }

    // The number of the next instruction of `program`, to jump to.
    Result<std::uint16_t> label(Program const& program) const;
    // Appends an instruction and releases its operands; the register of its result. Operations on
    // constants are carried out at once.
    Result<Register> emit(Op op, Register left, Register right, Program& program);

    // The initial frame. The last thing to be called.
    RegisterFile take_frame() { return std::move(frame_); }

private:
    enum class Kind : std::uint8_t { Own, Constant, Temporary };

    Cursor const& cursor_;
    RegisterFile frame_;
    std::vector<Kind> kinds_; // One per register.
    std::map<double, Register> constants_;
    std::vector<Register> free_temporaries_;
};

} // namespace tractus::lsystem
