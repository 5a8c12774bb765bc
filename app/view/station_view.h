#pragma once

#include "app/document/document.h"
#include "app/station/station.h"
#include "app/tools/shown_skeleton.h"
#include "app/view/plant_grower.h"
#include "app/view/shown_layers.h"
#include "app/view/skeleton_picture.h"
#include "app/view/steady_frame.h"
#include "app/view/stroke_previews.h"
#include "app/view/window_model.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus::view {

// Keeps the window's state up to date with a station and with the document that receives its
// strokes: pen, strokes, selection, and the plant, which is grown in the background after each
// stroke. It makes no difference where the station's reports come from. The owner of this object
// sets all other members of state().
class StationView {
public:
    StationView(station::Station const& station, document::Document const& document);

    WindowState& state() { return state_; }
    WindowState const& state() const { return state_; }

    // Updates the state with all changes since the last call.
    void show(station::Station const& station, document::Document const& document);

    // Advances the window's clock by a step, by which layers fade.
    void pass(Duration step);

    // Sets the status to a message about the effect of a stroke.
    void tell(document::DrawnStroke const& drawn);

    // Waits for the plant that was requested last and for all variations, and shows them.
    void settle();

    // Shows the pen's movements since the last call, for windows that the pen operates. Call this
    // after show().
    void show_pen(std::vector<station::PenMoment> const& moments);

    // Shows another station, or one that has started again from the beginning.
    void begin_again(station::Station const& station, document::Document const& document);

    // Shows the plant with the scene's own growth again, after a preview of another growth.
    void show_growth();

    // Shows the plant as it would be with another growth.
    void preview(scene::SetGrowth const& growth);

    // Shows the plants as they would be in another season.
    void preview(std::optional<scene::Season> const& season);

    // Previews the document as `edits` would change it; an empty list ends the preview. New
    // snapshots are shown without the edits.
    void propose(std::vector<scene::Edit> edits);

    // Requests variations of the plant, of which the first has the plant's own seed.
    void collect(RequestCollection const& wanted);

    // From now on, shows plants bent along the ground instead of growing into it, or no longer.
    void set_along_ground(bool is_on);

    // Returns the scene from which the plant was grown, without previewed changes. Immutable;
    // shared with the background thread.
    std::shared_ptr<scene::Scene const> const& grown_scene() const { return grown_scene_; }

private:
    struct ProposalRequest {
        // Scene that `edits` would change. Immutable and shared.
        std::shared_ptr<scene::Scene const> scene;
        std::vector<scene::Edit> edits;
    };

    // A decoded picture; `image` is null if decoding failed, and `why` then gives the reason.
    struct ReadPicture {
        std::shared_ptr<std::string const> file;
        std::shared_ptr<render::Image const> image;
        std::string why {};
    };
    static ReadPicture read(std::shared_ptr<std::string const> const& file);

    // Ink of the strokes in progress: Station::inks(), copied once per frame.
    using Inks = std::span<std::vector<TipSample> const>;

    void show_grown();
    void show_picture(scene::Scene const& scene);
    void show_drawn_gizmo();
    void take_picture();
    void propose_outcome(station::Station const& station, std::vector<TipSample> const& ink);
    void take_proposal();
    void show_in_place(std::shared_ptr<scene::Scene const> const& scene);
    void show_live(station::Station const& station, document::Document const& document);
    void show_ink(station::Station const& station, Inks inks,
                  std::vector<tools::ToolStroke> const& waiting);
    void show_surface(station::Station const& station);
    void show_scene(std::shared_ptr<document::Snapshot const> const& snapshot);
    void show_strokes(scene::Scene const& scene);
    void show_curves(scene::Scene const& scene);
    void show_layers(scene::Scene const& scene);
    void update_layers();
    std::vector<ShownLayer> visible_layers() const;
    void show_underground(GrownUnderground const& underground);
    void request_plant(PlantRequest wanted);
    void show_variations();
    void show_preview(station::Station const& station, Inks inks);
    void take_preview();
    void set_preview(StrokePreview preview);
    void frame_preview();
    void take_first_plant();
    void show_paper();
    void list_orphans(scene::Scene const& scene);
    void show_selecting(station::Station const& station, Inks inks);
    void show_skeleton(tools::ShownSkeleton::Touched const& touched = {});
    void grow_plant(std::shared_ptr<document::Snapshot const> const& snapshot);
    void take_saved_snapshot(std::shared_ptr<document::Snapshot const> const& snapshot);

