#include "engine/lsystem/turtle/turtle.h"

#include "engine/lsystem/language/print.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <string_view>

namespace tractus::lsystem {

static bool has_symbol(Model const& model, std::string_view symbols)
{
    return std::any_of(
        model.alphabet.kinds.begin(), model.alphabet.kinds.end(),
        [&](auto const& kind) { return symbols.find(kind.symbol) != std::string_view::npos; });
}

bool uses_turtle_extras(Model const& model)
{
    return !model.view.tropisms.empty() || (has_symbol(model, "@") && has_symbol(model, "TG"))
        || std::any_of(model.alphabet.kinds.begin(), model.alphabet.kinds.end(),
                       [](ModuleKind const& kind) {
                           return kind.symbol == '{'
                               && (kind.parameter_count == 1 || kind.parameter_count == 2);
                       });
}

bool uses_patches(Model const& model)
{
    return has_symbol(model, "@") && has_symbol(model, "P");
}

Turtle::Turtle(Model const& model, TurtleOptions const& options)
    : model_(model)
    , view_(model.view)
    , options_(options)
    , has_extras_(uses_turtle_extras(model))
{
    for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i)
        kinds_[i] = describe(model.alphabet.kinds[i]);
}

Turtle::Start Turtle::start() const
{
    Start start;
    start.state.width = view_.line_width;
    start.state.elasticity = view_.elasticity;
    start.state.color = static_cast<std::uint8_t>(view_.color);
    start.state.scale = view_.scale;
    for (std::size_t i = 0; i < tropism_count(); ++i)
        start.extras.elasticities[i] = view_.tropisms[i].elasticity;
    start.extras.style.sides = static_cast<std::uint16_t>(view_.contour_sides);
    return start;
}

void Turtle::begin(Start const& start, TurtleDrawing& drawing)
{
    drawing_ = &drawing;
    state_ = start.state;
    extras_ = start.extras;
    depth_ = 0;
    extras_stack_.clear();
    polygons_.clear();
    call_scales_.clear();
    cylinder_stack_.clear();
    patches_.clear();
    patch_numbers_.clear();
    patch_shapes_.clear();
    is_cut_ = false;
    has_unpaired_ = false;
}

void Turtle::drop_drawing()
{
    drawing_->clear();
    patch_numbers_.clear();
    patch_shapes_.clear();
    state_.place = {};
    for (auto& state : stack_)
        state.place = {};
    cylinder_.place = {};
    for (auto& cylinder : cylinder_stack_)
        cylinder.place = {};
}

Turtle::Start Turtle::branch_start() const
{
    Start start { state_, extras_ };
    start.state.place.is_open = false;
    if (start.state.place.segment != kNone && !drawing_->target.plant)
        start.state.place.segment = TurtleDrawing::kBelow;
    return start;
}

std::size_t Turtle::draw(Modules const& modules, std::size_t place, bool in_homomorphism)
{
    auto const length = symbol_length(model_.alphabet, { modules.kinds, modules.count });
    Symbol symbol;
    for (std::size_t i = 0; i < length; ++i)
        symbol.name[i] = kinds_[modules.kinds[i]].symbol;
    symbol.parameters = modules.parameters;
    symbol.count = kinds_[modules.kinds[length - 1]].parameter_count;
    place_ = place;
    if (!check(symbol))
        return length;
    bool const is_cut = turtle_symbol(symbol.name[0]).does == SymbolAction::Cut;
    if (is_cut && !in_homomorphism && symbol.count == 0)
        is_cut_ = !view_.draws_past_cut;
    else if (is_cut && !in_homomorphism)
        go_on_with(symbol);
    else
        draw_symbol(symbol);
    return length;
}

// Returns true if all parameters of a symbol are finite. Otherwise warns and returns false, since a
// parameter that is not finite would affect everything drawn after it.
bool Turtle::check(Symbol const& symbol)
{
    for (std::size_t i = 0; i < symbol.count; ++i)
        if (!std::isfinite(symbol.parameters[i])) {
            warn(fmt::format("{}: left out {} with a parameter that is not a number", model_.name,
                             std::string(symbol.name.begin(),
                                         std::find(symbol.name.begin(), symbol.name.end(), '\0'))));
            return false;
        }
    return true;
}

