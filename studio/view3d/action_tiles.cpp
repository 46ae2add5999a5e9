#include "studio/view3d/action_tiles.h"

#include <QKeyEvent>
#include <QPainter>

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/grid_keys.h"
#include "studio/app/theme.h"
#include "studio/view3d/bones.h"
#include "studio/view3d/pose.h"
#include "studio/view3d/stage.h"
#include "studio/view3d/vtk_widget.h"

namespace kumite::studio {

namespace {

constexpr double kRatio = 0.95;  ///< width over height of a tile with its caption
constexpr double kGap = 4;
constexpr int kQuickest = 50;  ///< milliseconds between two pictures
constexpr int kSlowest = 250;
constexpr double kHold = 0.4;   ///< seconds that the last pose stays
constexpr double kAside = 0.7;  ///< radians between where a fighter faces and the camera
constexpr double kPitch = 0.12;

/// All that the action's fighter covers while it lasts, with room for its body.
Box boxOf(const FighterAnalysis& fighter, double begin, double end) {
    constexpr int kSamples = 5;
    Box box;
    for (int i = 0; i < kSamples; ++i) {
        const double time = begin + (end - begin) * i / (kSamples - 1);
        for (const auto& joint : jointsAt(fighter, frameAtTime(fighter.input, time)))
            box.add(joint.cast<double>());
    }
    box.low.array() -= 0.1;
    box.high.array() += 0.1;
    return box;
}

double yawAt(const FighterAnalysis& fighter, double seconds) {
    const auto frame = static_cast<std::size_t>(frameAtTime(fighter.input, seconds));
    const auto& heading = fighter.body->heading;
    return (frame < heading.size() ? heading[frame] : 0.0) + fighter.input.placement.yaw;
}

}  // namespace

QRectF TileGrid::rect(int tile) const {
    return {(tile % columns) * size.width() + kGap / 2, (tile / columns) * size.height() + kGap / 2,
            size.width() - kGap, size.height() - kGap};
}

TileGrid tileGrid(int tiles, const QSizeF& area, double ratio) {
    TileGrid best;
    double most = -1;
    for (int columns = 1; columns <= std::max(1, tiles); ++columns) {
        const int rows = (tiles + columns - 1) / columns;
        const QSizeF size(area.width() / columns, area.height() / std::max(1, rows));
        const double used = std::min(size.width(), ratio * size.height());
        if (used <= most) continue;
        most = used;
        best = {columns, rows, size};
    }
    return best;
}

/// One renderer with its scene per tile, in one picture.
struct ActionTiles::Scene {
    struct View {
        vtkNew<vtkRenderer> renderer;
        Stage stage;
        CameraController camera;
        std::array<std::vector<Bone>, 2> bones;

        View() : stage(renderer) {}
    };

    explicit Scene(QWidget* parent) : canvas(new VtkWidget(parent)) {}

    VtkWidget* canvas;
    std::vector<std::unique_ptr<View>> views;  ///< kept for the next tiles
};

/// What is written and marked over the picture.
class ActionTiles::Captions : public QWidget {
public:
    explicit Captions(const ActionTiles& tiles) : tiles_(tiles) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const Colours& c = coloursFor(palette());
        const QFontMetricsF metrics(font());
        const double line = metrics.lineSpacing();
        for (int i = 0; i < tiles_.count(); ++i) {
            const ActionTile& tile = tiles_.tiles_[static_cast<std::size_t>(i)];
            const QRectF rect = tiles_.tileRect(i);
            const QRectF text = rect.adjusted(3, rect.height() - tiles_.captionHeight(), -3, 0);
            const bool chosen = tiles_.chosen_[static_cast<std::size_t>(i)];
            painter.fillRect(text.adjusted(-3, 0, 3, 0),
                             chosen ? mixed(c.panel, c.accent, 0.25) : c.panel);
            const auto write = [&](const QString& words, const QColor& colour, double top) {
                painter.setPen(colour);
                painter.drawText(QRectF(text.left(), text.top() + top, text.width(), line),
                                 Qt::AlignLeft | Qt::AlignVCenter,
                                 metrics.elidedText(words, Qt::ElideRight, text.width()));
            };
            write(tile.title, c.text, 1);
            write(tile.detail, c.secondText, line);
            const bool current = tiles_.hasFocus() && i == tiles_.current_;
            painter.setPen(QPen(chosen || current ? c.accent : c.line, chosen ? 2 : 1,
                                current && !chosen ? Qt::DashLine : Qt::SolidLine));
            painter.drawRect(rect.adjusted(0.5, 0.5, -0.5, -0.5));
        }
    }

private:
    const ActionTiles& tiles_;
};

