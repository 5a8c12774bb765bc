#include "engine/methods/construction_lines/pattern.h"

namespace tractus::lines {

std::string name_of(Pattern::Kind kind)
{
    switch (kind) {
    case Pattern::Kind::Distichous:
        return "distichous";
    case Pattern::Kind::Decussate:
        return "decussate";
    case Pattern::Kind::Spiral:
        return "spiral";
    case Pattern::Kind::Alternate:
        return "alternate";
    case Pattern::Kind::Whorled:
        return "whorled";
    case Pattern::Kind::Bare:
        break;
    }
    return "bare";
}

double roll_deg(Pattern const& pattern)
{
    constexpr double kUp_deg = -90;
    switch (pattern.face) {
    case Pattern::Face::Flat:
        return 0;
    case Pattern::Face::Up:
        return kUp_deg;
    case Pattern::Face::Down:
        return -kUp_deg;
    case Pattern::Face::Pattern:
        break;
    }
    return pattern.kind == Pattern::Kind::Distichous ? 0 : kUp_deg;
}

int organs_at_node(Pattern const& pattern)
{
    switch (pattern.kind) {
    case Pattern::Kind::Distichous:
    case Pattern::Kind::Decussate:
        return 2;
    case Pattern::Kind::Spiral:
    case Pattern::Kind::Alternate:
        return 1;
    case Pattern::Kind::Whorled:
        return pattern.whorl;
    case Pattern::Kind::Bare:
        break;
    }
    return 0;
}

bool has_organs_all_around(Pattern const& pattern)
{
    return pattern.kind != Pattern::Kind::Distichous && pattern.kind != Pattern::Kind::Bare;
}

} // namespace tractus::lines