void Turtle::draw_symbol(Symbol const& symbol)
{
    auto& frame = state_.frame;
    auto const& what = turtle_symbol(symbol.name[0]);
    switch (what.does) {
    case SymbolAction::Draw:
    case SymbolAction::Move:
        return step(symbol);
    case SymbolAction::Turn:
        return turn(frame.heading, frame.left, symbol, what.sign);
    case SymbolAction::Pitch:
        return turn(frame.heading, frame.down, symbol, what.sign);
    case SymbolAction::Roll:
        return turn(frame.left, frame.down, symbol, what.sign);
    case SymbolAction::TurnRound:
        return TurtleFrame::rotate(frame.heading, frame.left, 0, -1);
    case SymbolAction::Push:
        return push();
    case SymbolAction::Pop:
        return pop();
    case SymbolAction::Width:
        return set_width(state_, symbol.count > 0, symbol.parameter(0, what.sign));
    case SymbolAction::Color:
        return set_color(symbol, what.sign);
    case SymbolAction::BendAsOlder:
        state_.elasticity = symbol.parameter(0, state_.elasticity + view_.elasticity_step);
        return;
    case SymbolAction::BeginPath:
        return begin_path(symbol);
    case SymbolAction::Dot:
        return add_dot(symbol);
    case SymbolAction::EndPath:
        return symbol.parameter(0, 0) == 0 ? close_polygon() : end_path();
    case SymbolAction::Organ:
        if (symbol.name[1] != 0)
            add_organ(symbol.name[1], symbol);
        return;
    case SymbolAction::At:
        return draw_at_symbol(symbol);
    case SymbolAction::Call:
        return enter_subsystem(symbol);
    case SymbolAction::Return:
        return leave_subsystem();
    case SymbolAction::Cut:
    case SymbolAction::Nothing:
        return;
    }
}

// Interprets ?(id) and ?(id,scale). As in cpfg, the scale multiplies that of the calling L-system,
// even if @D has changed the turtle's scale, and the line width changes with it.
void Turtle::enter_subsystem(Symbol const& symbol)
{
    if (model_.subsystems.empty() || symbol.count == 0 || symbol.name[1] != 0)
        return;
    double const outer = call_scales_.empty() ? view_.scale : call_scales_.back();
    double const scale = std::clamp(outer * symbol.parameter(1, 1), -1e6, 1e6);
    call_scales_.push_back(scale);
    state_.scale = scale;
    if (outer != 0)
        state_.width = std::clamp(state_.width * scale / outer, kMinWidth, 1e6);
}

CutTurtle Turtle::kept() const
{
    auto const& frame = state_.frame;
    return { frame.position_mm / options_.unit_mm,
             frame.heading,
             frame.left,
             frame.down,
             state_.width,
             state_.scale,
             state_.elasticity,
             state_.color };
}

// Interprets %(x,i): continues in the state that was stored at a cut.
void Turtle::go_on_with(Symbol const& symbol)
{
    double const number = symbol.parameter(1, -1);
    if (!(number >= 0) || number >= static_cast<double>(kept_.size()))
        return;
    auto const& kept = kept_[static_cast<std::size_t>(number)];
    state_.frame = { kept.position * options_.unit_mm, kept.heading, kept.left, kept.down };
    state_.width = kept.width;
    state_.scale = kept.scale;
    state_.elasticity = kept.elasticity;
    state_.color = kept.color;
    state_.place = {};
    extras_.carried = state_.frame;
}

void Turtle::leave_subsystem()
{
    if (call_scales_.empty())
        return;
    double const inner = call_scales_.back();
    call_scales_.pop_back();
    state_.scale = call_scales_.empty() ? view_.scale : call_scales_.back();
    if (inner != 0)
        state_.width = std::clamp(state_.width * state_.scale / inner, kMinWidth, 1e6);
}

