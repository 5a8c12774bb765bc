#include "engine/lsystem/turtle.h"

#include "engine/lsystem/expander.h"
#include "engine/lsystem/plant_builder.h"
#include "engine/lsystem/print.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/core.h>

namespace tractus {

namespace {

constexpr std::size_t kMaxTropisms = 8;
constexpr double kMinWidth = 1e-7; // As cpfg.

// From cpfg's space to the plant's.
Vec3 from_model(Vec3 const& v)
{
    return { v.x(), -v.z(), v.y() };
}

// What brackets save. The frame is cpfg's: `down` is the vector that it calls up, which points away
// from the upper side, so that heading x down = left.
struct State {
    Vec3 position_mm = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 left = -Vec3::UnitX();
    Vec3 down = Vec3::UnitY();
    double width = 0; // Diameter in turtle units.
    double scale = 1;
    double elasticity = 0; // Of the older tropism.
    int color = 0;
    bool is_cylinder = false; // Between @Gs and @Ge.
    PlantBuilder::Place place;
};

// Elasticities of the view's tropisms: part of the state, but most models have none.
using Elasticities = std::array<double, kMaxTropisms>;

// Sine and cosine of the angles that came last: a model turns by few angles, again and again.
class AngleCache {
public:
    struct Entry {
        double angle_rad = 0;
        double sine = 0;
        double cosine = 1;
    };

    Entry const& at(double angle_rad)
    {
        auto const bits = std::bit_cast<std::uint64_t>(angle_rad);
        auto& entry = entries_[(bits ^ bits >> 32) * 0x9e3779b97f4a7c15u >> 59];
        if (entry.angle_rad != angle_rad)
            entry = { angle_rad, std::sin(angle_rad), std::cos(angle_rad) };
        return entry;
    }

private:
    std::array<Entry, 32> entries_ {};
};

struct OpenPolygon {
    std::vector<Vec3> vertices_mm;
    MaterialId material = 0;
};

// One symbol with its parameters.
struct Symbol {
    std::array<char, 3> name {}; // Filled with 0.
    float const* parameters = nullptr;
    std::size_t count = 0;

    double parameter(std::size_t index, double otherwise) const
    {
        return index < count ? static_cast<double>(parameters[index]) : otherwise;
    }
};

class Turtle {
public:
    Turtle(Model const& model, TurtleOptions const& options)
        : model_(model)
        , view_(model.view)
        , options_(options)
        , builder_(model.view, options.unit_mm)
    {
        state_.width = view_.line_width;
        state_.elasticity = view_.elasticity;
        state_.color = view_.color;
        if (view_.tropisms.size() > kMaxTropisms)
            warn(fmt::format("{}: only the first {} tropisms count", model.name, kMaxTropisms));
        for (std::size_t i = 0; i < tropism_count(); ++i)
            elasticities_[i] = view_.tropisms[i].elasticity;
        for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i)
            is_single_[i] = std::string_view("@~?").find(model.alphabet.kinds[i].symbol)
                == std::string_view::npos;
    }

    // Draws the first symbol of `modules`; returns how many modules it had. 0: too many modules.
    std::size_t draw(Modules const& modules, bool in_homomorphism);

    // Whether a cut was drawn: the rest of the branch is not to be drawn.
    bool take_cut() { return std::exchange(is_cut_, false); }
    bool is_full() const { return drawn_ > options_.max_modules; }
    bool has_too_many_parts() const { return builder_.part_count() > options_.max_parts; }