    // On the heap, as a thread keeps a reference to it.
    std::unique_ptr<PlantGrower> grower_ = std::make_unique<PlantGrower>();
    // Part of the snapshot that is shown. Shared with the grower.
    std::shared_ptr<scene::Scene const> grown_scene_;
    std::uint64_t shown_revision_ = 0; // Revision of the snapshot that is shown.
    // Revision of the drawn content of the snapshot that is shown.
    std::uint64_t shown_drawn_revision_ = 0;
    // Tips of the strokes in state_.strokes, in the same order. They only identify the strokes, so
    // they need not be in memory.
    std::vector<SharedVector<TipSample>> inked_;
    tools::DrawnCurveLists curve_lists_;
    ShownLayers layers_;
    scene::SetGrowth collected_growth_ {}; // Growth for which the variations were last requested.
    // Segments that growth takes below the ground. World frame.
    std::vector<std::vector<Vec3f>> grown_underground_mm_;
    Nib nib_ = Nib::Point; // Nib of the pen that draws.
    std::size_t finished_strokes_ = 0;
    std::size_t shown_tips_ = 0;
    double shown_surface_mm_ = 0; // Height of the surface when live_revision last changed.
    // Skeleton on which a selecting pen draws; created when needed.
    std::optional<tools::ShownSkeleton> shown_skeleton_;
    // Scene from which shown_skeleton_ was made. Shared, as the document may replace it meanwhile.
    std::shared_ptr<scene::Scene const> shown_scene_;
    // Function of the selected tool that returns the branches to be shaped next; null if it has
    // none.
    std::vector<SegmentId> (*aims_at_)(scene::Scene const& scene) = nullptr;
    // Branches highlighted as touched by the pen; no value while the pen does not select.
    std::optional<tools::ShownSkeleton::Touched> shown_touched_;
    SkeletonPicture skeleton_;
    scene::SelectionAngle shown_angle_;
    bool is_selecting_ = false;
    // On the heap, as threads keep references to it.
    std::unique_ptr<StrokePreviews> previews_ = std::make_unique<StrokePreviews>();
    std::uint64_t previewed_live_ = 0; // live_revision at the last request for a preview.
    // Lines of the preview that the state contains.
    std::shared_ptr<std::vector<tools::SkeletonLine> const> previewed_;
    // Box around the preview of the stroke with this number, if the plant's skeleton is empty.
    SteadyFrame preview_frame_ {};
    std::size_t framed_stroke_ = 0;
    // True while the first plant of an empty sheet is shown as far as it has been drawn, or about
    // to be.
    bool shows_first_plant_ = false;
    // Applies proposed edits in the background; its result is null if that fails. On the heap, as a
    // thread keeps a reference to it.
    std::unique_ptr<NewestJob<ProposalRequest, std::shared_ptr<scene::Scene const>>> proposal_;
    std::unique_ptr<NewestJob<std::shared_ptr<std::string const>, ReadPicture>> reading_;
    // Picture that is shown or is being decoded.
    std::shared_ptr<scene::BackPicture const> picture_;
    // Scene whose plant and skeleton are shown.
    std::shared_ptr<scene::Scene const> shown_in_place_;
    std::shared_ptr<scene::Scene const> gizmo_scene_;   // Scene for which the drawn gizmo is shown.
    tools::DrawnGizmoKind const* gizmo_kind_ = nullptr; // Kind of the drawn gizmo that is shown.
    // live_revision when the outcome of a stroke was last requested.
    std::uint64_t proposed_live_ = 0;
    bool is_outcome_proposed_ = false; // True while the outcome of an unfinished stroke is shown.
    bool is_proposed_ = false;         // True while proposed edits are shown or about to be.
    bool is_drawing_ = false;
    bool is_waiting_ = false; // True while finished strokes have not been applied.
    // Number of finished strokes that are shown as ink, as they are not in the scene yet.
    std::size_t shown_waiting_ = 0;
    // On the heap, so that the pointer to it in state_ stays valid when this object moves.
    std::unique_ptr<mesh::Mesh const> plant_;
    WindowState state_;
};

// Returns `growth` with the user's settings applied; its other members stay the same. Fails with a
// user error for an unknown preset.
Result<scene::SetGrowth> with_growth_settings(GrowthView const& wanted, scene::SetGrowth growth);

} // namespace tractus::view
