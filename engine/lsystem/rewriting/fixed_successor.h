#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace tractus::lsystem {

// The successor of a module if it is known in advance: each of its parameters is a constant or a
// parameter of the module. A short successor, of at most kShort modules, is copied in one move.
struct FixedSuccessor {
    static constexpr std::size_t kShort = 16;

    std::array<KindId, kShort> first_kinds {};
    std::uint32_t length = 0;
    std::uint32_t parameter_count = 0;      // Number of parameters of the successor.
    std::uint32_t read_parameter_count = 0; // Number of parameters of the replaced module.
    KindId const* kinds = nullptr;
    // Registers of the successor's parameters; nullptr if these are the module's parameters, in
    // order.
    Register const* parameters = nullptr;
    double const* frame = nullptr;

    // Makes the successor of a module to which no rule applies: the module itself.
    static FixedSuccessor copy(KindId kind, std::uint32_t parameter_count)
    {
        FixedSuccessor result;
        result.first_kinds[0] = kind;
        result.length = 1;
        result.parameter_count = parameter_count;
        result.read_parameter_count = parameter_count;
        return result;
    }

    // Makes the successor for a rule without a program, which must outlive this object.
    static FixedSuccessor of(Rule const& rule)
    {
        FixedSuccessor result;
        result.length = static_cast<std::uint32_t>(rule.successor.kinds.size());
        result.parameter_count = static_cast<std::uint32_t>(rule.successor.parameters.size());
        result.read_parameter_count = static_cast<std::uint32_t>(rule.predecessor_parameter_count);
        result.kinds = rule.successor.kinds.data();
        result.parameters = rule.successor.parameters.data();
        result.frame = rule.frame.data();
        std::copy_n(result.kinds, std::min<std::size_t>(result.length, kShort),
                    result.first_kinds.begin());
        return result;
    }

    // Writes the kinds of the successor and advances `to`, which must have room for at least kShort
    // kinds.
    void write_kinds(KindId*& to) const
    {
        if (length <= kShort)
            std::memcpy(to, first_kinds.data(), kShort);
        else
            std::memcpy(to, kinds, length);
        to += length;
    }

    // Writes the successor of a module whose parameters are at `from`. `to` must have room for at
    // least kShort kinds.
    void write(float const* from, ModuleWriter& to) const
    {
        write_kinds(to.kinds);
        write_parameters(from, to.parameters);
    }

    // Like write(), for `to` with room for exactly this successor.
    void write_exact_size(float const* from, ModuleWriter& to) const
    {
        to.kinds = std::copy_n(length <= kShort ? first_kinds.data() : kinds, length, to.kinds);
        write_parameters(from, to.parameters);
    }

private:
    void write_parameters(float const* from, float*& to) const
    {
        for (std::uint32_t i = 0; i < parameter_count; ++i) {
            auto const reg = parameters ? parameters[i] : static_cast<Register>(i);
            *to++ = reg < read_parameter_count ? from[reg] : static_cast<float>(frame[reg]);
        }
    }
};

} // namespace tractus::lsystem
