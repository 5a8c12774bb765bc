#pragma once

#include "app/document/document.h"
#include "app/station/station.h"
#include "app/tools/shown_skeleton.h"
#include "app/tools/stroke_previewer.h"
#include "app/view/plant_grower.h"
#include "app/view/shown_layers.h"
#include "app/view/skeleton_picture.h"
#include "app/view/window_model.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus::view {

// View state of a station and of the document that receives its strokes: the hand, its strokes, the
// selection, and the plant, which is regrown in the background after each stroke. It does not
// depend on where the reports come from. The owner adds everything else to state().
class StationView {
public:
    StationView(station::Station const& station, document::Document const& document);

    WindowState& state() { return state_; }
    WindowState const& state() const { return state_; }

    // Updates the state with all changes since the last call.
    void show(station::Station const& station, document::Document const& document);

    // Advances the window's clock, which fades layers.
    void pass(Duration step);

    // Sets the status to a message about what a stroke has done.
    void tell(document::DrawnStroke const& drawn);

    // Waits for the plant requested last and for all variations, and shows them.
    void settle();

    // Reports the pen's movements since the last call, for windows operated by the pen. Call after
    // show().
    void show_pen(std::vector<station::PenMoment> const& moments);

    // Replaces the station, or starts over with one that was restarted.
    void begin_again(station::Station const& station, document::Document const& document);

    // Ends the preview of another growth.
    void show_growth();

    // Previews another growth.
    void preview(scene::SetGrowth const& growth);

    // Previews another season.
    void preview(std::optional<scene::Season> const& season);

    // Previews the document as edits would change it; an empty list ends the preview. New snapshots
    // are shown without the edits.
    void propose(std::vector<scene::Edit> edits);

    // Grows variations of the plant, starting at its own seed.
    void collect(RequestCollection const& wanted);

    // Bends plants along the ground instead of into it from now on.
    void set_along_ground(bool is_on);

    // The scene from which the plant was grown, without previews. Immutable; shared with the
    // background thread.
    std::shared_ptr<scene::Scene const> const& grown_scene() const { return grown_scene_; }

private:
    struct PreviewRequest {
        // Scene on which the stroke is drawn. Immutable and shared.
        std::shared_ptr<scene::Scene const> scene;
        tools::Tool tool {};
        std::vector<TipSample> ink {};
        std::uint32_t orders = 0; // Only branches of lower orders than this are considered.
        std::size_t stroke = 0;   // Number of the stroke to preview.
    };
    struct Preview {
        // The previewed branches; null: no preview. Immutable; shared by equal previews.
        std::shared_ptr<std::vector<tools::SkeletonLine> const> lines {};
        std::string note {};
        std::size_t stroke = 0; // Number of the previewed stroke.
    };
    // The previewer of strokes in progress; used on the background thread.
    struct Previewing {
        Preview show(PreviewRequest const& wanted);

        std::unique_ptr<tools::StrokePreviewer> (*made_by)() = nullptr;
        std::unique_ptr<tools::StrokePreviewer> previewer {};
        std::shared_ptr<std::vector<tools::SkeletonLine> const> last {};
    };

    struct ProposalRequest {
        // Scene that the edits would change. Immutable and shared.
        std::shared_ptr<scene::Scene const> scene;
        std::vector<scene::Edit> edits;
    };

    // A decoded picture, or null and the reason for the failure.
    struct ReadPicture {
        std::shared_ptr<std::string const> file;
        std::shared_ptr<render::Image const> image;
        std::string why {};
    };
    static ReadPicture read(std::shared_ptr<std::string const> const& file);

    // Station::inks(), copied once per frame.
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
    void set_preview(Preview preview);
    void list_orphans(scene::Scene const& scene);
    void show_selecting(station::Station const& station, Inks inks);
    void show_skeleton(tools::ShownSkeleton::Touched const& touched = {});
    void grow_plant(std::shared_ptr<document::Snapshot const> const& snapshot);
    void take_saved_snapshot(std::shared_ptr<document::Snapshot const> const& snapshot);

