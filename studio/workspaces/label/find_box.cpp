#include "studio/workspaces/label/find_box.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStringListModel>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "core/project/label_search.h"
#include "studio/app/core_words.h"
#include "studio/workspaces/label/found_list.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

namespace {

/// The actions that pass, as they are shown.
std::vector<FoundRow> rowsFor(LabelSession& labels, const LabelFilter& filter) {
    std::vector<FoundRow> rows;
    const Document& document = labels.session().document();
    const Analysis& analysis = document.analysis();
    const Vocabulary& vocabulary = labels.vocabulary();
    std::vector<AspectValue> values;
    for (const ShownAction& shown : labels.actions()) {
        const auto& segmentation = analysis.at(shown.fighter).segmentation;
        if (!segmentation || shown.index >= static_cast<int>(segmentation->actions.size()))
            continue;
        const Action& action = segmentation->actions[static_cast<std::size_t>(shown.index)];
        const Fighter& fighter = fighterAt(document.project(), shown.fighter);
        values.clear();
        for (const ShownAspect& aspect : shown.aspects)
            values.push_back(aspect.value);
        const auto match = filter.match(
            {shown.fighter.take, shown.fighter.player, timeOfFrame(fighter, action.begin),
             timeOfFrame(fighter, action.end), values, shown.anyByHand() || shown.anyAccepted()});
        if (!match) continue;
        FoundRow row{shown.fighter, shown.peak, labelWords(vocabulary, shown.label()), {}, {}};
        if (!match->aspects.empty()) {
            row.source = sourceWords(match->source);
            row.confidence = match->confidence;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

FindBox::FindBox(LabelSession& labels, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      field_(new QLineEdit(this)),
      offers_(new QStringListModel(this)),
      understood_(new QLabel(this)),
      list_(new FoundList(labels, tr("Actions found"), this)),
      all_(new QPushButton(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(field_);
    layout->addWidget(understood_);
    layout->addWidget(list_, 1);
    layout->addWidget(all_);
    field_->setPlaceholderText(tr("right kick up, machine, below 0.6"));
    field_->setClearButtonEnabled(true);
    field_->setAccessibleName(tr("Find actions"));
    field_->setToolTip(
        tr("Aspects and qualifiers (kick, right punch fwd, jump none), who said it (by hand, "
           "machine, rule), how surely (uncertain, below 0.6), which fighter or take, when (after "
           "1:20, longer than 1 s), unlabelled. All must hold; \"or\" joins two, \"not\" turns one "
           "round. Source and confidence are those of the aspects that are named."));
    understood_->setWordWrap(true);
    understood_->setProperty("role", "second");
    understood_->setAccessibleName(tr("What was understood"));
    all_->setToolTip(
        tr("Choose all that were found in this take: the next label goes to all of "
           "them, as one step"));
    auto* completer = new QCompleter(offers_, this);
    completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    completer->setWidget(field_);
    connect(completer, qOverload<const QString&>(&QCompleter::activated), field_,
            &QLineEdit::setText);
    connect(field_, &QLineEdit::textChanged, this, &FindBox::find);
    connect(field_, &QLineEdit::textEdited, this, &FindBox::complete);
    connect(field_, &QLineEdit::returnPressed, this, [this] { list_->step(1); });
    connect(all_, &QPushButton::clicked, list_, &FoundList::chooseAll);
    connect(&labels_, &LabelSession::changed, this, [this] {
        if (isVisible()) find();
    });
    find();
}

void FindBox::setText(const QString& text) {
    field_->setText(text);
}

void FindBox::focusField() {
    field_->setFocus(Qt::ShortcutFocusReason);
    field_->selectAll();
}

void FindBox::showEvent(QShowEvent*) {
    find();
}

void FindBox::complete() {
    QStringList offers;
    const FilterWords words = filterWords(labels_.session().document().project());
    const std::string typed = field_->text().toStdString();
    for (const std::string& each : completeLabelFilter(words, typed, 8))
        offers.append(QString::fromStdString(each));
    // What is typed to its end needs no offer.
    if (offers.contains(field_->text().trimmed(), Qt::CaseInsensitive)) offers.clear();
    offers_->setStringList(offers);
    QCompleter* completer = findChild<QCompleter*>();
    if (offers.isEmpty() || field_->text().trimmed().isEmpty()) {
        completer->popup()->hide();
    } else {
        completer->complete();
    }
}

void FindBox::find() {
    const QString typed = field_->text().trimmed();
    try {
        const FilterWords words = filterWords(labels_.session().document().project());
        const LabelFilter filter = parseLabelFilter(words, typed.toStdString());
        std::vector<FoundRow> rows = rowsFor(labels_, filter);
        const auto count = static_cast<int>(rows.size());
        const QString found = count == 1 ? tr("1 action") : tr("%1 actions").arg(count);
        understood_->setText(filter.isEmpty() ? found
                                              : found + QStringLiteral(" · ") +
                                                    QString::fromStdString(filter.text()));
        all_->setText(tr("Choose all %1").arg(count));
        all_->setEnabled(count > 1);
        list_->show(std::move(rows),
                    labels_.actions().empty()
                        ? tr("The actions of the bout appear here once a recording is cut.")
                        : tr("No action is like that."));
    } catch (const Error& error) {
        understood_->setText(QStringLiteral("⚠ ") + coreWords(error.what()));
        all_->setText(tr("Choose all"));
        all_->setEnabled(false);
        list_->show({}, {});
    }
}

}  // namespace kumite::studio