    TurtlePlant finish();

private:
    void draw_symbol(Symbol const& symbol);
    void draw_at_symbol(Symbol const& symbol);
    void step(Symbol const& symbol, bool draws, bool sets_vertex);
    void push();
    void pop();
    void close_polygon();
    void set_width(Symbol const& symbol, int sign);
    void set_color(Symbol const& symbol, int sign);
    void rotate(Vec3& a, Vec3& b, double angle_rad);
    void turn(Vec3& a, Vec3& b, Symbol const& symbol, double sign);
    void roll_horizontal();
    void set_position(Symbol const& symbol);
    void set_frame(Symbol const& symbol);
    void bend_by(Vec3 const& torque);
    void bend_by_tropisms();
    void twist_by_torques();
    void set_elasticity(Symbol const& symbol);
    void add_organ(char letter, Symbol const& symbol);
    void add_round(OrganShape::Kind kind, Symbol const& symbol);
    std::size_t tropism_count() const { return std::min(view_.tropisms.size(), kMaxTropisms); }
    MaterialId material()
    {
        if (state_.color != material_color_) {
            material_ = builder_.material(state_.color);
            material_color_ = state_.color;
        }
        return material_;
    }
    float radius_mm() const
    {
        return static_cast<float>(std::min(state_.width * options_.unit_mm / 2, 1e6));
    }
    void warn(std::string warning)
    {
        if (std::find(warnings_.begin(), warnings_.end(), warning) == warnings_.end())
            warnings_.push_back(std::move(warning));
    }

