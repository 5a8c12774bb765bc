// This file contains the turtle's fast path for long runs of the most frequent symbols.
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/turtle/turtle.h"

#include <algorithm>

namespace tractus::lsystem {

Turtle::Quick Turtle::quick_case(SymbolAction does)
{
    switch (does) {
    case SymbolAction::Nothing:
        return Quick::Nothing;
    case SymbolAction::Draw:
    case SymbolAction::Move:
        return Quick::Step;
    case SymbolAction::Turn:
        return Quick::Turn;
    case SymbolAction::Pitch:
        return Quick::Pitch;
    case SymbolAction::Roll:
        return Quick::Roll;
    case SymbolAction::Push:
        return Quick::Push;
    case SymbolAction::Pop:
        return Quick::Pop;
    case SymbolAction::Width:
        return Quick::Width;
    case SymbolAction::At:
        return Quick::Level;
    default:
        return Quick::Other;
    }
}

Turtle::Kind Turtle::describe(ModuleKind const& kind)
{
    auto const& symbol = turtle_symbol(kind.symbol);
    using enum SymbolAction;
    auto const does = symbol.does;
    Kind result;
    result.symbol = kind.symbol;
    result.parameter_count = kind.parameter_count;
    result.is_single = does != At && does != Organ && does != Call && does != Cut;
    result.draws = does == Draw;
    result.sign = symbol.sign;
    result.quick = quick_case(does);
    return result;
}

std::size_t Turtle::draw_plain(std::span<KindId const> kinds, float const*& parameters,
                               std::size_t place, std::array<bool, 256> const& stops)
{
    Symbol symbol;
    std::size_t i = 0;
    while (i < kinds.size()) {
        if (!has_extras_ && is_quick(state_) && polygons_.empty())
            i += draw_quick(kinds.subspan(i), parameters, stops);
        if (i == kinds.size() || stops[kinds[i]])
            break;
        auto const& kind = kinds_[kinds[i]];
        std::size_t length = 1;
        symbol.name = { kind.symbol };
        symbol.count = kind.parameter_count;
        if (!kind.is_single) {
            length = name_at_symbol(kinds.subspan(i), symbol);
            if (length == 0)
                break;
        }
        symbol.parameters = parameters;
        parameters += symbol.count;
        place_ = place + i;
        i += length;
        draw_symbol(symbol);
    }
    return i;
}

// Returns the number of modules of the @-symbol at the beginning of `kinds`. Returns 0 if there is
// none, if it is a cut, or if it may continue past the end of `kinds`.
std::size_t Turtle::name_at_symbol(std::span<KindId const> kinds, Symbol& symbol) const
{
    if (turtle_symbol(kinds_[kinds[0]].symbol).does != SymbolAction::At
        || kinds.size() < symbol.name.size())
        return 0;
    auto const length = symbol_length(model_.alphabet, kinds);
    if (length == 1 || at_symbol(kinds_[kinds[1]].symbol).does == AtSymbolAction::Cut)
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        symbol.name[i] = kinds_[kinds[i]].symbol;
    symbol.count = kinds_[kinds[length - 1]].parameter_count;
    return length;
}

// The turtle's state is copied to a local variable: in memory, each symbol would have to wait for
// the writes of the one before it.
std::size_t Turtle::draw_quick(std::span<KindId const> kinds, float const*& parameters,
                               std::array<bool, 256> const& stops)
{
    auto state = state_;
    auto const* next = parameters;
    bool goes_on = true;
    std::size_t i = 0;
    while (i < kinds.size() && !stops[kinds[i]]) {
        auto const* kind = &kinds_[kinds[i]];
        auto const value = [&](double otherwise) {
            return kind->parameter_count > 0 ? static_cast<double>(*next) : otherwise;
        };
        auto const turn = [&](Vec3& a, Vec3& b) {
            auto const& angle = angles_.at(value(view_.angle_increment_deg));
            TurtleFrame::rotate(a, b, kind->sign * angle.sine, angle.cosine);
        };
        switch (kind->quick) {
        case Quick::Nothing:
            break;
        case Quick::Step:
            goes_on = step_quickly(state, value(1) * state.scale * options_.unit_mm, kind->draws);
            break;
        case Quick::Turn:
            turn(state.frame.heading, state.frame.left);
            break;
        case Quick::Pitch:
            turn(state.frame.heading, state.frame.down);
            break;
        case Quick::Roll:
            turn(state.frame.left, state.frame.down);
            break;
        case Quick::Push:
            save(state);
            state.place.is_open = false;
            break;
        case Quick::Pop:
            goes_on = restore_quickly(state);
            break;
        case Quick::Width:
            set_width(state, kind->parameter_count > 0, value(kind->sign));
            break;
        case Quick::Level:
            goes_on = i + 1 < kinds.size() && kind->parameter_count == 0
                && at_symbol(kinds_[kinds[i + 1]].symbol).does == AtSymbolAction::Level;
            if (goes_on) {
                kind = &kinds_[kinds[++i]];
                state.frame.roll_horizontal();
            }
            break;
        case Quick::Other:
            goes_on = false;
        }
        if (!goes_on)
            break;
        next += kind->parameter_count;
        ++i;
    }
    state_ = state;
    parameters = next;
    return i;
}

} // namespace tractus::lsystem
