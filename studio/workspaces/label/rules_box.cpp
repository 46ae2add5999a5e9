#include "studio/workspaces/label/rules_box.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "core/project/label_judgement.h"
#include "studio/app/core_words.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/segment/value_field.h"

namespace kumite::studio {

namespace {

/// Where each field keeps its value.
double& valueOf(RuleSettings& rules, int field) {
    double* const values[] = {&rules.contacts.height,        &rules.contacts.speed,
                              &rules.contacts.releaseHeight, &rules.contacts.releaseSpeed,
                              &rules.contacts.shortest,      &rules.closingSpeed};
    return *values[field];
}

}  // namespace

RulesBox::RulesBox(LabelSession& labels, QWidget* parent)
    : QWidget(parent), labels_(labels), changes_(new QLabel(this)), reasons_(new QLabel(this)) {
    // Short words: the panel of a small window has room for no others.
    const struct {
        QString text;
        SliderScale scale;
        ValueField::Look look;
    } rows[kFields] = {
        {tr("Lands below"),
         {0.01, 0.20, 190},
         {tr("Height below which a foot lands"),
          tr("A foot stands once its toes are lower than this above their rest height …"), tr(" m"),
          3, 0.01, 1.0}},
        {tr("slower than"),
         {0.05, 2.0, 195},
         {tr("Speed below which a foot lands"), tr("… and slower than this."), tr(" m/s"), 2, 0.05,
          10.0}},
        {tr("Lifts above"),
         {0.02, 0.30, 280},
         {tr("Height above which a foot lifts"),
          tr("It no longer stands once its toes are higher than this …"), tr(" m"), 3, 0.01, 1.0}},
        {tr("faster than"),
         {0.1, 3.0, 290},
         {tr("Speed above which a foot lifts"), tr("… or faster than this."), tr(" m/s"), 2, 0.05,
          10.0}},
        {tr("Stands for"),
         {0.0, 0.3, 300},
         {tr("Shortest stance"), tr("A stance that is shorter does not count."), tr(" s"), 3, 0.01,
          2.0}},
        {tr("Closes at"),
         {0.0, 5.0, 500},
         {tr("Speed at which an attack must close"),
          tr("An attack counts for the react rule if its fist or foot closes on the trunk or head "
             "faster than this at some moment."),
          tr(" m/s"), 2, 0.1, 20.0}},
    };
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    auto* form = new QFormLayout;
    form->setSpacing(4);
    form->setHorizontalSpacing(6);
    for (int i = 0; i < kFields; ++i) {
        fields_[i] = new ValueField(rows[i].scale, rows[i].look, this);
        form->addRow(rows[i].text, fields_[i]);
        connect(fields_[i], &ValueField::chosen, this, &RulesBox::choose);
        connect(fields_[i], &ValueField::released, this, &RulesBox::endGesture);
    }
    layout->addLayout(form);
    auto* usual = new QPushButton(tr("Usual thresholds"), this);
    usual->setToolTip(tr("Back to the thresholds that the studio brings"));
    connect(usual, &QPushButton::clicked, this, &RulesBox::restore);
    layout->addWidget(usual, 0, Qt::AlignLeft);
    for (QLabel* text : {changes_, reasons_}) {
        text->setWordWrap(true);
        text->setProperty("role", "second");
        layout->addWidget(text);
    }
    changes_->setAccessibleName(tr("What the thresholds change"));
    reasons_->setAccessibleName(tr("Why the rules say so"));
    layout->addStretch(1);
    connect(&labels_, &LabelSession::changed, this, [this] {
        showSettings();
        act();
        showChanges();
        showReasons();
    });
    connect(&labels_, &LabelSession::choiceChanged, this, &RulesBox::showReasons);
    connect(&labels_.session().document(), &Document::changed, this, &RulesBox::showSettings);
    showSettings();
    showChanges();
    showReasons();
}

RuleSettings RulesBox::settings() const {
    RuleSettings rules;
    for (int i = 0; i < kFields; ++i)
        valueOf(rules, i) = fields_[i]->value();
    return rules;
}

bool RulesBox::isDragged() const {
    return std::any_of(std::begin(fields_), std::end(fields_),
                       [](const ValueField* field) { return field->isDragged(); });
}

void RulesBox::choose() {
    if (!labels_.session().document().isOpen()) return;
    beginGesture();
    waiting_ = settings();
    // While values are computed a slider waits for them, so that something is seen on the way.
    if (!isDragged() || labels_.session().document().isCurrent()) act();
}

void RulesBox::act() {
    if (!waiting_) return;
    const RuleSettings rules = *waiting_;
    waiting_.reset();
    Document& document = labels_.session().document();
    document.applyLive(QStringLiteral("rules"),
                       [&](const Project& project) { return setRules(project, rules); });
    if (!isDragged()) endGesture();
}

/// What a gesture changes is counted against what it found.
void RulesBox::beginGesture() {
    if (!gesture_) before_ = labels_.learnt();
    gesture_ = true;
}

void RulesBox::endGesture() {
    act();
    gesture_ = false;
    labels_.session().document().endGesture();
}

void RulesBox::restore() {
    beginGesture();
    gesture_ = false;
    const auto edit = [](const Project& project) { return setRules(project, RuleSettings()); };
    labels_.session().document().apply(Document::ProjectEdit(edit));
}

void RulesBox::showSettings() {
    if (waiting_) return;
    RuleSettings rules = labels_.session().document().project().labelling.rules;
    for (int i = 0; i < kFields; ++i)
        fields_[i]->setValue(valueOf(rules, i));
}

QString RulesBox::changesText() const {
    if (!before_ || !labels_.learnt() || before_ == labels_.learnt()) return {};
    const Vocabulary& vocabulary = labels_.vocabulary();
    if (!(*before_->vocabulary == vocabulary)) return {};
    QStringList parts;
    for (const RuleChange& change :
         ruleChanges(vocabulary, before_->proposals, labels_.learnt()->proposals)) {
        const QString name = vocabularyInText(vocabulary[change.aspect].name);
        parts.append(
            change.changed == 0
                ? tr("%1: no action").arg(name)
                : tr("%1: %2 of %3 actions").arg(name).arg(change.changed).arg(change.actions));
    }
    return parts.join(QStringLiteral(", "));
}

void RulesBox::showChanges() {
    const QString changes = changesText();
    changes_->setText(changes.isEmpty() ? tr("How many actions get another label stands here while "
                                             "a threshold is changed.")
                                        : tr("Changed: %1.").arg(changes));
}

void RulesBox::showReasons() {
    const ShownAction* action = labels_.current();
    const RuleReasons* reasons = action ? labels_.reasonsOf(*action) : nullptr;
    QStringList lines;
    if (reasons != nullptr && !reasons->react.empty())
        lines.append(tr("React: %1").arg(coreWords(reasons->react)));
    if (reasons != nullptr && !reasons->moves.empty())
        lines.append(tr("Move: %1").arg(coreWords(reasons->moves)));
    reasons_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace kumite::studio