    Model const& model_;
    View const& view_;
    TurtleOptions const& options_;
    PlantBuilder builder_;
    State state_;
    Elasticities elasticities_ {};
    std::vector<State> stack_;
    std::vector<Elasticities> elasticity_stack_; // Used if there are tropisms.
    AngleCache angles_;
    std::vector<OpenPolygon> polygons_;
    std::vector<std::string> warnings_;
    int material_color_ = -1; // None.
    MaterialId material_ = 0;
    std::array<bool, 256> is_single_ {}; // Kinds that are a symbol by themselves.
    std::size_t drawn_ = 0;
    bool is_cut_ = false;
};

std::size_t Turtle::draw(Modules const& modules, bool in_homomorphism)
{
    auto const length = is_single_[modules.kinds[0]]
        ? 1
        : symbol_length(model_.alphabet, { modules.kinds, modules.count });
    if (++drawn_ > options_.max_modules)
        return 0;
    Symbol symbol;
    for (std::size_t i = 0; i < length; ++i)
        symbol.name[i] = model_.alphabet[modules.kinds[i]].symbol;
    symbol.parameters = modules.parameters;
    symbol.count = model_.alphabet[modules.kinds[length - 1]].parameter_count;
    // A number that is not finite would reach all that is drawn after it.
    for (std::size_t i = 0; i < symbol.count; ++i)
        if (!std::isfinite(symbol.parameters[i])) {
            warn(fmt::format("{}: left out {} with a parameter that is not a number", model_.name,
                             std::string(symbol.name.data(), length)));
            return length;
        }
    if (symbol.name[0] == '%' && !in_homomorphism && symbol.count == 0)
        is_cut_ = true;
    else
        draw_symbol(symbol);
    return length;
}

// NOLINTNEXTLINE(readability-function-size): a table, one case per symbol.
void Turtle::draw_symbol(Symbol const& symbol)
{
    switch (symbol.name[0]) {
    case 'F':
        return step(symbol, true, true);
    case 'G':
        return step(symbol, true, false);
    case 'f':
        return step(symbol, state_.is_cylinder, true);
    case 'g':
        return step(symbol, state_.is_cylinder, false);
    case '+':
        return turn(state_.heading, state_.left, symbol, 1);
    case '-':
        return turn(state_.heading, state_.left, symbol, -1);
    case '&':
        return turn(state_.heading, state_.down, symbol, 1);
    case '^':
        return turn(state_.heading, state_.down, symbol, -1);
    case '/':
        return turn(state_.left, state_.down, symbol, 1);
    case '\\':
        return turn(state_.left, state_.down, symbol, -1);
    case '|':
        return rotate(state_.heading, state_.left, kPi);
    case '[':
        return push();
    case ']':
        return pop();
    case '!':
        return set_width(symbol, -1);
    case '#':
        return set_width(symbol, 1);
    case ';':
        return set_color(symbol, 1);
    case ',':
        return set_color(symbol, -1);
    case '_':
        state_.elasticity = symbol.parameter(0, state_.elasticity + view_.elasticity_step);
        return;
    case '{':
        if (symbol.parameter(0, 0) == 0)
            polygons_.push_back({ {}, material() });
        else
            state_.is_cylinder = true;
        return;
    case '.':
        if (!polygons_.empty())
            polygons_.back().vertices_mm.push_back(state_.position_mm);
        return;
    case '}':
        if (symbol.parameter(0, 0) == 0)
            close_polygon();
        else
            state_.is_cylinder = false;
        return;
    case '~':
        if (symbol.name[1] != 0)
            add_organ(symbol.name[1], symbol);
        return;
    case '@':
        return draw_at_symbol(symbol);
    default:
        return;
    }
}

void Turtle::draw_at_symbol(Symbol const& symbol)
{
    switch (symbol.name[1]) {
    case 'v':
        return roll_horizontal();
    case 'M':
        return set_position(symbol);
    case 'R':
        return set_frame(symbol);
    case 'o':
    case 'O':
        return add_round(OrganShape::Kind::Ball, symbol);
    case 'c':
        return add_round(OrganShape::Kind::Disc, symbol);
    case 'D': {
        double const value = symbol.parameter(0, 1);
        double scale = value;
        if (symbol.name[2] == 'i')
            scale = state_.scale * value;
        else if (symbol.name[2] == 'd')
            scale = value != 0 ? state_.scale / value : state_.scale;
        state_.scale = std::clamp(scale, -1e6, 1e6);
        return;
    }
    case 'T': // @Tx is a texture; @Tp and @Tf carry the frame, which here twists least anyway.
        if (symbol.name[2] == 's' || symbol.name[2] == 'i' || symbol.name[2] == 'd')
            set_elasticity(symbol);
        return;
    case 'G':
        if (symbol.name[2] == 's' || symbol.name[2] == 'e')
            state_.is_cylinder = symbol.name[2] == 's';
        return;
    case ';':
    case ',': // The back face's colour.
    case '#':
    case '!': // Contour and sides of cylinders.
        return;
    default:
        warn(fmt::format("{}: the turtle symbol @{} is not supported; it draws nothing",
                         model_.name, symbol.name[1]));
    }
}

void Turtle::step(Symbol const& symbol, bool draws, bool sets_vertex)
{
    bend_by_tropisms();
    auto const base_mm = state_.position_mm;
    double const length_mm = symbol.parameter(0, 1) * state_.scale * options_.unit_mm;
    Vec3 const tip_mm = base_mm + length_mm * state_.heading;
    bool const is_inside = tip_mm.cwiseAbs().maxCoeff() < 1e12;
    if (!is_inside)
        warn(fmt::format("{}: left out steps to places more than 1e12 mm away", model_.name));
    if (is_inside && length_mm != 0) {
        state_.position_mm = tip_mm;
        if (polygons_.empty() && draws)
            builder_.add_segment(state_.place, { base_mm, tip_mm, radius_mm(), material() });
        else if (polygons_.empty())
            state_.place.axis = kNone;
    }
    if (state_.elasticity != 0)
        bend_by(state_.heading.cross(from_model(view_.tropism_direction)) * state_.elasticity);
    if (sets_vertex && !polygons_.empty())
        polygons_.back().vertices_mm.push_back(state_.position_mm);
}

void Turtle::push()
{
    stack_.push_back(state_);
    if (tropism_count() > 0)
        elasticity_stack_.push_back(elasticities_);
    state_.place.axis = kNone;
}

void Turtle::pop()
{
    if (stack_.empty()) {
        warn(fmt::format("{}: left out a ] without a [", model_.name));
        return;
    }
    state_ = stack_.back();
    stack_.pop_back();
    if (tropism_count() > 0) {
        elasticities_ = elasticity_stack_.back();
        elasticity_stack_.pop_back();
    }
}

void Turtle::close_polygon()
{
    if (polygons_.empty()) {
        warn(fmt::format("{}: left out a }} without a {{", model_.name));
        return;
    }
    auto const& polygon = polygons_.back();
    builder_.add_polygon(polygon.vertices_mm, state_.place.segment, polygon.material);
    polygons_.pop_back();
}

void Turtle::set_width(Symbol const& symbol, int sign)
{
    double const step = sign * view_.line_width_step * state_.scale;
    double const width
        = symbol.count > 0 ? symbol.parameter(0, 0) * state_.scale : state_.width + step;
    state_.width = std::clamp(width, kMinWidth, 1e6);
    builder_.set_tip_radius(state_.place, radius_mm());
}

void Turtle::set_color(Symbol const& symbol, int sign)
{
    double const color = symbol.parameter(0, state_.color + sign * view_.color_step);
    state_.color = static_cast<int>(std::clamp(color, -256.0, 511.0)) & 255;
}

// Turns a towards b in their plane.
void Turtle::rotate(Vec3& a, Vec3& b, double angle_rad)
{
    auto const& angle = angles_.at(angle_rad);
    Vec3 const turned = angle.cosine * a + angle.sine * b;
    b = angle.cosine * b - angle.sine * a;
    a = turned;
}

void Turtle::turn(Vec3& a, Vec3& b, Symbol const& symbol, double sign)
{
    rotate(a, b, sign * radians(std::fmod(symbol.parameter(0, view_.angle_increment_deg), 360)));
}

// The turtle's left becomes horizontal, its upper side looks up. No change when it heads straight
// up or down.
void Turtle::roll_horizontal()
{
    Vec3 const left = Vec3::UnitZ().cross(state_.heading);
    double const length = left.norm();
    if (length < 1e-9)
        return;
    state_.left = left / length;
    state_.down = state_.left.cross(state_.heading);
}

void Turtle::set_position(Symbol const& symbol)
{
    if (symbol.count < 3)
        return;
    Vec3 const position(symbol.parameter(0, 0), symbol.parameter(1, 0), symbol.parameter(2, 0));
    state_.position_mm = from_model(position).cwiseMax(-1e9).cwiseMin(1e9) * options_.unit_mm;
    state_.place.axis = kNone;
}

void Turtle::set_frame(Symbol const& symbol)
{
    if (symbol.count < 3)
        return;
    Vec3 const heading
        = from_model({ symbol.parameter(0, 0), symbol.parameter(1, 0), symbol.parameter(2, 0) });
    if (!(heading.norm() > 1e-9) || !std::isfinite(heading.norm()))
        return;
    auto const turn = Quat::FromTwoVectors(state_.heading, heading);
    state_.heading = heading.normalized();
    state_.left = (turn * state_.left).normalized();
    if (symbol.count >= 6) {
        Vec3 const up = from_model(
            { symbol.parameter(3, 0), symbol.parameter(4, 0), symbol.parameter(5, 0) });
        Vec3 const left = up.cross(state_.heading);
        if (left.norm() > 1e-9 && std::isfinite(left.norm()))
            state_.left = left.normalized();
    }
    state_.left = (state_.left - state_.left.dot(state_.heading) * state_.heading).normalized();
    state_.down = state_.left.cross(state_.heading);
}

// Turns the frame about `torque` by its length, at most 1 radian, with the least twist.
void Turtle::bend_by(Vec3 const& torque)
{
    double const length = torque.norm();
    if (!(length >= 1e-6))
        return;
    Eigen::AngleAxisd const turn(std::min(length, 1.0), torque / length);
    state_.heading = (turn * state_.heading).normalized();
    state_.left = turn * state_.left;
    state_.left = (state_.left - state_.left.dot(state_.heading) * state_.heading).normalized();
    state_.down = state_.left.cross(state_.heading);
}

// cpfg's law: the heading turns towards V = sum e (cos g T + sin g T x (H x T) / |H x T|), about
// H x V and by its length in radians.
void Turtle::bend_by_tropisms()
{
    if (tropism_count() == 0)
        return;
    Vec3 pull = Vec3::Zero();
    bool has_torque = false;
    for (std::size_t i = 0; i < tropism_count(); ++i) {
        auto const& tropism = view_.tropisms[i];
        auto const elasticity = elasticities_[i];
        if (elasticity == 0)
            continue;
        has_torque = has_torque || tropism.is_torque;
        if (tropism.is_torque)
            continue;
        Vec3 const direction = from_model(tropism.direction);
        pull += elasticity * std::cos(radians(tropism.angle_deg)) * direction;
        if (tropism.angle_deg == 0)
            continue;
        Vec3 across = state_.heading.cross(direction);
        double length = across.norm();
        if (length < 1e-7) {
            across = state_.left;
            length = 1;
        }
        pull
            += elasticity * std::sin(radians(tropism.angle_deg)) / length * direction.cross(across);
    }
    bend_by(state_.heading.cross(pull));
    if (has_torque)
        twist_by_torques();
}

// Rolls the turtle so that its upper side turns towards the sum of the torques' directions.
void Turtle::twist_by_torques()
{
    Vec3 pull = Vec3::Zero();
    for (std::size_t i = 0; i < tropism_count(); ++i)
        if (view_.tropisms[i].is_torque)
            pull += elasticities_[i] * from_model(view_.tropisms[i].direction);
    Vec3 const across = pull - pull.dot(state_.heading) * state_.heading;
    if (across.norm() < 1e-4 * pull.norm() || !(pull.norm() > 0))
        return;
    Vec3 const torque = state_.down.cross(across.normalized() * pull.norm());
    double const angle_rad = std::min(torque.norm(), 1.0);
    if (angle_rad < 1e-7)
        return;
    Eigen::AngleAxisd const turn(angle_rad, torque.normalized());
    state_.left = turn * state_.left;
    state_.left = (state_.left - state_.left.dot(state_.heading) * state_.heading).normalized();
    state_.down = state_.left.cross(state_.heading);
}

// @Ts(tropism, value), @Ti(tropism[, step]), @Td(tropism[, step]); tropisms count from 1.
void Turtle::set_elasticity(Symbol const& symbol)
{
    double const number = symbol.parameter(0, 1);
    if (!(number >= 1) || number >= static_cast<double>(tropism_count()) + 1) {
        warn(fmt::format("{}: @T{}({}) names a tropism that the view does not define", model_.name,
                         symbol.name[2], number));
        return;
    }
    auto const index = static_cast<std::size_t>(number) - 1;
    auto& elasticity = elasticities_[index];
    double const change = symbol.parameter(1, view_.tropisms[index].elasticity_step);
    if (symbol.name[2] == 's')
        elasticity = symbol.parameter(1, 0);
    else
        elasticity += symbol.name[2] == 'i' ? change : -change;
}

// ~X, ~X(scale), ~X(across, along, thick).
void Turtle::add_organ(char letter, Symbol const& symbol)
{
    if (!builder_.is_defined(letter))
        warn(fmt::format("{}: no organ {} in the view; ~{} draws a plain leaf", model_.name, letter,
                         letter));
    Organ organ;
    organ.shape = builder_.organ_shape(letter);
    organ.segment = state_.place.segment;
    organ.position_mm = state_.position_mm;
    Eigen::Matrix3d axes;
    axes.col(0) = -state_.left;
    axes.col(1) = state_.heading;
    axes.col(2) = -state_.down;
    organ.orientation = Quat(axes).normalized();
    double const uniform = symbol.parameter(0, 1);
    for (int i = 0; i < 3; ++i) {
        double const scale
            = symbol.count >= 3 ? symbol.parameter(static_cast<std::size_t>(i), 1) : uniform;
        organ.scale[i] = static_cast<float>(std::clamp(scale * state_.scale, -1e6, 1e6));
    }
    if (organ.scale.squaredNorm() > 0)
        builder_.add_organ(organ);
}

// @o and @O: a ball of the given diameter about the turtle; @c: a disc whose face is the turtle's
// upper side. The line width where no diameter is given.
void Turtle::add_round(OrganShape::Kind kind, Symbol const& symbol)
{
    double const diameter = std::clamp(
        symbol.parameter(0, state_.width / std::max(state_.scale, 1e-6)) * state_.scale, 0.0, 1e6);
    if (!(diameter > 0))
        return;
    Organ organ;
    organ.shape = builder_.round_shape(kind, state_.color);
    organ.segment = state_.place.segment;
    organ.position_mm = state_.position_mm;
    Eigen::Matrix3d axes;
    bool const is_ball = kind == OrganShape::Kind::Ball;
    axes.col(1) = is_ball ? state_.heading : -state_.down;
    axes.col(0) = -state_.left;
    axes.col(2) = axes.col(0).cross(axes.col(1));
    organ.orientation = Quat(axes).normalized();
    organ.scale = Vec3f::Constant(static_cast<float>(diameter));
    if (is_ball) // Balls touch their origin.
        organ.position_mm -= diameter / 2 * options_.unit_mm * state_.heading;
    builder_.add_organ(organ);
}

TurtlePlant Turtle::finish()
{
    TurtlePlant result;
    result.plant = builder_.finish();
    if (view_.pipe_model)
        apply_pipe_model(result.plant, view_.pipe_exponent,
                         view_.pipe_tip_radius * options_.unit_mm);
    result.warnings = std::move(warnings_);
    return result;
}

// The string from one end to the other; a cut leaves out the rest of its branch.
class Interpretation {
public:
    Interpretation(Model const& model, ModuleString const& string, TurtleOptions const& options)
        : model_(model)
        , string_(string)
        , machine_(model, string)
        , homomorphism_(model, model.homomorphism, machine_)
        , turtle_(model, options)
        , max_modules_(options.max_modules)
        , max_parts_(options.max_parts)
    {
        if (homomorphism_.has_contexts())
            find_branches(model, string, branches_);
    }

