#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/motion/blend.h"
#include "core/motion/inertialise.h"
#include "core/transition/bezier.h"
#include "core/transition/flexible_graph.h"

namespace kumite {

/// Along recorded clips of the graph; on a Bézier curve past medoids; straight from pose to pose
/// (for comparison: without any smoothing at its ends).
enum class TransitionMethod { Graph, Bezier, Linear };
std::string_view methodName(TransitionMethod method);  ///< "graph", "bezier", "linear"
std::optional<TransitionMethod> methodNamed(std::string_view name);

struct TransitionSettings {
    int backFrames = 10;       ///< rows of the distance grid: last frames of what is there
    int frontFrames = 25;      ///< its columns: first frames of a clip that comes in
    int actionFrames = 10;     ///< its columns where the wanted action comes in
    double longestClip = 1.5;  ///< seconds; longer clips only where an edge has no shorter one
    double speed = 6;          ///< σ: pose distance per second of a curve
    JoinSettings join;

    bool operator==(const TransitionSettings&) const = default;
};

/// How an author wants one transition.
struct TransitionRequest {
    std::optional<TransitionMethod> method;  ///< nothing: graph where there is a path, else Bézier
    std::uint64_t seed = 1;                  ///< draws the path
    std::optional<int> path;                 ///< this one of the candidates, nothing drawn

    bool operator==(const TransitionRequest&) const = default;
};

/// Distances of the last frames of what was there (rows, the last row is the last frame) and the
/// first frames of what came in (columns), and where they were joined.
struct DistanceGrid {
    int rows = 0;
    int columns = 0;
    std::vector<float> distances;  ///< row by row
    int row = 0;
    int column = 0;

    float at(int r, int c) const { return distances[static_cast<std::size_t>(r * columns + c)]; }
};

/// What a transition came to.
struct TransitionReport {
    TransitionMethod method = TransitionMethod::Graph;
    NearestPoint source, target;  ///< clusters of the last frame before and the first one after
    std::vector<CandidatePath> candidates;  ///< all there were, cheapest first
    int chosen = -1;                        ///< among them; −1: a curve
    std::vector<int> visited;               ///< clusters: the path, or the curve's walk
    std::vector<EdgeClip> clips;            ///< of the library, one per edge
    std::vector<DistanceGrid> grids;        ///< one per join along a path
    std::vector<int> joins;                 ///< frames of the strip where two motions meet
    double cost() const;                    ///< of the chosen path, 0 without one
};

/// The candidates from the pose at the end of some frames to the first pose of others, and where
/// both lie in the graph: what an author chooses from.
TransitionReport locate(const FlexibleGraph& graph, std::span<const Pose> from,
                        std::span<const Pose> to);

/// Motion that grows at its end: actions, led over to each other. Poses stand in one space; the
/// first action stands where it was recorded.
class MotionStrip {
public:
    MotionStrip(std::shared_ptr<const FlexibleGraph> graph, TransitionSettings settings);

    const std::vector<Pose>& frames() const { return frames_; }
    const std::vector<Standing>& standing() const { return standing_; }
    int frameCount() const { return static_cast<int>(frames_.size()); }
    double rate() const { return graph_->library->rate; }

    /// Drops the first `count` frames.
    void dropFirst(int count);

    /// The action alone, instead of what was there.
    void begin(MotionPart action);

    /// What `lead` has added.
    struct Led {
        TransitionReport report;
        int transitionBegin = 0;  ///< first frame that is no longer of what was there
        int actionBegin = 0;      ///< frame where the action is met
        int actionEntered = 0;    ///< the action's frame that is shown there
    };
    /// Drops the frames from `end` on and adds a transition to `action` and the action itself.
    /// Frames before `untouchable` stay: a join may drop later ones. Throws Error, and changes
    /// nothing, if nothing is before `end`, the action is empty, or what was asked for is not there
    /// (no path; no candidate of that number).
    Led lead(MotionPart action, const TransitionRequest& request, int untouchable, int end);
    /// The same after all that is there.
    Led lead(MotionPart action, const TransitionRequest& request, int untouchable = 0) {
        return lead(action, request, untouchable, frameCount());
    }

private:
    EdgeClip bestClip(const GraphEdge& edge) const;
    DistanceGrid join(MotionPart incoming, int backFrames, int frontFrames);
    void joinAt(MotionPart incoming, int row, int column, bool smooth);
    int curveLength(MotionPart action) const;
    void addCurve(const PoseCurve& curve, MotionPart action, int count, bool smooth);
    void leadAlong(MotionPart action, int untouchable, Led& led);
    void leadOnCurve(MotionPart action, Led& led);
    void cut(int count);

    std::shared_ptr<const FlexibleGraph> graph_;
    TransitionSettings settings_;
    PathSearch search_;
    std::vector<Pose> frames_;
    std::vector<Standing> standing_;
};

}  // namespace kumite
