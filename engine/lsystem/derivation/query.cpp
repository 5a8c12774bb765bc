#include "engine/lsystem/derivation/query.h"

#include "engine/lsystem/language/print.h"
#include "engine/lsystem/rewriting/homomorphism.h"
#include "engine/lsystem/turtle/turtle.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string_view>

namespace tractus::lsystem {

namespace {

constexpr std::string_view kQueries = "PHLUQE";

// Converts a vector from the plant's space to cpfg's space; the inverse of from_model().
Vec3 to_model(Vec3 const& v)
{
    return { v.x(), v.z(), 0 - v.y() }; // Subtracting from 0 avoids -0, which would be printed.
}

class Questioning {
public:
    Questioning(Model const& model, ModuleString& string, VirtualMachine const& main)
        : model_(model)
        , string_(string)
        , machine_(main)
        , walk_(model, string, machine_)
        , turtle_(model, options_)
        , keeps_cuts_(keeps_cuts(model))
    {
        machine_.set_printer(nullptr);
        turtle_.begin(turtle_.start(), drawing_);
        turtle_.set_kept(string.turtles);
        string.cuts.clear();
    }

    Result<void> run();
    std::vector<EnvironmentQuery> const& environment_queries() const { return queries_; }

private:
    std::size_t draw(Modules const& modules);
    void keep();
    void answer(char query, std::span<float> parameters) const;
    void ask_environment(Modules const& modules, std::size_t length, std::span<float> parameters);

    // Maximum size of the drawing. It is discarded whenever it becomes larger, since only the
    // turtle's frame is needed.
    static constexpr std::size_t kMaxParts = 65'536;
    // Maximum number of stored turtle states. Each needs as much memory as many modules.
    static constexpr std::size_t kMaxKept = 1'000'000;

    Model const& model_;
    ModuleString& string_;
    VirtualMachine machine_;
    HomomorphismWalk walk_;
    TurtleOptions const options_ { .unit_mm = 1 };
    TurtleDrawing drawing_;
    Turtle turtle_;
    std::vector<EnvironmentQuery> queries_;
    bool keeps_cuts_;
    std::vector<CutTurtle> kept_; // Turtle states at the cuts in the present string.
};

Result<void> Questioning::run()
{
    while (!walk_.is_at_end()) {
        TRY(walk_.read([&](Modules const& modules) { return draw(modules); }));
        if (turtle_.take_cut())
            walk_.cut();
        if (drawing_.part_count() > kMaxParts)
            turtle_.drop_drawing();
        if (string_.turtles.size() + kept_.size() > kMaxKept)
            return fail(Fault::User,
                        fmt::format("{}: %(x) keeps more than {} branches; derive "
                                    "fewer steps",
                                    model_.name, kMaxKept));
    }
    string_.turtles.insert(string_.turtles.end(), kept_.begin(), kept_.end());
    return {};
}

std::size_t Questioning::draw(Modules const& modules)
{
    bool const is_in_string = walk_.is_in_string(modules);
    auto const& first = model_.alphabet[modules.kinds[0]];
    auto const length = symbol_length(model_.alphabet, { modules.kinds, modules.count });
    if (first == ModuleKind { '%', 1 } && is_in_string && keeps_cuts_)
        keep();
    if (first.symbol != '?' || length != 2 || !is_in_string)
        return turtle_.draw(modules, walk_.at(), !is_in_string);
    auto const& query = model_.alphabet[modules.kinds[1]];
    auto const offset = static_cast<std::size_t>(modules.parameters - string_.parameters.data());
    std::span<float> const parameters { string_.parameters.data() + offset, query.parameter_count };
    if (query.symbol == 'E')
        ask_environment(modules, length, parameters);
    else
        answer(query.symbol, parameters);
    return length;
}

void Questioning::keep()
{
    string_.cuts.push_back({ walk_.at(), string_.turtles.size() + kept_.size() });
    kept_.push_back(turtle_.kept());
}

void Questioning::answer(char query, std::span<float> parameters) const
{
    auto const& frame = turtle_.state().frame;
    Vec3 const heading = to_model(frame.heading);
    Vec3 const left = to_model(frame.left);
    Vec3 const up = to_model(frame.down); // cpfg calls up what the frame calls `down`.
    std::array<double, 4> values {};
    std::size_t count = 3;
    if (query == 'Q') {
        Eigen::Matrix3d axes;
        axes << heading, left, -up;
        Quat const turn(axes);
        values = { turn.x(), turn.y(), turn.z(), turn.w() };
        count = 4;
    } else {
        Vec3 const vector = query == 'P' ? to_model(frame.position_mm)
            : query == 'H'               ? heading
            : query == 'L'               ? left
                                         : up;
        std::copy_n(vector.data(), 3, values.begin());
    }
    for (std::size_t i = 0; i < std::min(count, parameters.size()); ++i)
        parameters[i] = static_cast<float>(values[i]);
}

void Questioning::ask_environment(Modules const& modules, std::size_t length,
                                  std::span<float> parameters)
{
    auto const& state = turtle_.state();
    EnvironmentQuery query;
    query.module = walk_.at();
    query.position = to_model(state.frame.position_mm);
    query.heading = to_model(state.frame.heading);
    query.left = to_model(state.frame.left);
    query.up = to_model(state.frame.down);
    query.line_width = state.width;
    query.scale = state.scale;
    query.parameters = parameters;
    if (modules.count > length) {
        auto const& next = model_.alphabet[modules.kinds[length]];
        query.next_symbol = next.symbol;
        query.next_parameters = { parameters.data() + parameters.size(), next.parameter_count };
    }
    queries_.push_back(query);
}

} // namespace

bool keeps_cuts(Model const& model)
{
    return model.subsystems.empty() && find_kind(model.alphabet, { '%', 1 });
}

bool has_queries(Model const& model)
{
    auto const& kinds = model.alphabet.kinds;
    auto const has
        = [&](auto const& test) { return std::any_of(kinds.begin(), kinds.end(), test); };
    return has([](ModuleKind const& kind) {
               return kind == ModuleKind { '?', 0 };
           })
        && has([](ModuleKind const& kind) {
               return kind.parameter_count > 0
                   && kQueries.find(kind.symbol) != std::string_view::npos;
           });
}

Result<void> answer_queries(Model const& model, ModuleString& string, VirtualMachine const& main,
                            int step, Environment const& environment)
{
    Questioning questioning(model, string, main);
    TRY(questioning.run());
    auto const& queries = questioning.environment_queries();
    if (environment && !queries.empty())
        return environment(step, queries);
    return {};
}

} // namespace tractus::lsystem
