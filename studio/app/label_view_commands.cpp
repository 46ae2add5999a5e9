// Commands of the Label workspace that look at labels: pages, search, similar actions, comparison
// with another person, files.

#include "studio/app/commands.h"
#include "studio/app/main_window.h"
#include "studio/app/workspaces.h"
#include "studio/workspaces/label/compare_labels_box.h"
#include "studio/workspaces/label/find_box.h"
#include "studio/workspaces/label/found_list.h"
#include "studio/workspaces/label/label_exchange.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_views.h"
#include "studio/workspaces/label/similar_box.h"

namespace kumite::studio {

void MainWindow::addLabelViewCommands(LabelViews& views) {
    const auto has = [this] { return hasTake(); };
    const QString menu = tr("&Label");
    const auto add = [&](const char* id, const QString& text, const QList<QKeySequence>& keys,
                         std::function<void()> run, bool newGroup = false,
                         std::function<bool()> enabled = {}, const QList<QWidget*>& scopes = {}) {
        commands_->add({id,
                        newGroup ? QLatin1Char('-') + menu : menu,
                        text,
                        keys,
                        std::move(run),
                        enabled ? std::move(enabled) : has,
                        {},
                        {},
                        scopes});
    };
    const auto page = [&](const char* id, const QString& text, const QKeySequence& key,
                          LabelViews::Page which, bool newGroup = false) {
        Command command{id,    newGroup ? QLatin1Char('-') + menu : menu, text,
                        {key}, [&views, which] { views.setPage(which); }, has};
        command.leadsOn = which == LabelViews::LabelPage;
        commands_->add(std::move(command));
    };
    page("label.page.label", tr("Show pal&ette and questions"), QKeySequence("F4"),
         LabelViews::LabelPage, true);
    add("label.find", tr("&Find actions"), {QKeySequence::Find}, [&views] {
        views.setPage(LabelViews::FindPage);
        views.find().focusField();
    });
    page("label.page.similar", tr("Show si&milar actions"), QKeySequence("F6"),
         LabelViews::SimilarPage);
    page("label.page.quality", tr("Show &quality"), QKeySequence("F7"), LabelViews::QualityPage);
    page("label.page.rules", tr("Show &rules"), QKeySequence("F8"), LabelViews::RulesPage);
    page("label.page.compare", tr("Show &two people's labels"), QKeySequence("F9"),
         LabelViews::ComparePage);
    const auto finding = [&views] { return views.find().list().model().rowCount() > 0; };
    add(
        "label.find.next", tr("Ne&xt action found"), {QKeySequence("F3")},
        [&views] { views.find().list().step(1); }, true, finding);
    add(
        "label.find.previous", tr("Pre&vious action found"), {QKeySequence("Shift+F3")},
        [&views] { views.find().list().step(-1); }, false, finding);
    add(
        "label.find.all", tr("Choose &all that were found"), {QKeySequence("Ctrl+Shift+F")},
        [&views] { views.find().list().chooseAll(); }, false, finding);
    add(
        "label.similar.give", tr("&Give similar actions the same label"),
        {QKeySequence("Ctrl+Shift+Return"), QKeySequence("Ctrl+Shift+Enter")},
        [&views] { views.similar().giveLabel(); }, false,
        [&views] {
            return views.page() == LabelViews::SimilarPage && views.similar().actions().size() > 1;
        });
    const auto comparing = [&views] { return views.comparison().isComparing(); };
    const QList<QWidget*> list = {views.comparison().list()};
    add(
        "label.compare.theirs", tr("Take t&heirs"),
        {QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)},
        [&views] { views.comparison().takeTheirs(); }, true, comparing, list);
    add(
        "label.compare.mine", tr("&Keep mine"), {QKeySequence(Qt::Key_Backspace)},
        [&views] { views.comparison().keepMine(); }, false, comparing, list);
    add(
        "label.compare.all", tr("Take theirs for all that are &open"), {},
        [&views] { views.comparison().takeAllTheirs(); }, false, comparing);
    add(
        "label.compare.add", tr("Add what onl&y they labelled"), {},
        [&views] { views.comparison().addOnlyTheirs(); }, false,
        [&views] {
            const auto& agreement = views.comparison().agreement();
            return agreement && !agreement->additions.empty();
        });
    add(
        "label.compare.next", tr("Next &difference"), {QKeySequence("F10")},
        [&views] { views.comparison().step(1); }, false, comparing);
    add(
        "labels.import", tr("Take &over labels…"), {}, [this] { exchange_->askForImport(); }, true);
    add("labels.export", tr("&Write labels…"), {}, [this] { exchange_->askForExport(); });
    add("labels.compare", tr("&Compare with labels of…"), {}, [this] { exchange_->askForOther(); });
    add(
        "labels.vocabulary", tr("Use another voca&bulary…"), {},
        [this] { exchange_->askForVocabulary(); }, true);
    add("labels.vocabulary.builtIn", tr("Use the built-&in vocabulary"), {},
        [this] { exchange_->useBuiltInVocabulary(); });
    connect(exchange_, &LabelExchange::compared, this,
            [this, &views](const QString& name, const MatchedLabels& labels) {
                workspaces_->show(QStringLiteral("label"));
                views.setPage(LabelViews::ComparePage);
                views.comparison().compare(name, labels);
                views.comparison().list()->setFocus();
            });
    connect(&views, &LabelViews::pageChanged, commands_, &CommandTable::refresh);
    connect(&views.find().list().model(), &FoundModel::modelReset, commands_,
            &CommandTable::refresh);
    connect(&views.similar(), &SimilarBox::shown, commands_, &CommandTable::refresh);
    connect(&views.comparison(), &CompareLabelsBox::changed, commands_, &CommandTable::refresh);
}

}  // namespace kumite::studio
