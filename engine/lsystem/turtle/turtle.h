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

// Returns true if a model's strings may contain symbols for tropisms or for the appearance of
// cylinders.
bool uses_turtle_extras(Model const& model);
// Returns true if strings may define surfaces by points of the turtle, which are numbered in
// drawing order.
bool uses_patches(Model const& model);

// Interprets the symbols of a string, one after another, and draws into a TurtleDrawing. Each
// symbol's effect is described in fast_drawing/interpret.h.
class Turtle {
public:
    // The arguments must outlive the turtle.
    Turtle(Model const& model, TurtleOptions const& options);

    // The state that brackets save.
    struct State {
        TurtleFrame frame;
        double width = 0; // Line width, a diameter in turtle units.
        double scale = 1;
        double elasticity = 0; // Elasticity of the older kind of tropism.
        std::uint8_t color = 0;
        // How control points of an open generalised cylinder are set: OfSteps by steps and dots,
        // OfSymbols by @Gc and dots.
        enum class Path : std::uint8_t { None, OfSteps, OfSymbols };
        Path path = Path::None;
        TurtleDrawing::Place place;
    };
    // Additional state that brackets save if the model uses any of it.
    struct Extras {
        Elasticities elasticities {};
        // The frame from which the sides are carried when a tropism bends the heading.
        TurtleFrame carried;
        CylinderStyle style;
    };
    struct Start {
        State state;
        Extras extras;
    };

    // Returns the initial state that the view specifies.
    Start start() const;

    // Sets the turtle states with which %(x,i) continues; they must outlive the drawing.
    void set_kept(std::span<CutTurtle const> turtles) { kept_ = turtles; }
    // Returns the current state for a %(x) to store.
    CutTurtle kept() const;

    // Sets the state and draws into `drawing` from now on.
    void begin(Start const& start, TurtleDrawing& drawing);

    // Draws modules up to the first one for which `stops` is true, that is neither a single symbol
    // nor an @-symbol, or that is a cut. All parameters must be finite. `place` is the index of the
    // first module in the string, for warnings. Returns the number of modules drawn, and advances
    // `parameters` past theirs.
    std::size_t draw_plain(std::span<KindId const> kinds, float const*& parameters,
                           std::size_t place, std::array<bool, 256> const& stops);

    // Draws the first symbol of `modules`; returns its number of modules.
    std::size_t draw(Modules const& modules, std::size_t place, bool in_homomorphism);

    // Returns true if a cut was drawn since the last call: the rest of the branch must be skipped.
    bool take_cut() { return std::exchange(is_cut_, false); }

    // Returns the initial state for a branch that is left out here, to be drawn by another turtle.
    Start branch_start() const;
    // The current frame, width, scale and colour.
    State const& state() const { return state_; }
    // Discards the drawing, for callers that need only the turtle's state.
    void drop_drawing();
    // The segment at whose end the turtle is.
    std::uint32_t segment() const { return state_.place.segment; }
    // Number of branches begun since begin() that are still open.
    std::size_t depth() const { return depth_; }
    // Returns true if a branch may be left out: no polygon or cylinder is open that would continue
    // in it.
    bool may_skip_branch() const { return polygons_.empty() && state_.path == State::Path::None; }
    // Returns true if everything begun since begin() has ended, so that another turtle could
    // continue.
    bool is_complete() const { return depth_ == 0 && polygons_.empty() && !has_unpaired_; }

private:
    static constexpr double kMinWidth = 1e-7; // Minimum line width, the same as in cpfg.
    static constexpr double kMaxReachMm = 1e12;

    // A symbol with its parameters.
    struct Symbol {
        std::array<char, 3> name {}; // Characters of the symbol, padded with 0.
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

    // A generalised cylinder that is being drawn, and where it continues.
    struct OpenCylinder {
        Cylinder cylinder;
        TurtleDrawing::Place place;
        bool is_round = true; // True if the axis at `place` has round sections.
    };

    // A surface whose points are being set by @PC.
    struct OpenPatch {
        PatchBasis basis = PatchBasis::Bezier;
        std::array<Vec3, 16> control;
        std::uint32_t given = 0; // Bit set of the points given so far.
    };

    // The cases that draw_quick() handles.
    enum class Quick : std::uint8_t {
        Other, // A symbol that draw_quick() does not handle.
        Nothing,
        Step,
        Turn,
        Pitch,
        Roll,
        Push,
        Pop,
        Width,
        Level // A symbol that may be followed by v, which makes it @v.
    };
    struct Kind {
        char symbol = 0;
        std::uint8_t parameter_count = 0;
        bool is_single = false; // True for a symbol of one character that is not a cut.
        bool draws = false;     // True for a step that draws or moves.
        Quick quick = Quick::Other;
        double sign = 1; // Sign of a turn or of a change of width.
    };

    static Quick quick_case(SymbolAction does);
    static Kind describe(ModuleKind const& kind);
    bool check(Symbol const& symbol);
    // Functions defined in turtle_plain.cpp.
    std::size_t name_at_symbol(std::span<KindId const> kinds, Symbol& symbol) const;
    // Returns true if a step only moves or draws a segment, without bending or adding control
    // points.
    static bool is_quick(State const& state)
    {
        return state.elasticity == 0 && state.path == State::Path::None;
    }
    std::size_t draw_quick(std::span<KindId const> kinds, float const*& parameters,
                           std::array<bool, 256> const& stops);
    // Steps and returns true; if the step leads too far, returns false and changes nothing.
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
    // Pops the saved state and returns true; if draw_quick() cannot continue with it, returns false
    // and changes nothing.
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
    // Sets the width to `value` if it is given; otherwise changes it by `value` steps.
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
    // Functions defined in turtle_organs.cpp.
    void add_organ(char letter, Symbol const& symbol);
    void add_round(OrganShape::Kind kind, Symbol const& symbol);
    void add_circle(Symbol const& symbol);
    void draw_patch_symbol(Symbol const& symbol);
    void add_patch(OpenPatch const& patch);
    double diameter(Symbol const& symbol) const;
    // Functions defined in turtle_cylinder.cpp.
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
    std::vector<State> stack_; // Saved states; the first depth_ are in use.
    std::size_t depth_ = 0;
    std::vector<Extras> extras_stack_; // Saved extras; used only if the model has extras.
    std::vector<OpenPolygon> polygons_;
    std::span<CutTurtle const> kept_;
    std::vector<double> call_scales_; // Scales of the open calls of sub-L-systems.
    OpenCylinder cylinder_;           // The open cylinder; valid while state_.path is not None.
    std::vector<OpenCylinder> cylinder_stack_;
    std::map<float, OpenPatch> patches_;
    std::map<std::array<std::int32_t, 48>, std::uint32_t> patch_numbers_;
    std::map<std::pair<std::uint32_t, std::uint8_t>, OrganShapeId> patch_shapes_;
    std::size_t place_ = 0;
    bool is_cut_ = false;
    bool has_unpaired_ = false; // True after a ] or } without an opening one.
};

} // namespace tractus::lsystem