ActionTiles::ActionTiles(QWidget* parent)
    : QWidget(parent), scene_(std::make_unique<Scene>(this)), captions_(new Captions(*this)) {
    captions_->setParent(this);
    scene_->canvas->setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Similar actions"));
    setAccessibleDescription(tr("Those that look most like the current action, side by side."));
    timer_.setInterval(kQuickest);
    connect(&timer_, &QTimer::timeout, this, &ActionTiles::advance);
}

ActionTiles::~ActionTiles() {
    // Before the scene: the widget's context must still be there when VTK lets go of it.
    delete scene_->canvas;
}

double ActionTiles::captionHeight() const {
    return 2 * QFontMetricsF(font()).lineSpacing() + 3;
}

QRectF ActionTiles::tileRect(int tile) const {
    return grid_.rect(tile);
}

void ActionTiles::show(std::vector<ActionTile> tiles) {
    const bool same = std::equal(tiles.begin(), tiles.end(), tiles_.begin(), tiles_.end(),
                                 [](const ActionTile& a, const ActionTile& b) {
                                     return a.player == b.player && a.begin == b.begin &&
                                            a.end == b.end && a.mirrored == b.mirrored;
                                 });
    tiles_ = std::move(tiles);
    chosen_.assign(tiles_.size(), false);
    current_ = std::clamp(current_, 0, std::max(0, count() - 1));
    while (scene_->views.size() < tiles_.size()) {
        scene_->views.push_back(std::make_unique<Scene::View>());
        scene_->canvas->add(scene_->views.back()->renderer);
    }
    for (std::size_t i = 0; i < scene_->views.size(); ++i) {
        Scene::View& view = *scene_->views[i];
        view.renderer->SetDraw(i < tiles_.size());
        for (std::size_t player = 0; player < 2; ++player) {
            view.bones[player].clear();
            if (i >= tiles_.size() || !tiles_[i].fighters[player]) continue;
            const Fighter& fighter = tiles_[i].fighters[player]->input;
            if (!fighter.motion) continue;
            view.bones[player] =
                bonesOf(*fighter.motion->skeleton, fighter.roles, fighter.space.metresPerUnit);
        }
    }
    if (!same) {
        clock_.restart();
        phase_ = 0;
    }
    arrange();
    Q_EMIT chosenChanged();
}

std::vector<int> ActionTiles::chosen() const {
    std::vector<int> tiles;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        if (chosen_[i]) tiles.push_back(static_cast<int>(i));
    }
    return tiles;
}

void ActionTiles::setChosen(const std::vector<int>& tiles) {
    chosen_.assign(tiles_.size(), false);
    for (const int tile : tiles) {
        if (tile > 0 && tile < count()) chosen_[static_cast<std::size_t>(tile)] = true;
    }
    captions_->update();
    Q_EMIT chosenChanged();
}

void ActionTiles::toggle(int tile) {
    if (tile <= 0 || tile >= count()) return;
    chosen_[static_cast<std::size_t>(tile)] = !chosen_[static_cast<std::size_t>(tile)];
    captions_->update();
    Q_EMIT chosenChanged();
}

void ActionTiles::setWithOpponent(bool shown) {
    withOpponent_ = shown;
    showPoses();
}

void ActionTiles::arrange() {
    scene_->canvas->setGeometry(rect());
    captions_->setGeometry(rect());
    grid_ = tileGrid(count(), QSizeF(size()), kRatio);
    const double width = std::max(1, this->width());
    const double height = std::max(1, this->height());
    for (int i = 0; i < count(); ++i) {
        const QRectF rect = tileRect(i);
        // VTK counts from the lower left corner.
        scene_->views[static_cast<std::size_t>(i)]->renderer->SetViewport(
            rect.left() / width, 1 - (rect.bottom() - captionHeight()) / height,
            rect.right() / width, 1 - rect.top() / height);
    }
    aimCameras();
    showPoses();
    captions_->update();
}

