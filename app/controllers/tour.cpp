#include "app/controllers/tour.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

namespace tractus::controllers {

namespace {

// The tasks of the steps; each step has one.
enum class Task { Watch, Limb, Wind, Leaves, Season, Many, Export, End };

constexpr std::array kTasks { Task::Watch,  Task::Limb, Task::Wind,   Task::Leaves,
                              Task::Season, Task::Many, Task::Export, Task::End };

// True if a command does the task.
bool does(view::WindowCommand const& command, Task task)
{
    if (auto const* const leaves = std::get_if<view::SetActiveFoliage>(&command))
        return task == Task::Leaves && (!leaves->leaves.empty() || leaves->drawn != 0);
    if (auto const* const season = std::get_if<view::ChangeSeason>(&command))
        return task == Task::Season && season->season.has_value()
            && season->slider == view::ChangeGrowth::Slider::Released;
    if (auto const* const collection = std::get_if<view::RequestCollection>(&command))
        return task == Task::Many && collection->count > 0;
    return task == Task::Export && std::holds_alternative<view::ExportPlant>(command);
}

// True if the drawing has changed since the beginning of the step as the task demands.
bool does(TourFacts const& before, TourFacts const& now, Task task)
{
    switch (task) {
    case Task::Watch:
        return now.is_hand_over;
    case Task::Limb:
        return now.strokes > before.strokes;
    case Task::Wind:
        return now.indicators > before.indicators;
    default:
        return false;
    }
}

std::string describe_limb(TourHands const& hands)
{
    std::string const how = hands.mouse_draws
        ? "Hold the left button on the drawing pad, near the trunk, and draw outwards."
        : "Set the pen down near the trunk, and draw outwards.";
    return how
        + (hands.mouse_moves_surface
               ? " The mouse wheel lifts the surface: roll it while you draw, and the limb rises."
               : " Lift the surface while you draw, and the limb rises.");
}

struct TaskWords {
    std::string task;
    std::string how;
};

TaskWords words_for_task(Task task, TourHands const& hands)
{
    switch (task) {
    case Task::Watch:
        return { "A hand draws a tree",
                 "First its trunk, then once around its crown. The program adds branches and "
                 "leaves." };
    case Task::Limb:
        return { "Now you: draw a limb", describe_limb(hands) };
    case Task::Wind:
        return { "Let the wind blow",
                 "Draw one line beside the tree: the wind blows along it, and branches lean." };
    case Task::Leaves:
        return { "Give it other leaves",
                 "Press Menu, then Leaves..., choose one, and press Put on the plant." };
    case Task::Season:
        return { "Choose a season", "In the menu's page Plant, drag the slider no season." };
    case Task::Many:
        return { "See many of its kind",
                 "Press Many: no two are alike, and all keep what you drew." };
    case Task::Export:
        return { "Take it with you",
                 "In the menu's page Keep, press Export .glb: Blender and browsers open it." };
    case Task::End:
        break;
    }
    return { "That was the tour",
             "All that was drawn is kept. Go on drawing here, or begin anew by New ... in the "
             "menu." };
}

} // namespace

void Tour::take(view::WindowCommand const& command)
{
    if (does(command, kTasks[step_]))
        go_on();
}

void Tour::look(TourFacts const& facts)
{
    facts_ = facts;
    // After an undo, what is drawn next counts.
    at_begin_.strokes = std::min(at_begin_.strokes, facts.strokes);
    at_begin_.indicators = std::min(at_begin_.indicators, facts.indicators);
    if (does(at_begin_, facts_, kTasks[step_]))
        go_on();
}

void Tour::skip()
{
    go_on();
}

void Tour::go_on()
{
    if (step_ + 1 == kTasks.size())
        return;
    ++step_;
    at_begin_ = facts_;
}

bool Tour::waits_for_hand() const
{
    return kTasks[step_] == Task::Watch;
}

std::string_view Tour::tool() const
{
    switch (kTasks[step_]) {
    case Task::Limb:
        return "draw_limb";
    case Task::Wind:
        return "indicate";
    default:
        return {};
    }
}

view::TourView Tour::view(TourHands const& hands) const
{
    auto words = words_for_task(kTasks[step_], hands);
    return { .task = std::move(words.task),
             .how = std::move(words.how),
             .step = step_ + 1,
             .count = kTasks.size(),
             .is_last = kTasks[step_] == Task::End };
}

} // namespace tractus::controllers
