#include "studio/view3d/stage_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studio/app/session.h"
#include "studio/view3d/stage_scene.h"

namespace kumite::studio {

namespace {
constexpr std::size_t kMostGhosts = 12;
constexpr double kUsualPitch = 0.22;  // radians
}  // namespace

StageView::StageView(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), scene_(std::make_unique<Scene>(this)) {
    setAccessibleName(tr("3D view"));
    setAccessibleDescription(tr("The fighters at the playhead: a drag turns, the wheel zooms"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 200);
    scene_->canvas->setAttribute(Qt::WA_TransparentForMouseEvents);
    scene_->caption->setProperty("role", "second");
    scene_->caption->setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(&session_, &Session::takeChanged, this, &StageView::takeChanged);
    connect(&session_, &Session::fightersChanged, this, &StageView::bodiesChanged);
    connect(&session_, &Session::activePlayerChanged, this, [this] {
        pointToOtherFighter();
        showColours();
    });
    connect(&session_.transport(), &Transport::moved, this, &StageView::showPose);
    connect(this, &StageView::switchesChanged, this, &StageView::showCaption);
    showCaption();
    showColours();
    applyCamera();
}

StageView::~StageView() {
    // Before the scene: the widget's context must still be there when VTK lets go of it.
    delete scene_->canvas;
}

std::array<const FighterAnalysis*, 2> StageView::fighters() const {
    return {session_.fighter(0), session_.fighter(1)};
}

Viewport StageView::viewport() const {
    return {double(width()), double(height())};
}

void StageView::takeChanged() {
    scene_->measuring.click(std::nullopt);
    scene_->measuring.hovered.reset();
    followed_.reset();
    ghostTimes_.clear();
    bodiesChanged();
    if (!live_) frameAll();
    Q_EMIT switchesChanged();
}

void StageView::bodiesChanged() {
    if (live_) return;
    const auto present = fighters();
    for (std::size_t player = 0; player < present.size(); ++player) {
        auto& bones = scene_->bones[player];
        bones.clear();
        const FighterAnalysis* fighter = present[player];
        if (fighter == nullptr || !fighter->input.motion) continue;
        bones = bonesOf(*fighter->input.motion->skeleton, fighter->input.roles,
                        fighter->input.space.metresPerUnit);
    }
    showGhosts();
    showPose();
}

void StageView::beginLive(const QObject* owner, std::array<std::vector<Bone>, 2> bones) {
    setMeasuring(false);
    live_ = owner;
    scene_->handles = {};
    scene_->drag = {};
    followed_.reset();
    scene_->bones = std::move(bones);
    scene_->stage.clearGhosts();
    around_.clear();
    Q_EMIT switchesChanged();
}

void StageView::showLive(std::array<FigurePose, 2> poses) {
    scene_->poses = std::move(poses);
    for (int player = 0; player < 2; ++player) {
        const auto index = static_cast<std::size_t>(player);
        scene_->stage.figure(player).show(scene_->bones[index], scene_->poses[index], overlays_);
    }
    if (following_) follow();
    showLabels();
    scene_->canvas->markDirty();
}

void StageView::endLive(const QObject* owner) {
    if (live_ != owner) return;
    live_ = nullptr;
    scene_->handles = {};
    scene_->drag = {};
    followed_.reset();
    bodiesChanged();
    frameAll();
    Q_EMIT switchesChanged();
}

void StageView::setLiveGhosts(const std::vector<StageGhost>& ghosts) {
    if (!live_) return;
    scene_->stage.clearGhosts();
    for (const StageGhost& ghost : ghosts)
        scene_->stage.addGhost(ghost.player, scene_->bones[static_cast<std::size_t>(ghost.player)],
                               ghost.joints);
    scene_->canvas->markDirty();
}

void StageView::setPointingAtFloor(bool on) {
    pointsAtFloor_ = on;
    setMouseTracking(on || isMeasuring());
    if (!on) setFloorMark(std::nullopt, false);
}

void StageView::setFloorMark(const std::optional<Eigen::Vector2d>& place, bool faint) {
    scene_->stage.setFloorMark(place, faint);
    scene_->canvas->markDirty();
}

std::optional<Eigen::Vector3d> StageView::middle() const {
    if (!live_) return followedPoint(fighters(), session_.transport().shownTime());
    Box box;
    for (const FigurePose& pose : scene_->poses) {
        if (!pose.joints.empty()) box.add(pose.joints.front().cast<double>());
    }
    return box.empty() ? std::nullopt : std::optional(box.centre());
}

void StageView::showPose() {
    if (live_) return;
    const auto present = fighters();
    for (int player = 0; player < 2; ++player) {
        const auto index = static_cast<std::size_t>(player);
        FigurePose& pose = scene_->poses[index];
        pose = present[index] != nullptr
                   ? poseAt(*present[index], session_.shownFrame(player), overlays_)
                   : FigurePose{};
        scene_->stage.figure(player).show(scene_->bones[index], pose, overlays_);
    }
    if (const QString around = aroundAction(); around != around_) {
        around_ = around;
        showCaption();
    }
    if (following_) follow();
    showLabels();
    scene_->canvas->markDirty();
}

void StageView::follow() {
    const auto now = middle();
    if (!now) return;
    // Along the floor only: a view that bobs with every step makes one seasick.
    Eigen::Vector3d way = *now - followed_.value_or(scene_->camera.target());
    way.y() = 0;
    scene_->camera.move(way);
    followed_ = now;
    scene_->stage.setCamera(scene_->camera);
}

void StageView::setFollowing(bool following) {
    following_ = following;
    followed_.reset();
    if (following_) {
        follow();
        applyCamera();
    }
    Q_EMIT switchesChanged();
}

void StageView::setOverlays(const Overlays& overlays) {
    if (overlays == overlays_) return;
    overlays_ = overlays;
    overlays_.trailBefore = std::clamp(overlays.trailBefore, 0, Overlays::kLongestTrail);
    overlays_.trailAfter = std::clamp(overlays.trailAfter, 0, Overlays::kLongestTrail);
    showGhosts();
    showPose();
    Q_EMIT switchesChanged();
}

void StageView::addGhost() {
    const double now = session_.transport().shownTime();
    if (std::find(ghostTimes_.begin(), ghostTimes_.end(), now) != ghostTimes_.end()) return;
    if (ghostTimes_.size() == kMostGhosts) ghostTimes_.erase(ghostTimes_.begin());
    ghostTimes_.push_back(now);
    overlays_.ghosts = true;
    showGhosts();
    Q_EMIT switchesChanged();
}

void StageView::clearGhosts() {
    ghostTimes_.clear();
    showGhosts();
    Q_EMIT switchesChanged();
}

void StageView::showGhosts() {
    scene_->stage.clearGhosts();
    if (live_) return;
    const auto present = fighters();
    for (const double time : ghostTimes_) {
        for (std::size_t player = 0; overlays_.ghosts && player < present.size(); ++player) {
            const FighterAnalysis* fighter = present[player];
            if (fighter == nullptr || fighter->frameCount() == 0) continue;
            scene_->stage.addGhost(static_cast<int>(player), scene_->bones[player],
                                   jointsAt(*fighter, frameAtTime(fighter->input, time)));
        }
    }
    scene_->canvas->markDirty();
}

void StageView::showColours() {
    const int active = session_.playerCount() > 1 ? session_.activePlayer() : -1;
    scene_->stage.setColours(coloursFor(palette()), active);
    showLabels();
    scene_->canvas->markDirty();
}

void StageView::applyCamera() {
    scene_->stage.setCamera(scene_->camera);
    showLabels();
    scene_->canvas->markDirty();
}

void StageView::frameAll() {
    Box box;
    for (const FighterAnalysis* fighter : fighters()) {
        if (fighter != nullptr && !live_) addPath(box, *fighter);
    }
    for (const FigurePose& pose : scene_->poses) {
        // A bout has no path yet: room for a few steps around where it is.
        for (const auto& joint : live_ ? pose.joints : std::vector<Eigen::Vector3f>{}) {
            const Eigen::Vector3d at = joint.cast<double>();
            box.add({at.x() - 0.5, std::max(0.0, at.y()), at.z() - 0.5});
            box.add({at.x() + 0.5, std::max(1.8, at.y()), at.z() + 0.5});
        }
    }
    scene_->stage.floor().cover(box);
    scene_->camera.frame(box, viewport());
    applyCamera();
}

void StageView::frameFighters(double begin, double end) {
    const Places places = placesBetween(begin, end);
    Box box;
    for (const Box& place : places) {
        if (place.empty()) continue;
        box.add(place.low);
        box.add(place.high);
    }
    if (box.empty()) return;
    box.low.array() -= 0.15;
    box.high.array() += 0.15;
    turnAside(places);
    scene_->camera.frame(box, viewport());
    applyCamera();
}

void StageView::showBoth(double begin, double end) {
    if (turnAside(placesBetween(begin, end))) frameFighters(begin, end);
}

StageView::Places StageView::placesBetween(double begin, double end) const {
    Places places;
    for (int player = 0; player < 2; ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        if (fighter == nullptr || fighter->frameCount() == 0) continue;
        for (const double moment : {begin, 0.5 * (begin + end), end}) {
            const int frame = frameAtTime(fighter->input, moment);
            for (const auto& joint : jointsAt(*fighter, frame))
                places[static_cast<std::size_t>(player)].add(joint.cast<double>());
        }
    }
    return places;
}

bool StageView::turnAside(const Places& places) {
    if (places[0].empty() || places[1].empty()) return false;
    Eigen::Vector3d between = places[1].centre() - places[0].centre();
    between.y() = 0;
    Eigen::Vector3d ahead = scene_->camera.forward();
    ahead.y() = 0;
    constexpr double kHides = 0.6;  // cosine of the angle from which on one hides the other
    const double along = between.norm() > 0.05 && ahead.norm() > 0.05
                             ? between.normalized().dot(ahead.normalized())
                             : 0.0;
    if (std::abs(along) <= kHides) return false;
    const Eigen::Vector3d side(between.z(), 0, -between.x());
    const Eigen::Vector3d from = side.dot(ahead) < 0 ? side : Eigen::Vector3d(-side);
    scene_->camera.lookFrom(std::atan2(from.x(), from.z()), kUsualPitch);
    return true;
}

void StageView::frameActiveFighter() {
    const FighterAnalysis* fighter = session_.fighter(session_.activePlayer());
    if (fighter == nullptr) return;
    Box box;
    for (const auto& joint : jointsAt(*fighter, session_.shownFrame(session_.activePlayer())))
        box.add(joint.cast<double>());
    box.low.array() -= 0.15;
    box.high.array() += 0.15;
    scene_->camera.frame(box, viewport());
    applyCamera();
}

void StageView::lookFrom(double yaw, double pitch) {
    scene_->camera.lookFrom(yaw, pitch);
    applyCamera();
}

void StageView::lookFromFront() {
    lookFrom(0, 0);
}

void StageView::lookFromSide() {
    lookFrom(std::numbers::pi / 2, 0);
}

void StageView::lookFromTop() {
    lookFrom(0, std::numbers::pi / 2);
}

void StageView::lookOverShoulder(int player) {
    const auto view = overShoulder(fighters(), player, session_.transport().shownTime());
    if (!view) return;
    scene_->camera.standAt(view->position, view->target);
    applyCamera();
}

QImage StageView::picture() {
    QImage image = scene_->canvas->picture();
    QPainter painter(&image);
    scene_->labels->render(&painter, {}, {}, QWidget::DrawChildren);
    painter.end();
    return image;
}

void StageView::setTools(QWidget* tools) {
    tools_ = tools;
    tools_->setParent(this);
    tools_->show();
    placeOverlays();
}

/// While the chosen action plays in a loop with some time around it: whether it has begun.
QString StageView::aroundAction() const {
    const Transport& transport = session_.transport();
    const auto& action = session_.selectedAction();
    if (!action || !transport.isLooping() || live_) return {};
    const TimeSpan span = session_.spanOf(*action);
    const double now = transport.shownTime();
    if (now < span.begin && transport.loopIn() <= now) return tr("before the action");
    return now >= span.end && now <= transport.loopOut() ? tr("after the action") : QString();
}

void StageView::showCaption() {
    QString text = tr("grid 1 m");
    text += tr("   ·   left limbs lighter");
    if (overlays_.force && !isLive()) text += tr("   ·   arrow: contact force, 0.5 m per BW");
    if (!around_.isEmpty()) text = around_ + QStringLiteral("   ·   ") + text;
    if (isMeasuring()) text = measuringHint_;
    caption_ = text;
    placeOverlays();
}

void StageView::setMeasuringHint(const QString& hint) {
    measuringHint_ = hint;
    showCaption();
}

void StageView::placeOverlays() {
    scene_->canvas->setGeometry(rect());
    scene_->labels->setGeometry(rect());
    QLabel* caption = scene_->caption;
    const int room = width() - 24;
    caption->setWordWrap(false);
    caption->setText(caption_);
    caption->adjustSize();
    if (caption->width() > room) {
        // A narrow view: in two lines.
        caption->setWordWrap(true);
        caption->resize(room, caption->heightForWidth(room));
    }
    caption->move(12, height() - caption->height() - 8);
    if (tools_ == nullptr) return;
    tools_->adjustSize();
    tools_->move(width() - tools_->width() - 8, 8);
}

void StageView::resizeEvent(QResizeEvent*) {
    placeOverlays();
    showLabels();
}

void StageView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) showColours();
    QWidget::changeEvent(event);
}

}  // namespace kumite::studio
