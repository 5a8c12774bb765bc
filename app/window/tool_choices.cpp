#include "app/window/tool_choices.h"

#include <cstddef>
#include <cstring>

namespace tractus {

namespace {

using Kind = Tool::Kind;

// The first of tool_choices() that a tool belongs to.
Kind family(Kind kind)
{
    switch (kind) {
    case Kind::DrawInOrder:
    case Kind::Oversketch:
    case Kind::Smooth:
    case Kind::Delete:
        return Kind::Draw;
    case Kind::MoveIndicator:
    case Kind::DeleteIndicator:
        return Kind::Indicate;
    default:
        return kind;
    }
}

class Meanings {
public:
    explicit Meanings(Tool const& hand)
        : hand_(hand)
    {
    }

    void add(char const* text, Tool const& tool)
    {
        constexpr float kLetter_px = 11.5f;
        constexpr float kAir_px = 36;
        meanings_.push_back({ .text = text,
                              .tool = tool,
                              .width = kAir_px + kLetter_px * static_cast<float>(std::strlen(text)),
                              .is_on = !tool.at_once && tool == hand_,
                              .begins_group = begins_group_ });
        begins_group_ = false;
    }

    void begin_group() { begins_group_ = true; }

    std::vector<Meaning> take() { return std::move(meanings_); }

private:
    Tool hand_;
    std::vector<Meaning> meanings_;
    bool begins_group_ = false;
};

void add_drawing(Tool const& hand, Meanings& meanings)
{
    bool const is_draw = hand.kind == Kind::Draw;
    meanings.add("Branch by branch", { .kind = Kind::DrawInOrder });
    auto const draw = [&](Propagation propagation, StrokeFit fit) {
        return Tool { .kind = Kind::Draw, .propagation = propagation, .fit = fit };
    };
    auto const fit = is_draw ? hand.fit : StrokeFit::Start;
    meanings.add("Selected", draw(Propagation::Selected, fit));
    meanings.add("All it bears", draw(Propagation::Descendants, fit));
    meanings.add("Both", draw(Propagation::Both, fit));
    if (is_draw) {
        meanings.begin_group();
        meanings.add("From its base", draw(hand.propagation, StrokeFit::Start));
        meanings.add("Base to tip", draw(hand.propagation, StrokeFit::Chord));
        meanings.add("As it lies", draw(hand.propagation, StrokeFit::World));
    }
    meanings.begin_group();
    meanings.add("Redraw", { .kind = Kind::Oversketch });
    meanings.add("Smooth", { .kind = Kind::Smooth, .at_once = true });
    meanings.add("Take away", { .kind = Kind::Delete, .at_once = true });
}

void add_selecting(Tool const& hand, Meanings& meanings)
{
    using Selecting = Tool::Selecting;
    auto const select = [&](Selecting selecting) {
        return Tool { .kind = Kind::Select, .selecting = selecting, .angle = hand.angle };
    };
    meanings.add("Path", select(Selecting::Path));
    meanings.add("By its ends", select(Selecting::Ends));
    meanings.add("Add", select(Selecting::Add));
    meanings.add("Take", select(Selecting::Take));
    meanings.add("Whole order", select(Selecting::Order));
    meanings.add("All alike", select(Selecting::Alike));
    meanings.begin_group();
    for (auto const& [text, selecting] :
         { std::pair("Invert", Selecting::Invert), std::pair("Nothing", Selecting::Nothing) }) {
        auto tool = select(selecting);
        tool.at_once = true;
        meanings.add(text, tool);
    }
}

void add_leaning(Tool const& hand, Meanings& meanings)
{
    using Indicator = MotionIndicator::Kind;
    bool const is_indicate = hand.kind == Kind::Indicate;
    auto const indicate = [](Tool::Reach reach, Indicator indicator) {
        return Tool { .kind = Kind::Indicate, .reach = reach, .indicator = indicator };
    };
    auto const indicator = is_indicate ? hand.indicator : Indicator::Push;
    auto const reach = is_indicate ? hand.reach : Tool::Reach::Everywhere;
    meanings.add("Everywhere", indicate(Tool::Reach::Everywhere, indicator));
    meanings.add("Selected and above", indicate(Tool::Reach::Below, indicator));
    meanings.add("Near it", indicate(Tool::Reach::Near, indicator));
    meanings.begin_group();
    meanings.add("Wind", indicate(reach, Indicator::Push));
    meanings.add("Light", indicate(reach, Indicator::Light));
    meanings.begin_group();
    meanings.add("Move", { .kind = Kind::MoveIndicator });
    meanings.add("Remove", { .kind = Kind::DeleteIndicator });
}

void add_erasing(Meanings& meanings)
{
    using Erasing = Tool::Erasing;
    meanings.add("Whole strokes", { .kind = Kind::Erase, .erasing = Erasing::Whole });
    meanings.add("What it touches", { .kind = Kind::Erase, .erasing = Erasing::Part });
}

} // namespace

std::array<ToolChoice, 4> tool_choices(Tool::Erasing erasing)
{
    return { { { "Draw", { .kind = Kind::DrawInOrder } },
               { "Select", { .kind = Kind::Select } },
               { "Lean", { .kind = Kind::Indicate } },
               { "Erase", { .kind = Kind::Erase, .erasing = erasing } } } };
}

bool is_same_tool(Tool const& one, Tool const& other)
{
    return family(one.kind) == family(other.kind);
}

std::vector<Meaning> meanings_of(Tool const& hand)
{
    Meanings meanings(hand);
    switch (family(hand.kind)) {
    case Kind::Draw:
        add_drawing(hand, meanings);
        break;
    case Kind::Select:
        add_selecting(hand, meanings);
        break;
    case Kind::Indicate:
        add_leaning(hand, meanings);
        break;
    case Kind::Erase:
        add_erasing(meanings);
        break;
    default:
        break;
    }
    return meanings.take();
}

} // namespace tractus
