// The workspaces: what each brings, and how the window follows it.

#include <QListView>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

#include "studio/app/commands.h"
#include "studio/app/main_window.h"
#include "studio/app/message_strip.h"
#include "studio/app/workspaces.h"
#include "studio/jobs/job_bar.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_bar.h"
#include "studio/workspaces/bout/bout_commands.h"
#include "studio/workspaces/bout/bout_page.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/bout/bout_stage.h"
#include "studio/workspaces/bout/bout_strip.h"
#include "studio/workspaces/graph/graph_centre.h"
#include "studio/workspaces/graph/graph_commands.h"
#include "studio/workspaces/graph/graph_panel.h"
#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/graph/surprise_strip.h"
#include "studio/workspaces/graph/trace_box.h"
#include "studio/workspaces/graph/what_if_box.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_bar.h"
#include "studio/workspaces/keyframe/key_commands.h"
#include "studio/workspaces/keyframe/key_panel.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/key_stage.h"
#include "studio/workspaces/keyframe/key_strip.h"
#include "studio/workspaces/label/label_exchange.h"
#include "studio/workspaces/label/label_lanes.h"
#include "studio/workspaces/label/label_review.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_views.h"
#include "studio/workspaces/segment/segment_panel.h"
#include "studio/workspaces/sequence/cluster_map.h"
#include "studio/workspaces/sequence/sequence_bar.h"
#include "studio/workspaces/sequence/sequence_commands.h"
#include "studio/workspaces/sequence/sequence_panel.h"
#include "studio/workspaces/sequence/sequence_session.h"
#include "studio/workspaces/sequence/sequence_stage.h"
#include "studio/workspaces/sequence/sequence_strip.h"