    // On the heap, as a thread refers to it.
    std::unique_ptr<PlantGrower> grower_ = std::make_unique<PlantGrower>();
    std::shared_ptr<scene::Scene const> grown_scene_; // Part of a snapshot; shared with the grower.
    std::uint64_t shown_revision_ = 0;                // Revision of the snapshot shown.
    std::uint64_t shown_drawn_revision_ = 0;          // Revision of that snapshot's drawn content.
    // Tips of the strokes shown in state_.strokes, in the same order; used as identity only, so
    // they need not be in memory.
    std::vector<SharedVector<TipSample>> inked_;
    tools::DrawnCurveLists curve_lists_;
    ShownLayers layers_;
    scene::SetGrowth collected_growth_ {}; // Growth of the collection requested last.
    // Segments that growth takes below the ground. World frame.
    std::vector<std::vector<Vec3f>> grown_underground_mm_;
    Nib nib_ = Nib::Point; // Nib of the pen whose ink is shown.
    std::size_t finished_strokes_ = 0;
    std::size_t shown_tips_ = 0;
    double shown_surface_mm_ = 0; // Surface height at the last change of live_revision.
    // Skeleton on which a selecting pen draws, and the scene it was made from; created on demand.
    std::optional<tools::ShownSkeleton> shown_skeleton_;
    // Scene of shown_skeleton_. Shared with the document, which may replace it meanwhile.
    std::shared_ptr<scene::Scene const> shown_scene_;
    // Function of the selected tool that returns the branch to be shaped next, or null.
    std::vector<SegmentId> (*aims_at_)(scene::Scene const& scene) = nullptr;
    // Touched branches as currently highlighted.
    std::optional<tools::ShownSkeleton::Touched> shown_touched_;
    SkeletonPicture skeleton_;
    scene::SelectionAngle shown_angle_;
    bool is_selecting_ = false;
    // On the heap, as a thread refers to it.
    std::unique_ptr<NewestJob<PreviewRequest, Preview>> preview_;
    std::uint64_t previewed_live_ = 0; // live_revision for which a preview was requested last.
    // Preview shown in the state.
    std::shared_ptr<std::vector<tools::SkeletonLine> const> previewed_;
    // Job that applies proposed edits; returns null if they fail. On the heap, as a thread refers
    // to it.
    std::unique_ptr<NewestJob<ProposalRequest, std::shared_ptr<scene::Scene const>>> proposal_;
    std::unique_ptr<NewestJob<std::shared_ptr<std::string const>, ReadPicture>> reading_;
    std::shared_ptr<scene::BackPicture const> picture_; // Picture that is shown or being decoded.
    // Scene of the plant and skeleton currently shown.
    std::shared_ptr<scene::Scene const> shown_in_place_;
    std::shared_ptr<scene::Scene const> gizmo_scene_;   // Scene shown by the drawn gizmo.
    tools::DrawnGizmoKind const* gizmo_kind_ = nullptr; // Kind of the drawn gizmo.
    std::uint64_t proposed_live_ = 0;  // live_revision for which an outcome was requested last.
    bool is_outcome_proposed_ = false; // True while the outcome of an unfinished stroke is shown.
    bool is_proposed_ = false;         // True while proposed edits are shown or about to be.
    bool is_drawing_ = false;
    std::size_t shown_waiting_ = 0; // Number of waiting strokes shown as ink.
    // On the heap, so that the state's pointer stays valid when this object moves.
    std::unique_ptr<mesh::Mesh const> plant_;
    WindowState state_;
};

// Applies the user's settings to a plant's growth; everything else stays. Fails with a user error
// for an unknown preset.
Result<scene::SetGrowth> with_growth_settings(GrowthView const& wanted, scene::SetGrowth growth);

} // namespace tractus::view