void Turtle::draw_at_symbol(Symbol const& symbol)
{
    switch (at_symbol(symbol.name[1]).does) {
    case AtSymbolAction::Level:
        return state_.frame.roll_horizontal();
    case AtSymbolAction::Position:
        return set_position(symbol);
    case AtSymbolAction::Frame:
        return set_frame(symbol);
    case AtSymbolAction::Ball:
        return add_round(OrganShape::Kind::Ball, symbol);
    case AtSymbolAction::Disc:
        return add_round(OrganShape::Kind::Disc, symbol);
    case AtSymbolAction::Circle:
        return add_circle(symbol);
    case AtSymbolAction::Scale:
        return set_scale(symbol);
    case AtSymbolAction::Movement:
        return draw_movement_symbol(symbol);
    case AtSymbolAction::Cylinder:
        return draw_cylinder_symbol(symbol);
    case AtSymbolAction::Contour:
        return set_contour(symbol);
    case AtSymbolAction::Sides:
        return set_sides(symbol);
    case AtSymbolAction::Patch:
        return draw_patch_symbol(symbol);
    case AtSymbolAction::Cut: // @mc(1) is a cut; the symbols @mo and @J are for ray tracing only.
        is_cut_ = is_cut_ || (symbol.name[2] == 'c' && symbol.parameter(0, 0) == 1);
        return;
    case AtSymbolAction::Label:
        return warn(fmt::format("{}: labels are not drawn", model_.name));
    case AtSymbolAction::BackFace:
        return warn(fmt::format("{}: back faces have the colour of the front; @; and @, change "
                                "nothing",
                                model_.name));
    case AtSymbolAction::RunProgram:
        return warn(fmt::format("{}: models run no programs here; @S does nothing", model_.name));
    case AtSymbolAction::Ignored:
        return;
    case AtSymbolAction::Unknown:
        warn(fmt::format("{}: the turtle symbol @{} is not supported; it draws nothing",
                         model_.name, symbol.name[1]));
    }
}

// Interprets @Ts, @Ti and @Td (elasticity), @Tp (parallel transport of the sides), @Tf (start of
// that transport) and @Tx (texture, not supported).
void Turtle::draw_movement_symbol(Symbol const& symbol)
{
    switch (symbol.name[2]) {
    case 's':
    case 'i':
    case 'd':
    case '\0': // @T without a letter is treated like @Ti.
        return set_elasticity(symbol);
    case 'p':
        return state_.frame.transport_from(extras_.carried);
    case 'f':
        extras_.carried = state_.frame;
        return;
    default:
        return warn(
            fmt::format("{}: textures are not supported; @Tx changes nothing", model_.name));
    }
}

// Interprets a step. F and G draw a segment; in a polygon or a path F and f set vertices instead.
void Turtle::step(Symbol const& symbol)
{
    auto const& what = turtle_symbol(symbol.name[0]);
    bool const draws = what.does == SymbolAction::Draw;
    bool const sets_vertex = what.sets_vertex;
    auto& frame = state_.frame;
    if (tropism_count() > 0)
        bend_by_tropisms(frame, extras_.carried, view_.tropisms, extras_.elasticities);
    auto const base_mm = frame.position_mm;
    double const length_mm = symbol.parameter(0, 1) * state_.scale * options_.unit_mm;
    Vec3 const tip_mm = base_mm + length_mm * frame.heading;
    bool const is_inside = tip_mm.cwiseAbs().maxCoeff() < kMaxReachMm;
    if (!is_inside)
        warn(fmt::format("{}: left out steps to places more than 1e12 mm away", model_.name));
    if (is_inside && length_mm != 0) {
        frame.position_mm = tip_mm;
        if (polygons_.empty() && draws && state_.path != State::Path::OfSteps)
            drawing_->add_segment(state_.place, base_mm, tip_mm, radius_mm(state_), state_.color);
        else if (polygons_.empty())
            state_.place.is_open = false;
    }
    if (state_.elasticity != 0)
        frame.bend_towards(from_model(view_.tropism_direction), state_.elasticity);
    if (sets_vertex && !polygons_.empty())
        polygons_.back().vertices_mm.push_back(frame.position_mm);
    else if (sets_vertex && state_.path == State::Path::OfSteps)
        add_control_point(0);
    if (has_extras_ && draws)
        extras_.carried = frame;
}

void Turtle::push()
{
    save(state_);
    if (has_extras_)
        extras_stack_.push_back(extras_);
    if (state_.path != State::Path::None) {
        cylinder_stack_.push_back(cylinder_);
        cylinder_.place.is_open = false;
    }
    state_.place.is_open = false;
}

void Turtle::pop()
{
    if (depth_ == 0) {
        has_unpaired_ = true;
        return warn(fmt::format("{}: left out a ] without a [", model_.name));
    }
    state_ = stack_[--depth_];
    if (has_extras_) {
        extras_ = extras_stack_.back();
        extras_stack_.pop_back();
    }
    if (state_.path != State::Path::None) {
        cylinder_ = std::move(cylinder_stack_.back());
        cylinder_stack_.pop_back();
    }
}