void ActionTiles::aimCameras() {
    const Colours& c = coloursFor(palette());
    scene_->canvas->renderer()->SetBackground(c.panel.redF(), c.panel.greenF(), c.panel.blueF());
    for (int i = 0; i < count(); ++i) {
        const ActionTile& tile = tiles_[static_cast<std::size_t>(i)];
        Scene::View& view = *scene_->views[static_cast<std::size_t>(i)];
        view.stage.setColours(c, tile.player);
        const auto& fighter = tile.fighters[static_cast<std::size_t>(tile.player)];
        if (!fighter || fighter->frameCount() == 0) continue;
        const Box box = boxOf(*fighter, tile.begin, tile.end);
        const QRectF rect = tileRect(i);
        view.camera.lookFrom(yawAt(*fighter, tile.begin) + (tile.mirrored ? -kAside : kAside),
                             kPitch);
        view.camera.frame(box, {rect.width(), std::max(1.0, rect.height() - captionHeight())});
        view.stage.floor().cover(box);
        view.stage.setCamera(view.camera);
    }
}

void ActionTiles::showPoses() {
    Overlays plain;
    plain.centreOfMass = plain.force = plain.trails = plain.contacts = false;
    for (int i = 0; i < count(); ++i) {
        const ActionTile& tile = tiles_[static_cast<std::size_t>(i)];
        Scene::View& view = *scene_->views[static_cast<std::size_t>(i)];
        const double time = tile.begin + phase_ * (tile.end - tile.begin);
        for (int player = 0; player < 2; ++player) {
            const auto& fighter = tile.fighters[static_cast<std::size_t>(player)];
            const bool shown =
                fighter && fighter->frameCount() > 0 && (withOpponent_ || player == tile.player);
            FigurePose pose;
            if (shown) pose.joints = jointsAt(*fighter, frameAtTime(fighter->input, time));
            view.stage.figure(player).show(view.bones[static_cast<std::size_t>(player)], pose,
                                           plain);
        }
    }
    scene_->canvas->markDirty();
}

void ActionTiles::advance() {
    if (tiles_.empty()) return;
    const double length = std::max(0.2, tiles_.front().end - tiles_.front().begin);
    const double now = std::fmod(clock_.elapsed() / 1000.0, length + kHold);
    // With less motion they stand still but under the pointer.
    phase_ = isMotionReduced() && !underMouse() ? 0.5 : std::min(1.0, now / length);
    QElapsedTimer cost;
    cost.start();
    showPoses();
    scene_->canvas->repaint();
    // At most a third of the time goes into drawing.
    timer_.setInterval(std::clamp(static_cast<int>(3 * cost.elapsed()), kQuickest, kSlowest));
}

QImage ActionTiles::picture() {
    QImage image = scene_->canvas->picture();
    QPainter painter(&image);
    captions_->render(&painter, {}, {}, QWidget::DrawChildren);
    painter.end();
    return image;
}

void ActionTiles::resizeEvent(QResizeEvent*) {
    arrange();
}

void ActionTiles::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) arrange();
    QWidget::changeEvent(event);
}

void ActionTiles::showEvent(QShowEvent*) {
    clock_.start();
    timer_.start();
}

void ActionTiles::hideEvent(QHideEvent*) {
    timer_.stop();
}

int ActionTiles::tileAt(const QPointF& point) const {
    for (int i = 0; i < count(); ++i) {
        if (tileRect(i).contains(point)) return i;
    }
    return -1;
}

void ActionTiles::mousePressEvent(QMouseEvent* event) {
    const int tile = tileAt(event->position());
    if (tile < 0 || event->button() != Qt::LeftButton) return;
    current_ = tile;
    toggle(tile);
}

void ActionTiles::mouseDoubleClickEvent(QMouseEvent* event) {
    const int tile = tileAt(event->position());
    if (tile < 0) return;
    toggle(tile);  // takes back what the first press did
    Q_EMIT opened(tile);
}

bool ActionTiles::event(QEvent* event) {
    // These keys belong to the tiles while they have the focus, not to the playhead.
    if (claimsGridKey(event, {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter})) return true;
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) captions_->update();
    return QWidget::event(event);
}

void ActionTiles::keyPressEvent(QKeyEvent* event) {
    if (const auto step = gridStep(*event)) {
        const int way = step->rows * grid_.columns + step->columns;
        if (count() > 0) current_ = std::clamp(current_ + way, 0, count() - 1);
        captions_->update();
        return;
    }
    switch (event->key()) {
        case Qt::Key_Space:
            return toggle(current_);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (count() > 0) Q_EMIT opened(current_);
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace kumite::studio
