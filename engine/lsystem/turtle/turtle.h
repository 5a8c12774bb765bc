#pragma once

#include "engine/lsystem/language/turtle_symbols.h"
#include "engine/lsystem/rewriting/rewriter.h"
#include "engine/lsystem/turtle/cylinder.h"
#include "engine/lsystem/turtle/turtle_drawing.h"
#include "engine/lsystem/turtle/turtle_frame.h"
#include "engine/lsystem/turtle/turtle_options.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus::lsystem {

// Whether a model's strings may say how the turtle is carried, or how cylinders look.
bool uses_turtle_extras(Model const& model);
// Whether strings may define surfaces by the turtle, which are numbered as they are drawn.
bool uses_patches(Model const& model);

// Draws the symbols of a string, one after the other, into a TurtleDrawing. What each symbol does:
// fast_drawing/interpret.h.
class Turtle {
public:
    // All must outlive it.
    Turtle(Model const& model, TurtleOptions const& options);

    // State that brackets save.
    struct State {
        TurtleFrame frame;
        double width = 0; // Diameter in turtle units.
        double scale = 1;
        double elasticity = 0; // Elasticity of the older tropism.
        std::uint8_t color = 0;
        // An open generalised cylinder: its control points are steps and dots, or @Gc and dots.
        enum class Path : std::uint8_t { None, OfSteps, OfSymbols };
        Path path = Path::None;
        TurtleDrawing::Place place;
    };
    // State that brackets save, too, where a model uses any of it.
    struct Extras {
        Elasticities elasticities {};
        TurtleFrame carried; // Frame from which the sides are carried when a tropism bends.
        CylinderStyle style;
    };
    struct Start {
        State state;
        Extras extras;
    };

    // Returns the start that the view asks for.
    Start start() const;

    // Sets the turtles that %(x,i) goes on with; they must outlive the drawing.
    void set_kept(std::span<KeptTurtle const> turtles) { kept_ = turtles; }
    // Returns the state as a %(x) here keeps it.
    KeptTurtle kept() const;

    // Begins as given, and draws into `drawing` from here on.
    void begin(Start const& start, TurtleDrawing& drawing);

    // Draws modules up to the first for which `stops` is true, that is not a symbol of its own or
    // of the @-symbols, or that is a cut. All their parameters are finite. The first stands at
    // `place` in the string (for warnings). Returns how many were drawn and moves `parameters`
    // behind theirs.
    std::size_t draw_plain(std::span<KindId const> kinds, float const*& parameters,
                           std::size_t place, std::array<bool, 256> const& stops);

    // Draws the first symbol of `modules`; returns how many modules it had.
    std::size_t draw(Modules const& modules, std::size_t place, bool in_homomorphism);

    // Whether a cut was drawn: the rest of the branch is not to be drawn.
    bool take_cut() { return std::exchange(is_cut_, false); }

    // How a branch begins that is left out here, to be drawn by another turtle.
    Start branch_start() const;
    // Where the turtle is and what it draws with.
    State const& state() const { return state_; }
    // Forgets what was drawn, for those who only ask where the turtle is.
    void drop_drawing();
    // The segment at whose end the turtle is.
    std::uint32_t segment() const { return state_.place.segment; }
    // How many branches were begun since begin() and are open.
    std::size_t depth() const { return depth_; }
    // Whether a branch may be left out: what is open would go on in it.
    bool may_leave_out() const { return polygons_.empty() && state_.path == State::Path::None; }
    // Whether all that was begun since begin() is at its end, as another turtle must find it.
    bool is_complete() const { return depth_ == 0 && polygons_.empty() && !has_unpaired_; }

private:
    static constexpr double kMinWidth = 1e-7; // cpfg has the same.
    static constexpr double kMaxReachMm = 1e12;

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

    struct OpenPolygon {
        std::vector<Vec3> vertices_mm;
        std::uint8_t color = 0;
    };

    // A generalised cylinder that is being drawn, and where it goes on.
    struct OpenCylinder {
        Cylinder cylinder;
        TurtleDrawing::Place place;
        bool is_round = true; // The axis at `place`.
    };

    // A surface whose points are being given by @PC.
    struct OpenPatch {
        PatchBasis basis = PatchBasis::Bezier;
        std::array<Vec3, 16> control;
        std::uint32_t given = 0; // One bit for each point.
    };

    // Cases that draw_quick() knows.
    enum class Quick : std::uint8_t {
        Other, // Nothing of these.
        Nothing,
        Step,
        Turn,
        Pitch,
        Roll,
        Push,
        Pop,
        Width,
        Level // Behind it may be what makes it @v.
    };
    struct Kind {
        char symbol = 0;
        std::uint8_t parameter_count = 0;
        bool is_single = false; // A symbol by itself, and no cut.
        bool draws = false;     // A step.
        Quick quick = Quick::Other;
        double sign = 1; // Sign of a turn or a step of the width.
    };

