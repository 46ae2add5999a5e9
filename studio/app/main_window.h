#pragma once

#include <QMainWindow>
#include <QStringList>

#include "studio/app/session.h"
#include "studio/app/theme.h"

class QLabel;
class QSplitter;
class QStackedWidget;

namespace kumite::studio {

class CommandTable;
class DocumentPanel;
class FileActions;
class MessageStrip;
class SegmentPanel;
class StageView;
class TimelineView;
class TransportBar;
class WelcomePage;

/// The studio's window: 3D view over the timeline, panels on both sides, a line that says what is
/// under the pointer.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// What Qt must know of OpenGL before the application object exists.
    static void prepareGraphics();

    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    Session& session() { return session_; }
    CommandTable& commands() { return *commands_; }
    FileActions& files() { return *files_; }
    MessageStrip& messages() { return *strip_; }
    StageView& stage() { return *stage_; }
    TimelineView& timeline() { return *timeline_; }

    /// Whether something is being read or computed.
    bool isBusy() const;
    /// Shows the page of keys; it stays open beside the window.
    void showKeys();
    void setTheme(ThemeChoice choice);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addFileCommands();
    void addEditCommands();
    void addBoundaryCommands();
    void addPlaybackCommands();
    void addTimelineCommands();
    void addViewCommands();
    void layOut();
    void listen();
    void shareSpace();
    void refreshTitle();
    void refreshIcons();
    void showStatus(const QString& text);
    void changeSpeed(int direction);
    void togglePanels();
    void fillRecentMenu();

    Session session_;
    CommandTable* commands_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    WelcomePage* welcome_ = nullptr;
    QSplitter* rows_ = nullptr;
    QSplitter* columns_ = nullptr;
    DocumentPanel* documentPanel_ = nullptr;
    SegmentPanel* segmentPanel_ = nullptr;
    StageView* stage_ = nullptr;
    QWidget* timelineBox_ = nullptr;
    TimelineView* timeline_ = nullptr;
    MessageStrip* strip_ = nullptr;
    FileActions* files_ = nullptr;
    QLabel* status_ = nullptr;
    ThemeChoice theme_ = ThemeChoice::System;
    bool spaceShared_ = false;  ///< the user has laid out the window
};

}  // namespace kumite::studio