void Turtle::close_polygon()
{
    if (polygons_.empty()) {
        has_unpaired_ = true;
        return warn(fmt::format("{}: left out a }} without a {{", model_.name));
    }
    auto const& polygon = polygons_.back();
    drawing_->add_polygon(polygon.vertices_mm, state_.place.segment, polygon.color);
    polygons_.pop_back();
}

// Interprets @D(scale), @Di[(factor)] and @Dd[(factor)]. Only warns if the scale is missing or the
// factor is 0.
void Turtle::set_scale(Symbol const& symbol)
{
    double const value = symbol.parameter(0, view_.scale_step);
    double scale = value;
    if (symbol.name[2] == 0 ? symbol.count == 0 : value == 0)
        return warn(
            fmt::format("{}: left out a @D without a scale, or a @Di or @Dd by 0", model_.name));
    if (symbol.name[2] == 'i')
        scale = state_.scale * value;
    else if (symbol.name[2] == 'd')
        scale = state_.scale / value;
    state_.scale = std::clamp(scale, -1e6, 1e6);
}

void Turtle::set_color(Symbol const& symbol, int sign)
{
    double const color = symbol.parameter(0, state_.color + sign * view_.color_step);
    state_.color
        = static_cast<std::uint8_t>(static_cast<int>(std::clamp(color, -256.0, 511.0)) & 255);
}

void Turtle::turn(Vec3& a, Vec3& b, Symbol const& symbol, double sign)
{
    auto const& angle = angles_.at(symbol.parameter(0, view_.angle_increment_deg));
    TurtleFrame::rotate(a, b, sign * angle.sine, angle.cosine);
}

// Interprets @M(x,y[,z]): sets the position.
void Turtle::set_position(Symbol const& symbol)
{
    if (symbol.count < 2)
        return;
    Vec3 const position(symbol.parameter(0, 0), symbol.parameter(1, 0), symbol.parameter(2, 0));
    state_.frame.position_mm = from_model(position).cwiseMax(-1e9).cwiseMin(1e9) * options_.unit_mm;
    state_.place.is_open = false;
}

// Interprets @R(x,y[,z[,up]]): sets the heading and the up vector. As in cpfg, a heading of zero
// length means straight up.
void Turtle::set_frame(Symbol const& symbol)
{
    if (symbol.count < 2)
        return;
    auto const direction = [&](std::size_t i) {
        return from_model(
            { symbol.parameter(i, 0), symbol.parameter(i + 1, 0), symbol.parameter(i + 2, 0) });
    };
    Vec3 const heading = direction(0);
    if (state_.frame.head_along(heading.isZero() ? Vec3(Vec3::UnitZ()) : heading)
        && symbol.count >= 6)
        state_.frame.set_up(direction(3));
}

// Interprets @Ts(tropism, value), @Ti(tropism[, step]) and @Td(tropism[, step]): sets, increases
// and decreases an elasticity. Tropisms are numbered from 1.
void Turtle::set_elasticity(Symbol const& symbol)
{
    double const number = symbol.parameter(0, 1);
    if (!(number >= 1) || number >= static_cast<double>(tropism_count()) + 1)
        return warn(fmt::format("{}: @T{}({}) names a tropism that the view does not define",
                                model_.name, std::string_view(&symbol.name[2], symbol.name[2] != 0),
                                number));
    auto const index = static_cast<std::size_t>(number) - 1;
    auto& elasticity = extras_.elasticities[index];
    double const change = symbol.parameter(1, view_.tropisms[index].elasticity_step);
    if (symbol.name[2] == 's')
        elasticity = symbol.parameter(1, 0);
    else
        elasticity += symbol.name[2] == 'd' ? -change : change;
}

std::size_t Turtle::tropism_count() const
{
    return std::min(view_.tropisms.size(), kMaxTropisms);
}

void Turtle::warn(std::string warning)
{
    auto& warnings = drawing_->warnings;
    if (std::none_of(warnings.begin(), warnings.end(),
                     [&](auto const& other) { return other.text == warning; }))
        warnings.push_back({ place_, std::move(warning) });
}

} // namespace tractus::lsystem