    static Quick quick_way(SymbolDoes does);
    static Kind describe(ModuleKind const& kind);
    bool check(Symbol const& symbol);
    // turtle_plain.cpp
    std::size_t name_at_symbol(std::span<KindId const> kinds, Symbol& symbol) const;
    // Whether steps do no more than draw a segment or move.
    static bool is_quick(State const& state)
    {
        return state.elasticity == 0 && state.path == State::Path::None;
    }
    std::size_t draw_quick(std::span<KindId const> kinds, float const*& parameters,
                           std::array<bool, 256> const& stops);
    // False, and no change, for a step that leads too far.
    bool step_quickly(State& state, double length_mm, bool draws)
    {
        Vec3 const base_mm = state.frame.position_mm;
        Vec3 const tip_mm = base_mm + length_mm * state.frame.heading;
        if (!(tip_mm.cwiseAbs().maxCoeff() < kMaxReachMm))
            return false;
        if (length_mm == 0)
            return true;
        state.frame.position_mm = tip_mm;
        if (draws)
            drawing_->add_segment(state.place, base_mm, tip_mm, radius_mm(state), state.color);
        else
            state.place.is_open = false;
        return true;
    }
    // False, and no change, if there is nothing that draw_quick() may go on with.
    bool restore_quickly(State& state)
    {
        if (depth_ == 0 || !is_quick(stack_[depth_ - 1]))
            return false;
        state = stack_[--depth_];
        return true;
    }
    void save(State const& state)
    {
        if (depth_ == stack_.size())
            stack_.resize(2 * depth_ + 16);
        stack_[depth_++] = state;
    }
    void draw_symbol(Symbol const& symbol);
    void draw_at_symbol(Symbol const& symbol);
    void step(Symbol const& symbol);
    void push();
    void pop();
    void close_polygon();
    // Sets the width to the value if it is given, else changes it by as many steps.
    void set_width(State& state, bool is_given, double value)
    {
        double const change = value * view_.line_width_step * state.scale;
        double const width = is_given ? value * state.scale : state.width + change;
        state.width = std::clamp(width, kMinWidth, 1e6);
        drawing_->set_tip_radius(state.place, radius_mm(state));
    }
    void set_scale(Symbol const& symbol);
    void enter_subsystem(Symbol const& symbol);
    void leave_subsystem();
    void go_on_with(Symbol const& symbol);
    void set_color(Symbol const& symbol, int sign);
    void turn(Vec3& a, Vec3& b, Symbol const& symbol, double sign);
    void set_position(Symbol const& symbol);
    void set_frame(Symbol const& symbol);
    void set_elasticity(Symbol const& symbol);
    void draw_movement_symbol(Symbol const& symbol);
    // turtle_organs.cpp
    void add_organ(char letter, Symbol const& symbol);
    void add_round(OrganShape::Kind kind, Symbol const& symbol);
    void add_circle(Symbol const& symbol);
    void draw_patch_symbol(Symbol const& symbol);
    void add_patch(OpenPatch const& patch);
    double diameter(Symbol const& symbol) const;
    // turtle_cylinder.cpp
    void begin_path(Symbol const& symbol);
    void end_path();
    void add_dot(Symbol const& symbol);
    void draw_cylinder_symbol(Symbol const& symbol);
    void begin_cylinder(Cylinder::Path path, int rings);
    void add_control_point(int rings);
    void draw_piece(Cylinder::Piece const& piece);
    void set_contour(Symbol const& symbol);
    void set_sides(Symbol const& symbol);
    void set_radius_tangents(Symbol const& symbol);
    std::size_t tropism_count() const;
    float radius_mm(State const& state) const
    {
        double const width = state.width * view_.width_unit;
        return static_cast<float>(std::min(width * options_.unit_mm / 2, 1e6));
    }
    void warn(std::string warning);

    Model const& model_;
    View const& view_;
    TurtleOptions const& options_;
    std::array<Kind, 256> kinds_ {};
    AngleCache angles_;

    TurtleDrawing* drawing_ = nullptr; // Not owned.
    State state_;
    Extras extras_;
    bool has_extras_ = false;
    std::vector<State> stack_; // Saved states, of which `depth_` count.
    std::size_t depth_ = 0;
    std::vector<Extras> extras_stack_; // Used if there are extras.
    std::vector<OpenPolygon> polygons_;
    std::span<KeptTurtle const> kept_;
    std::vector<double> call_scales_; // Scales of the calls of sub-L-systems that are open.
    OpenCylinder cylinder_;           // While state_.path is not None.
    std::vector<OpenCylinder> cylinder_stack_;
    std::map<float, OpenPatch> patches_;
    std::map<std::array<std::int32_t, 48>, std::uint32_t> patch_numbers_;
    std::map<std::pair<std::uint32_t, std::uint8_t>, OrganShapeId> patch_shapes_;
    std::size_t place_ = 0;
    bool is_cut_ = false;
    bool has_unpaired_ = false; // A ] or } without its beginning.
};

} // namespace tractus::lsystem
