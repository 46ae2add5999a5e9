#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/project/analysis.h"

namespace kumite::studio {

/// An action in a small 3D view.
struct ActionTile {
    /// Fighters of its take as they were when the tile was made; values are shared.
    std::array<std::optional<FighterAnalysis>, 2> fighters;
    int player = 0;    ///< whose action it is
    double begin = 0;  ///< seconds on the take's clock
    double end = 0;
    bool mirrored = false;  ///< seen from the other side, so that it looks like its mirror image
    QString title;          ///< one line below the picture
    QString detail;         ///< a second line, fainter
};

/// Where tiles lie: as near to `ratio` (width over height) as the area allows, all of one size.
struct TileGrid {
    int columns = 1;
    int rows = 1;
    QSizeF size;

    QRectF rect(int tile) const;
};
TileGrid tileGrid(int tiles, const QSizeF& area, double ratio);

/// Actions side by side as small 3D views that loop in step: all begin and end together, as long as
/// the first one lasts. They are seen from the same side of their fighter. A click chooses a tile
/// or no longer, a double click opens it; so do the arrow keys, Space and Enter. Nothing is drawn
/// while the widget is hidden, and without a graphics card as often as time allows.
class ActionTiles : public QWidget {
    Q_OBJECT

public:
    explicit ActionTiles(QWidget* parent = nullptr);
    ~ActionTiles() override;

    /// Nothing is chosen then.
    void show(std::vector<ActionTile> tiles);
    int count() const { return static_cast<int>(tiles_.size()); }
    QRectF tileRect(int tile) const;
    /// Tiles that a hand chose; never the first one, which the others are like.
    std::vector<int> chosen() const;
    void setChosen(const std::vector<int>& tiles);
    /// Whether the opponents are shown, too.
    void setWithOpponent(bool shown);
    bool isPlaying() const { return timer_.isActive(); }
    /// How far the loop is, 0 … 1.
    double phase() const { return phase_; }
    QImage picture();

    QSize minimumSizeHint() const override { return {200, 180}; }

Q_SIGNALS:
    void chosenChanged();
    void opened(int tile);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    struct Scene;
    class Captions;

    void advance();
    void showPoses();
    void arrange();
    void aimCameras();
    void toggle(int tile);
    int tileAt(const QPointF& point) const;
    double captionHeight() const;

    std::vector<ActionTile> tiles_;
    std::vector<bool> chosen_;
    int current_ = 0;
    bool withOpponent_ = true;
    double phase_ = 0;
    TileGrid grid_;
    std::unique_ptr<Scene> scene_;
    Captions* captions_;
    QTimer timer_;
    QElapsedTimer clock_;
};

}  // namespace kumite::studio