    Result<TurtlePlant> run()
    {
        while (at_ < string_.size()) {
            auto const count = draw_one();
            if (machine_.has_stopped())
                TRY(machine_.check());
            if (turtle_.is_full() || count == 0)
                return fail(Fault::User,
                            fmt::format("{}: the homomorphism makes more than {} modules",
                                        model_.name, max_modules_));
            if (turtle_.has_too_many_parts())
                return fail(Fault::User,
                            fmt::format("{}: the plant has more than {} segments, organs and "
                                        "polygons; derive fewer steps",
                                        model_.name, max_parts_));
            pass(count);
            if (turtle_.take_cut())
                pass(branch_end(model_, string_, at_) - at_);
        }
        return turtle_.finish();
    }

private:
    std::size_t draw_one()
    {
        auto const kind = string_.kinds[at_];
        Modules const rest { string_.kinds.data() + at_, string_.parameters.data() + parameter_,
                             string_.size() - at_ };
        if (!homomorphism_.has_rules(kind))
            return turtle_.draw(rest, false);
        machine_.begin_module(kHomomorphismStep, at_);
        Surroundings const around { &string_, &branches_,
                                    at_,      parameter_,
                                    at_ + 1,  parameter_ + model_.alphabet[kind].parameter_count };
        return homomorphism_.expand(rest, around, [&](Modules const& modules) {
            return turtle_.draw(modules, modules.kinds != rest.kinds);
        });
    }

    void pass(std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            parameter_ += model_.alphabet[string_.kinds[at_++]].parameter_count;
    }

    Model const& model_;
    ModuleString const& string_;
    Machine machine_;
    Expander homomorphism_;
    Turtle turtle_;
    std::size_t max_modules_;
    std::size_t max_parts_;
    Branches branches_; // Where homomorphism rules have contexts.
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
};

} // namespace

Result<TurtlePlant> interpret_with_warnings(Model const& model, ModuleString const& string,
                                            TurtleOptions const& options)
{
    return Interpretation(model, string, options).run();
}

Result<Plant> interpret(Model const& model, ModuleString const& string,
                        TurtleOptions const& options)
{
    return TRY(interpret_with_warnings(model, string, options)).plant;
}

} // namespace tractus
