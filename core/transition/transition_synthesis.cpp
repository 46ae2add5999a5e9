#include "core/transition/transition_synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "core/base/error.h"

namespace kumite {
namespace {

/// An index drawn with probability inverse to the cost; the same on every platform.
int drawn(const std::vector<CandidatePath>& candidates, std::uint64_t seed) {
    if (candidates.size() == 1) return 0;
    std::vector<double> upTo;
    for (const CandidatePath& path : candidates)
        upTo.push_back((upTo.empty() ? 0 : upTo.back()) + 1 / path.cost);
    std::mt19937_64 random(seed);
    const double at = static_cast<double>(random() >> 11) * 0x1p-53 * upTo.back();
    const auto it = std::upper_bound(upTo.begin(), upTo.end() - 1, at);
    return static_cast<int>(it - upTo.begin());
}

int chosenPath(const std::vector<CandidatePath>& candidates, const TransitionRequest& request) {
    if (candidates.empty()) {
        throw Error(
            "There is no path in the graph between these two actions; choose a curve, or clips "
            "played backward.");
    }
    if (!request.path) return drawn(candidates, request.seed);
    if (*request.path < 0 || *request.path >= static_cast<int>(candidates.size())) {
        throw Error(fmt::format("There are {} candidate paths, counted from 0: no path {}.",
                                candidates.size(), *request.path));
    }
    return *request.path;
}

NearestPoint nearestCluster(const FlexibleGraph& graph, std::span<const Pose> frames, int frame) {
    std::vector<double> point(graph.metric.shape().width());
    graph.metric.point(frames, frame, graph.library->rate, point.data());
    return graph.clusters.centres.nearest(point.data());
}

TransitionReport located(const FlexibleGraph& graph, PathSearch& search, std::span<const Pose> from,
                         std::span<const Pose> to) {
    TransitionReport report;
    report.source = nearestCluster(graph, from, static_cast<int>(from.size()) - 1);
    report.target = nearestCluster(graph, to, 0);
    report.candidates = search.paths(report.source.id, report.target.id);
    return report;
}

/// What brings a pose's root over the origin and its heading to +z.
GroundTransform toHome(const Rig& rig, const Pose& pose) {
    const double yaw = headingOf(rig, pose).value_or(0.0);
    return GroundTransform{-yaw, 0, 0} * GroundTransform{0, -pose.root.x(), -pose.root.z()};
}

/// The step on the ground from one pose to the next, in the frame of the first.
GroundTransform stepOf(const Rig& rig, const Pose& before, const Pose& after) {
    return toHome(rig, before) * toHome(rig, after).inverse();
}

}  // namespace

std::string_view methodName(TransitionMethod method) {
    switch (method) {
        case TransitionMethod::Graph:
            return "graph";
        case TransitionMethod::Bezier:
            return "bezier";
        case TransitionMethod::Linear:
            break;
    }
    return "linear";
}

std::optional<TransitionMethod> methodNamed(std::string_view name) {
    for (const auto method :
         {TransitionMethod::Graph, TransitionMethod::Bezier, TransitionMethod::Linear}) {
        if (methodName(method) == name) return method;
    }
    return std::nullopt;
}

double TransitionReport::cost() const {
    return chosen < 0 ? 0 : candidates[static_cast<std::size_t>(chosen)].cost;
}

TransitionReport locate(const FlexibleGraph& graph, std::span<const Pose> from,
                        std::span<const Pose> to) {
    PathSearch search = graph.search;
    return located(graph, search, from, to);
}

MotionStrip::MotionStrip(std::shared_ptr<const FlexibleGraph> graph, TransitionSettings settings)
    : graph_(std::move(graph)), settings_(settings), search_(graph_->search) {}

void MotionStrip::cut(int count) {
    frames_.resize(static_cast<std::size_t>(count));
    standing_.resize(static_cast<std::size_t>(count));
}

void MotionStrip::dropFirst(int count) {
    frames_.erase(frames_.begin(), frames_.begin() + count);
    standing_.erase(standing_.begin(), standing_.begin() + count);
}

void MotionStrip::begin(MotionPart action) {
    frames_.assign(action.poses.begin(), action.poses.end());
    standing_.assign(action.standing.begin(), action.standing.end());
}

/// Of the clips that are short enough (or the shortest, if none is) the one whose first frame is
/// nearest to the strip's last.
EdgeClip MotionStrip::bestClip(const GraphEdge& edge) const {
    const MetricShape& shape = graph_->metric.shape();
    std::vector<double> last(shape.width()), first(shape.width());
    graph_->metric.point(frames_, frameCount() - 1, rate(), last.data());
    const int longest = std::max(edge.shortest(), static_cast<int>(settings_.longestClip * rate()));
    const EdgeClip* best = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (const EdgeClip& clip : edge.clips) {
        if (clip.frames.size() > longest) continue;
        const auto& frames =
            graph_->library->motions[static_cast<std::size_t>(clip.motion)].clip.frames;
        graph_->metric.point(frames, clip.firstFrame(), rate(), first.data());
        if (clip.backward) graph_->metric.reverse(first.data());
        const double d = metricDistanceWithin(shape, last.data(), first.data(), nearest);
        if (best && d >= nearest) continue;
        nearest = d;
        best = &clip;
    }
    return *best;
}

void MotionStrip::joinAt(MotionPart incoming, int row, int column, bool smooth) {
    cut(row + 1);
    const Rig& rig = *graph_->library->rig;
    const std::span<const Pose> poses = incoming.poses;
    const auto at = static_cast<std::size_t>(column);
    const Pose shown = frames_.back();
    const GroundTransform place = groundAlignment(rig, poses[at], shown);
    const double dt = 1 / rate();
    Inertialisation offset;
    if (smooth) {
        const Pose& before = frames_[static_cast<std::size_t>(std::max(0, row - 1))];
        const Pose& after = poses[std::min(at + 1, poses.size() - 1)];
        offset = Inertialisation(before, shown, moved(poses[at], place), moved(after, place), dt,
                                 settings_.join);
    }
    for (std::size_t i = at + 1; i < poses.size(); ++i) {
        Pose& pose = frames_.emplace_back(moved(poses[i], place));
        standing_.push_back(incoming.standing[i]);
        const double seconds = static_cast<double>(i - at) * dt;
        if (smooth && !offset.over(seconds)) offset.apply(pose, seconds);
    }
}

/// Joins at the nearest pair of a last frame and a first one (paper B, Fig. 6; of equals the one
/// that drops least).
DistanceGrid MotionStrip::join(MotionPart incoming, int backFrames, int frontFrames) {
    const PoseMetric& metric = graph_->metric;
    const MetricShape& shape = metric.shape();
    DistanceGrid grid;
    grid.rows = std::clamp(backFrames, 1, frameCount());
    // Half of what comes in is to be seen.
    grid.columns = std::clamp(frontFrames, 1, std::max(1, incoming.size() / 2));
    const int first = frameCount() - grid.rows;
    MetricPoints columns{shape, {}};
    columns.values.resize(shape.width() * static_cast<std::size_t>(grid.columns));
    for (int c = 0; c < grid.columns; ++c) {
        metric.point(incoming.poses, c, rate(),
                     columns.values.data() + shape.width() * static_cast<std::size_t>(c));
    }
    std::vector<double> row(shape.width());
    double nearest = std::numeric_limits<double>::infinity();
    grid.distances.resize(static_cast<std::size_t>(grid.rows * grid.columns));
    for (int r = grid.rows - 1; r >= 0; --r) {
        metric.point(frames_, first + r, rate(), row.data());
        for (int c = 0; c < grid.columns; ++c) {
            const double d = metricDistance(shape, row.data(), columns.at(c));
            grid.distances[static_cast<std::size_t>(r * grid.columns + c)] = static_cast<float>(d);
            if (d >= nearest) continue;
            nearest = d;
            grid.row = r;
            grid.column = c;
        }
    }
    joinAt(incoming, first + grid.row, grid.column, true);
    return grid;
}

/// Frames of a curve: distance / σ (paper B, equation 2), at least two.
int MotionStrip::curveLength(MotionPart action) const {
    const PoseMetric& metric = graph_->metric;
    std::vector<double> from(metric.shape().width()), to(from.size());
    metric.point(frames_, frameCount() - 1, rate(), from.data());
    metric.point(action.poses, 0, rate(), to.data());
    const double distance = metricDistance(metric.shape(), from.data(), to.data());
    return std::max(2, static_cast<int>(std::lround(distance / settings_.speed * rate())));
}

/// `count` frames along a curve whose poses stand at home, the speed over ground going over from
/// the strip's to the action's.
void MotionStrip::addCurve(const PoseCurve& curve, MotionPart action, int count, bool smooth) {
    const Rig& rig = *graph_->library->rig;
    const Pose& last = frames_.back();
    const GroundTransform out =
        frameCount() > 1 ? stepOf(rig, frames_[frames_.size() - 2], last) : GroundTransform{};
    const GroundTransform in =
        action.size() > 1 ? stepOf(rig, action.poses[0], action.poses[1]) : GroundTransform{};
    GroundTransform place = toHome(rig, last).inverse();
    std::vector<Pose> poses = {last};
    std::vector<Standing> standing = {standing_.back()};
    for (int i = 1; i <= count; ++i) {
        const double middle = (i - 0.5) / count;
        const double s = middle * middle * (3 - 2 * middle);
        const auto between = [s](double a, double b) { return a + s * (b - a); };
        place = place * GroundTransform{between(out.yaw, in.yaw), between(out.x, in.x),
                                        between(out.z, in.z)};
        poses.push_back(moved(curve.at(static_cast<double>(i) / count), place));
        standing.push_back(2 * i < count ? standing_.back() : action.standing.front());
    }
    joinAt({poses, standing}, frameCount() - 1, 0, smooth);
}

MotionStrip::Led MotionStrip::lead(MotionPart action, const TransitionRequest& request,
                                   int untouchable, int end) {
    if (end <= 0 || end > frameCount() || action.empty())
        throw Error("A transition needs motion on both sides.");
    const FlexibleGraph& graph = *graph_;
    const std::span<const Pose> before =
        std::span<const Pose>(frames_).first(static_cast<std::size_t>(end));
    Led led;
    led.report = located(graph, search_, before, action.poses);
    TransitionReport& report = led.report;
    // Who asks for a certain path hears that there is none.
    const bool curve = report.candidates.empty() && !request.path;
    report.method =
        request.method.value_or(curve ? TransitionMethod::Bezier : TransitionMethod::Graph);
    if (report.method == TransitionMethod::Graph) {
        report.chosen = chosenPath(report.candidates, request);
        report.visited = report.candidates[static_cast<std::size_t>(report.chosen)].nodes;
    } else if (report.method == TransitionMethod::Bezier) {
        report.visited = medoidWalk(graph.clusters.centres, report.source.id, report.target.id);
    }
    cut(end);
    led.transitionBegin = end;
    if (report.method == TransitionMethod::Graph) {
        leadAlong(action, untouchable, led);
    } else {
        leadOnCurve(action, led);
    }
    return led;
}

/// From edge to edge of the path, then to the action (paper B, "Synthesize the Transition").
void MotionStrip::leadAlong(MotionPart action, int untouchable, Led& led) {
    TransitionReport& report = led.report;
    const auto meet = [&](MotionPart incoming, int frontFrames) {
        const int rows =
            std::min(settings_.backFrames, frameCount() - std::max(0, untouchable - 1));
        report.grids.push_back(join(incoming, rows, frontFrames));
    };
    int met = frameCount();
    for (std::size_t i = 0; i < report.visited.size(); ++i) {
        const int before = frameCount();
        if (i + 1 < report.visited.size()) {
            const GraphEdge& edge = *graph_->graph.find(report.visited[i], report.visited[i + 1]);
            const EdgeClip clip = bestClip(edge);
            report.clips.push_back(clip);
            const LibraryMotion& motion =
                graph_->library->motions[static_cast<std::size_t>(clip.motion)];
            const MotionPart part =
                MotionPart{motion.clip.frames, motion.standing}.part(clip.frames);
            if (clip.backward) {
                const std::vector<Pose> poses(part.poses.rbegin(), part.poses.rend());
                const std::vector<Standing> standing(part.standing.rbegin(), part.standing.rend());
                meet({poses, standing}, settings_.frontFrames);
            } else {
                meet(part, settings_.frontFrames);
            }
        } else {
            meet(action, settings_.actionFrames);
        }
        const DistanceGrid& grid = report.grids.back();
        met = before - grid.rows + grid.row;
        // A join may drop frames back beyond an earlier one.
        while (!report.joins.empty() && report.joins.back() >= met)
            report.joins.pop_back();
        report.joins.push_back(met);
        led.transitionBegin = std::min(led.transitionBegin, met + 1);
    }
    led.actionBegin = met;
    led.actionEntered = report.grids.back().column;
}

/// Where the graph has no path, or none is wanted (paper B, "Bezier Interpolation").
void MotionStrip::leadOnCurve(MotionPart action, Led& led) {
    const bool smooth = led.report.method == TransitionMethod::Bezier;
    const Rig& rig = *graph_->library->rig;
    const auto home = [&](const Pose& pose) { return moved(pose, toHome(rig, pose)); };
    std::vector<Pose> visited;
    for (const int cluster : led.report.visited)
        visited.push_back(home(graph_->medoid(cluster)));
    const PoseCurve curve = curveThrough(home(frames_.back()), visited, home(action.poses.front()));
    addCurve(curve, action, curveLength(action), smooth);
    led.actionBegin = frameCount() - 1;
    led.report.joins = {led.transitionBegin - 1, led.actionBegin};
    joinAt(action, led.actionBegin, 0, smooth);
}

}  // namespace kumite
