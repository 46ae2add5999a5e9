#pragma once

#include <QMainWindow>
#include <QStringList>

#include <QPointer>

#include "studio/app/findings_page.h"
#include "studio/app/preferences.h"
#include "studio/app/preferences_dialog.h"
#include "studio/app/session.h"
#include "studio/app/window_state.h"

class QKeyEvent;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace kumite::studio {

class BoutSession;
class Help;
class HitSession;
class KeySession;
class SequenceSession;
class CommandPalette;
class CommandTable;
class DocumentPanel;
class FileActions;
class GraphCentre;
class GraphSession;
class LabelExchange;
class LabelLanes;
class LabelPanel;
class LabelReview;
class LabelSession;
class LabelViews;
class MessageStrip;
class SegmentPanel;
class StageView;
class StatusLine;
class SystemTheme;
class TimelineView;
class TransportBar;
class WelcomePage;
class WorkspaceBar;
class Workspaces;

/// The studio's window: 3D view over the timeline, takes and fighters left of the view, right of
/// both the workspace's panel, below a line that says what is under the pointer. main_window.cpp
/// puts the parts together; what the commands do stands in main_window_*.cpp.
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
    CommandPalette& commandPalette() { return *palette_; }
    Preferences& preferences() { return preferences_; }
    Workspaces& workspaces() { return *workspaces_; }
    DocumentPanel& documentPanel() { return *documentPanel_; }
    FindingsLog& findings() { return findings_; }
    BoutSession& bout() { return *bout_; }
    SequenceSession& sequence() { return *sequence_; }
    KeySession& keys() { return *keys_; }
    HitSession& hit() { return *hit_; }
    GraphSession& graph() { return *graph_; }
    GraphCentre& graphCentre() { return *graphCentre_; }
    LabelSession& labels() { return *labels_; }
    LabelReview& labelReview() { return *labelReview_; }
    StageView& stage() { return *stage_; }
    TimelineView& timeline() { return *timeline_; }
    Help& help() { return *help_; }

    /// Whether something is being read or computed.
    bool isBusy() const;
    /// All that another window needs to go on in its place; edits that wait are made before.
    WindowState handOver();
    void takeOver(WindowState state);
    bool isShowingPreferences() const { return !preferencesDialog_.isNull(); }
    /// Shows the page of keys; it stays open beside the window.
    void showKeys();
    void showPreferences(PreferencesDialog::Page page);
    void showFighterProperties();
    void showFindings();
    void setTheme(ThemeChoice choice);
    /// The panels at both sides; the 3D view takes their place.
    bool panelsShown() const { return panelsShown_; }
    void setPanelsShown(bool shown);

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addFileCommands();
    void addEditCommands();
    void addTakeCommands();
    void addWorkspaces();
    /// Of the menu Segment.
    void addBoundaryCommand(const char* id, const QString& text, const QList<QKeySequence>& keys,
                            std::function<void()> run, bool newGroup = false,
                            const QList<QWidget*>& scopes = {});
    void addBoundaryCommands();
    void addSegmentCommands(SegmentPanel& panel);
    void addLabelViewCommands(LabelViews& views);
    void addLabelCommands(LabelPanel& panel);
    void showLabelKeys();
    void addGraphWorkspace();
    void addBoutWorkspace();
    void addSequenceWorkspace();
    void addKeyframeWorkspace();
    void addPlaybackCommands();
    void addTimelineCommands();
    void addViewCommands();
    void addContextMenus();
    void layOut();
    void layOutTopBar();
    void listen();
    void shareSpace();
    void fitTopBar();
    void restoreLayout();
    void saveLayout() const;
    void applyPreferences();
    void applyPlaybackPreferences();
    void followSystemTheme();
    void refreshTitle();
    void refreshIcons();
    void showKeysHint();
    QStringList keysHint() const;
    void takeOverLabels();
    void focusMoved(QWidget* from, QWidget* to);
    /// What findings in the clips of sequences stand under.
    static QString clipsTitle();
    bool isInControl() const;
    void leaveControl();
    /// Whether a key belongs to commands of the views, and the focus is elsewhere: the top bar, of
    /// which Qt thinks that what its menus hold works everywhere in it.
    bool isOfTheViews(const QWidget& focused, const QKeyEvent& key) const;
    bool goesToCommands(const QWidget& field, const QKeyEvent& key) const;
    void showFindingsCount();
    void changeSpeed(int direction);
    void stepTake(int direction);
    void removeShownTake();
    void fillRecentMenu();
    bool hasTake() const { return session_.playerCount() > 0; }

    /// As splitters tell it.
    struct PanelWidths {
        QByteArray left, right;
    };
    PanelWidths panelWidths() const;
    bool setPanelWidths(const PanelWidths& widths);

    Session session_;
    Preferences preferences_;
    FindingsLog findings_;
    SystemTheme* systemTheme_;
    CommandTable* commands_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    WelcomePage* welcome_ = nullptr;
    QSplitter* columns_ = nullptr;  ///< all the rest, and the workspace's panel as high as that
    QSplitter* rows_ = nullptr;     ///< what is above the timeline, and the timeline
    QSplitter* upper_ = nullptr;    ///< takes and fighters, and the content
    QSplitter* content_ = nullptr;  ///< the 3D view and what a workspace shows beside it
    DocumentPanel* documentPanel_ = nullptr;
    QStackedWidget* rightPanel_ = nullptr;
    QStackedWidget* centres_ = nullptr;
    Workspaces* workspaces_ = nullptr;
    WorkspaceBar* tabs_ = nullptr;
    LabelSession* labels_ = nullptr;
    LabelExchange* exchange_ = nullptr;
    LabelReview* labelReview_ = nullptr;
    LabelLanes* labelLanes_ = nullptr;
    BoutSession* bout_ = nullptr;
    SequenceSession* sequence_ = nullptr;
    KeySession* keys_ = nullptr;
    HitSession* hit_ = nullptr;
    GraphSession* graph_ = nullptr;
    GraphCentre* graphCentre_ = nullptr;
    Help* help_ = nullptr;
    CommandPalette* palette_ = nullptr;
    StageView* stage_ = nullptr;
    QWidget* timelineBox_ = nullptr;
    TimelineView* timeline_ = nullptr;
    MessageStrip* strip_ = nullptr;
    FileActions* files_ = nullptr;
    StatusLine* status_ = nullptr;
    QToolButton* findingsButton_ = nullptr;
    QPointer<QDialog> keysPage_;
    QPointer<PreferencesDialog> preferencesDialog_;
    QPointer<QDialog> fighterProperties_;
    QPointer<QDialog> findingsPage_;
    ThemeChoice shownTheme_;
    double shownTextSize_ = 100;  ///< percent
    bool panelsShown_ = true;
    PanelWidths widths_;        ///< how wide the panels are while they are hidden
    bool spaceShared_ = false;  ///< the user has laid out the window
};

}  // namespace kumite::studio
