// What hands do in the Label workspace: answers, lanes, classes, quick labels, choice.

#include "studio/app/commands.h"
#include "studio/app/key_bindings.h"
#include "studio/app/main_window.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/label/label_panel.h"
#include "studio/workspaces/label/label_review.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

namespace {

/// Quick labels that have commands; a vocabulary may hold more, without keys.
constexpr int kQuickLabels = 30;

QString quickId(int index) {
    return QStringLiteral("label.quick%1").arg(index + 1);
}

}  // namespace

void MainWindow::addLabelCommands(LabelPanel& panel) {
    const QString menu = tr("&Label");
    LabelReview* review = labelReview_;
    const auto has = [this] { return hasTake(); };
    const auto add = [&](const QString& id, const QString& text, const QList<QKeySequence>& keys,
                         std::function<void()> run, bool newGroup = false,
                         const QList<QWidget*>& scopes = {}, std::function<bool()> checked = {}) {
        Command command{id,
                        newGroup ? QLatin1Char('-') + menu : menu,
                        text,
                        keys,
                        std::move(run),
                        has,
                        std::move(checked)};
        command.scopes = scopes;
        // An answer is for one question; held down, a key would answer the next ones unseen.
        command.repeats = false;
        command.leadsOn = true;
        commands_->add(std::move(command));
    };
    // Return and Backspace are keys of fields and buttons, too.
    const QList<QWidget*> views = {stage_, timelineBox_};
    add("label.next", tr("&Next question"), {QKeySequence("N")}, [review] { review->next(); });
    add("label.previous", tr("&Previous question"), {QKeySequence("Shift+N")},
        [review] { review->previous(); });
    add(
        "label.accept", tr("&Accept what is proposed"),
        {QKeySequence("Return"), QKeySequence("Enter")}, [review] { review->accept(); }, false,
        views);
    add(
        "label.reject", tr("&Reject: the second best instead"), {QKeySequence("Backspace")},
        [review] { review->reject(); }, false, views);
    add("label.clear", tr("&Take back what is said of the action"), {QKeySequence("Shift+Del")},
        [review] { review->clear(); });
    add("label.acceptSure", tr("Accept the &sure rest"), {QKeySequence("Ctrl+Return")},
        [&panel] { panel.acceptSure(); });
    const auto bar = [&](const char* id, const QString& text, const char* key, double by) {
        commands_->add({id,
                        menu,
                        text,
                        {QKeySequence(QLatin1String(key))},
                        [&panel, by] { panel.moveBar(by); },
                        has});
    };
    bar("label.barDown", tr("Less sure is sure eno&ugh"), "Ctrl+Down", -0.05);
    bar("label.barUp", tr("On&ly surer is sure enough"), "Ctrl+Up", 0.05);
    add(
        "label.advance", tr("Answers &go on to the next question"), {QKeySequence("Y")},
        [review] { review->setAdvancing(!review->isAdvancing()); }, false, {},
        [review] { return review->isAdvancing(); });

    const auto lane = [&](const char* id, const QString& text, const char* key, int direction,
                          bool newGroup) {
        Command command{id,
                        newGroup ? QLatin1Char('-') + menu : menu,
                        text,
                        {QKeySequence(QLatin1String(key))},
                        [review, direction] { review->stepLane(direction); },
                        has};
        command.leadsOn = true;
        commands_->add(std::move(command));
    };
    lane("label.laneUp", tr("Lane abo&ve"), "Up", -1, true);
    lane("label.laneDown", tr("Lane belo&w"), "Down", 1, false);
    for (int digit = 1; digit <= 10; ++digit) {
        const int key = digit % 10;
        add(QStringLiteral("label.class%1").arg(key),
            key == 0 ? tr("Nothing of the lane's aspect") : tr("Class %1 of the lane").arg(key),
            {QKeySequence(QString::number(key))}, [review, key] { review->nameClass(key); });
    }
    add(
        "label.composite", tr("Next class &besides: a composite"), {QKeySequence("V")},
        [review] { review->announceBesides(); }, false, {},
        [review] { return review->isComposite(); });

    const QList<QKeySequence> extendBack = {QKeySequence("Shift+Up"), QKeySequence("Shift+PgUp")};
    const QList<QKeySequence> extendOn = {QKeySequence("Shift+Down"), QKeySequence("Shift+PgDown")};
    commands_->add({"label.extendBack", QLatin1Char('-') + menu,
                    tr("Choose the action before as well"), extendBack,
                    [review] { review->extend(-1); }, has});
    commands_->add({"label.extendOn", menu, tr("Choose the action after as well"), extendOn,
                    [review] { review->extend(1); }, has});

    const std::vector<QuickLabel> quick = quickLabels(labels_->vocabulary());
    for (int i = 0; i < kQuickLabels; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const bool there = index < quick.size();
        Command command{quickId(i), i == 0 ? QLatin1Char('-') + menu : menu,
                        tr("Quick label %1").arg(i + 1),
                        there && !quick[index].key.empty()
                            ? QList{QKeySequence(QString::fromStdString(quick[index].key))}
                            : QList<QKeySequence>(),
                        [review, i] { review->quick(i); }};
        command.shown = [this, index] { return index < quickLabels(labels_->vocabulary()).size(); };
        command.enabled = [this, shown = command.shown] { return hasTake() && shown(); };
        command.repeats = false;
        command.leadsOn = true;
        commands_->add(std::move(command));
    }
    showLabelKeys();
    connect(&session_.document(), &Document::changed, this, &MainWindow::showLabelKeys);
    connect(labels_, &LabelSession::changed, commands_, &CommandTable::refresh);
    connect(review, &LabelReview::switched, commands_, &CommandTable::refresh);
    connect(review, &LabelReview::shown, this, [this] {
        const Transport& transport = session_.transport();
        stage_->frameFighters(transport.loopIn().value_or(transport.span().begin),
                              transport.loopOut().value_or(transport.span().end));
    });
}

/// Names and keys of the quick labels, of the vocabulary in force.
void MainWindow::showLabelKeys() {
    const Vocabulary& vocabulary = labels_->vocabulary();
    const std::vector<QuickLabel> quick = quickLabels(vocabulary);
    for (int i = 0; i < kQuickLabels; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const bool there = index < quick.size();
        commands_->setText(quickId(i),
                           there ? tr("Label: %1").arg(labelWords(vocabulary, quick[index].label))
                                 : tr("Quick label %1").arg(i + 1));
        const std::string key = there ? quick[index].key : std::string();
        commands_->setDefaultKeys(
            quickId(i),
            key.empty() ? QList<QKeySequence>() : QList{QKeySequence(QString::fromStdString(key))});
    }
}

}  // namespace kumite::studio