namespace kumite::studio {

void MainWindow::addWorkspaces() {
    auto* segment = new SegmentPanel(session_, rightPanel_);
    workspaces_->add({"segment", tr("Segment"), "segment",
                      tr("Correct the boundaries that cut the bout into actions."), segment,
                      [this, segment] { addSegmentCommands(*segment); }});
    commands_->addFor(QStringLiteral("segment label"), [this] { addBoundaryCommands(); });
    labels_ = new LabelSession(session_, this);
    labelReview_ = new LabelReview(*labels_, this);
    labelLanes_ = new LabelLanes(*labels_, *labelReview_, this);
    exchange_ = new LabelExchange(session_, *strip_, this);
    auto* label = new LabelViews(*labelReview_, *commands_, rightPanel_);
    workspaces_->add({"label", tr("Label"), "label",
                      tr("Say what a few actions are; the machine says it of the rest."), label,
                      [this, label] {
                          addLabelCommands(label->label());
                          addLabelViewCommands(*label);
                      }});
    connect(workspaces_, &Workspaces::changed, this, [this] {
        const bool shown = workspaces_->current() == QLatin1String("label");
        // Once it has been shown it goes on learning.
        if (shown) labels_->setActive(true);
        timeline_->setLanes(shown ? labelLanes_ : nullptr);
        if (!spaceShared_) shareSpace();
    });
    addGraphWorkspace();
    addBoutWorkspace();
    addSequenceWorkspace();
    addKeyframeWorkspace();
    workspaces_->addSwitchCommands(tr("&View"));
}

void MainWindow::addGraphWorkspace() {
    graph_ = new GraphSession(session_, this);
    findChild<JobBar*>()->watch(graph_->jobs());
    connect(&graph_->jobs(), &JobRunner::failed, strip_, &MessageStrip::showError);
    auto* panel = new GraphPanel(*graph_, rightPanel_);
    graphCentre_ = new GraphCentre(*graph_, centres_);
    auto* strip = new SurpriseStrip(*graph_, *timeline_, timelineBox_);
    static_cast<QVBoxLayout*>(timelineBox_->layout())->insertWidget(0, strip);
    workspaces_->add({"graph", tr("Graph"), "graph",
                      tr("What each fighter tends to do next, and the moments behind it."), panel,
                      [this, panel] {
                          const QList<QWidget*> views = {stage_, timelineBox_, graphCentre_,
                                                         panel->trace().table(),
                                                         panel->whatIf().list()};
                          addGraphCommands(*commands_, *graph_, *graphCentre_, views);
                      },
                      graphCentre_});
    graphCentre_->addStep(tr("Label actions"), tr("Go to the Label workspace"),
                          [this] { workspaces_->show(QStringLiteral("label")); });
    graphCentre_->addStep(tr("Take over labels"),
                          tr("From a table of labels; of a made bout at once its truth"),
                          [this] { takeOverLabels(); });
    const auto follow = [this, strip] {
        graph_->setActive(workspaces_->current() == QLatin1String("graph"));
        strip->setVisible(graph_->isActive() && graph_->hasGraph());
    };
    connect(workspaces_, &Workspaces::changed, graph_, follow);
    follow();
}

/// The page with the button goes; keys are the 3D view's then.
void MainWindow::takeOverLabels() {
    stage_->setFocus();
    exchange_->takeOver();
}

void MainWindow::addBoutWorkspace() {
    bout_ = new BoutSession(session_, this);
    auto* jobs = findChild<JobBar*>();
    for (JobRunner* runner : {&bout_->jobs(), &bout_->judging(), &bout_->writing()})
        jobs->watch(*runner);
    connect(bout_, &BoutSession::failed, strip_, &MessageStrip::showError);
    auto* page = new BoutPage(*bout_, rightPanel_);
    workspaces_->add({"bout", tr("Bout"), "bout",
                      tr("Let both fight on from what was learnt, or fight yourself."), page,
                      [this, page] {
                          addBoutCommands(*commands_, *bout_, *stage_);
                          page->addCommands(*commands_);
                      }});
    page->addStep(tr("Label actions"), tr("Go to the Label workspace"),
                  [this] { workspaces_->show(QStringLiteral("label")); });
    page->addStep(tr("Take over labels"),
                  tr("From a table of labels; of a made bout at once its truth"),
                  [this] { takeOverLabels(); });
    auto* below = new QWidget(rows_);  // in the timeline's place
    auto* box = new QVBoxLayout(below);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(0);
    box->addWidget(new BoutBar(*bout_, *commands_, below));
    box->addWidget(new BoutStrip(*bout_, below), 1);
    new BoutStage(*bout_, *stage_, this);
    const auto follow = [this, below] {
        const bool shown = workspaces_->current() == QLatin1String("bout");
        below->setVisible(shown);
        timelineBox_->setVisible(!shown);
        bout_->setActive(shown);
        // What had the focus may be hidden now; the next key would press some button.
        if (shown) stage_->setFocus();
    };
    connect(bout_, &BoutSession::stateChanged, this, [this, playing = false]() mutable {
        // Every edit changes a bout's state; drawing all icons anew is for when it plays or stops.
        if (playing != bout_->isPlaying()) {
            playing = bout_->isPlaying();
            refreshIcons();
        }
        if (bout_->isActive()) showKeysHint();
    });
    connect(workspaces_, &Workspaces::changed, bout_, follow);
    follow();
}

QString MainWindow::clipsTitle() {
    return tr("Clips of sequences");
}

void MainWindow::addSequenceWorkspace() {
    sequence_ = new SequenceSession(session_, this);
    auto* jobs = findChild<JobBar*>();
    for (JobRunner* runner : {&sequence_->jobs(), &sequence_->making(), &sequence_->writing()})
        jobs->watch(*runner);
    connect(sequence_, &SequenceSession::failed, strip_, &MessageStrip::showError);
    connect(sequence_, &SequenceSession::libraryChanged, this,
            [this] { findings_.add(clipsTitle(), sequence_->findings()); });
    auto* panel = new SequencePanel(*sequence_, rightPanel_);
    auto* below = new QWidget(rows_);  // in the timeline's place
    auto* strip = new SequenceStrip(*sequence_, below);
    auto* map = new ClusterMap(*sequence_, centres_);
    workspaces_->add({"sequence", tr("Sequence"), "sequence",
                      tr("Play actions in any order, led over to each other."), panel,
                      [this, panel, strip] {
                          addSequenceCommands(*commands_, *sequence_, *panel, *strip, *stage_);
                          panel->addCommands(*commands_);
                      },
                      map});
    panel->addStep(tr("Add clips…"), tr("Of motion files or other projects"),
                   [this] { commands_->run(QStringLiteral("sequence.clips")); });
    auto* box = new QVBoxLayout(below);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(0);
    box->addWidget(new SequenceBar(*sequence_, *commands_, below));
    box->addWidget(strip, 1);
    new SequenceStage(*sequence_, *stage_, this);
    const auto follow = [this, below] {
        const bool shown = workspaces_->current() == QLatin1String("sequence");
        below->setVisible(shown);
        if (shown) {
            timelineBox_->setVisible(false);
            centres_->setVisible(sequence_->showsMap());
        }
        sequence_->setActive(shown);
        if (shown) stage_->setFocus();
    };
    connect(sequence_, &SequenceSession::stateChanged, this, [this, playing = false]() mutable {
        if (playing != sequence_->isPlaying()) {
            playing = sequence_->isPlaying();
            refreshIcons();
        }
        if (sequence_->isActive()) showKeysHint();
    });
    connect(sequence_, &SequenceSession::mapToggled, this,
            [this] { centres_->setVisible(sequence_->showsMap()); });
    connect(workspaces_, &Workspaces::changed, sequence_, follow);
    follow();
}

void MainWindow::addKeyframeWorkspace() {
    keys_ = new KeySession(session_, this);
    auto* jobs = findChild<JobBar*>();
    for (JobRunner* runner : {&keys_->jobs(), &keys_->making(), &keys_->writing()})
        jobs->watch(*runner);
    connect(keys_, &KeySession::failed, strip_, &MessageStrip::showError);
    hit_ = new HitSession(*keys_, this);
    jobs->watch(hit_->jobs());
    connect(hit_, &HitSession::failed, strip_, &MessageStrip::showError);
    auto* panel = new KeyPanel(*keys_, *hit_, rightPanel_);
    workspaces_->add({"keyframe", tr("Keyframe"), "keyframe",
                      tr("A few key poses become a motion made of the recorded ones."), panel,
                      [this, panel] {
                          addKeyCommands(*commands_, *keys_, *hit_, *stage_);
                          panel->addCommands(*commands_);
                      }});
    panel->addStep(tr("Add clips…"), tr("Of motion files or other projects"),
                   [this] { commands_->run(QStringLiteral("keys.clips")); });
    auto* below = new QWidget(rows_);  // in the timeline's place
    auto* box = new QVBoxLayout(below);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(0);
    box->addWidget(new KeyBar(*keys_, *hit_, *commands_, below));
    box->addWidget(new KeyStrip(*keys_, *hit_, below), 1);
    new KeyStage(*keys_, *hit_, *stage_, this);
    const auto follow = [this, below] {
        const bool shown = workspaces_->current() == QLatin1String("keyframe");
        below->setVisible(shown);
        if (shown) timelineBox_->setVisible(false);
        keys_->setActive(shown);
        if (shown) stage_->setFocus();
    };
    const auto state = [this, playing = std::make_shared<bool>(false)] {
        const bool now = keys_->isPlaying() || hit_->isPlaying();
        if (*playing != now) {
            *playing = now;
            refreshIcons();
        }
        if (keys_->isActive()) showKeysHint();
    };
    connect(keys_, &KeySession::stateChanged, this, state);
    connect(hit_, &HitSession::changed, this, state);
    connect(keys_, &KeySession::chosen, this, [this] {
        if (keys_->isActive()) showKeysHint();
    });
    connect(workspaces_, &Workspaces::changed, keys_, follow);
    follow();
}

}  // namespace kumite::studio
