#include "studio/workspaces/label/label_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/commands.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/label_palette.h"
#include "studio/workspaces/label/label_review.h"
#include "studio/workspaces/label/label_words.h"
#include "studio/workspaces/label/progress_box.h"

namespace kumite::studio {

namespace {

/// Questions of the queue that are listed.
constexpr std::size_t kListed = 100;

/// A text and what belongs at its end, in as many lines as the width asks for: between the parts of
/// a list first.
QString wordsInWidth(const QString& text, const QString& end, const QFontMetrics& metrics,
                     int width) {
    const QString line = end.isEmpty() ? text : text + QStringLiteral("   ") + end;
    if (metrics.horizontalAdvance(line) <= width) return line;
    QStringList lines{QString()};
    for (const QString& part : text.split(QStringLiteral(", "))) {
        const QString longer = lines.last().isEmpty() ? part : lines.last() + ", " + part;
        if (metrics.horizontalAdvance(longer) <= width || lines.last().isEmpty()) {
            lines.last() = longer;
        } else {
            lines.last() += QLatin1Char(',');
            lines.append(part);
        }
    }
    const QString last = lines.last() + QStringLiteral("   ") + end;
    if (metrics.horizontalAdvance(last) <= width) {
        lines.last() = last;
    } else {
        lines.append(end);
    }
    return lines.join(QLatin1Char('\n'));
}

bool anyProposal(const Vocabulary& vocabulary, const ShownAction& action) {
    for (int a = 0; a < vocabulary.size(); ++a) {
        const ShownAspect& shown = action.aspects[static_cast<std::size_t>(a)];
        if (vocabulary[a].classifier == Classifier::Msvm && shown.value.known()) return true;
    }
    return false;
}

}  // namespace

LabelPanel::LabelPanel(LabelReview& review, CommandTable& commands, QWidget* parent)
    : QWidget(parent),
      review_(review),
      labels_(review.labels()),
      commands_(commands),
      progress_(new ProgressBox(
          review.labels(), [this](const QString& id) { return keyOf(id); }, this)),
      which_(new QLabel(this)),
      best_(new QPushButton(this)),
      second_(new QPushButton(this)),
      reason_(new QLabel(this)),
      palette_(new LabelPalette(
          review, [this](const QString& id) { return keyOf(id); }, this)),
      advance_(new QCheckBox(tr("Go on after an answer"), this)),
      order_(new QComboBox(this)),
      queue_(new QListWidget(this)),
      pages_(new QTabWidget(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(progress_);
    layout->addWidget(makeQuestion());
    pages_->setDocumentMode(true);
    pages_->setFocusPolicy(Qt::TabFocus);
    pages_->addTab(makeKeys(), tr("Keys"));
    pages_->addTab(makeQueue(), tr("Queue"));
    layout->addWidget(pages_, 1);
    setMinimumWidth(200);

    connect(&labels_, &LabelSession::changed, this, &LabelPanel::showLabels);
    connect(&labels_, &LabelSession::learningChanged, progress_, &ProgressBox::refresh);
    connect(progress_, &ProgressBox::acceptWanted, this,
            [this] { commands_.run(QStringLiteral("label.acceptSure")); });
    connect(&labels_, &LabelSession::choiceChanged, this, &LabelPanel::showChoice);
    connect(&labels_.session().transport(), &Transport::moved, this, [this] {
        // Without a selection the current action is the one at the playhead.
        if (!labels_.session().selectedAction()) showChoice();
    });
    connect(&review_, &LabelReview::switched, this, [this] {
        advance_->setChecked(review_.isAdvancing());
        palette_->refresh();
    });
    connect(&commands_, &CommandTable::renamed, this, &LabelPanel::showChoice);
    showLabels();
}

QWidget* LabelPanel::makeQuestion() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    which_->setProperty("role", "heading");
    which_->setAccessibleName(tr("Current action"));
    layout->addWidget(which_);
    for (QPushButton* button : {best_, second_}) {
        button->setFocusPolicy(Qt::TabFocus);
        button->setStyleSheet(QStringLiteral("text-align: left; padding: 3px 8px;"));
        layout->addWidget(button);
    }
    best_->setToolTip(tr("Accept what is proposed"));
    second_->setToolTip(tr("Take the second best instead; of what a hand said, nothing any more"));
    connect(best_, &QPushButton::clicked, this,
            [this] { commands_.run(QStringLiteral("label.accept")); });
    connect(second_, &QPushButton::clicked, this,
            [this] { commands_.run(QStringLiteral("label.reject")); });
    reason_->setWordWrap(true);
    reason_->setProperty("role", "second");
    reason_->setAlignment(Qt::AlignTop);
    reason_->setAccessibleName(tr("Why rules say so"));
    layout->addWidget(reason_);
    return box;
}

QWidget* LabelPanel::makeKeys() {
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* inside = new QWidget(scroll);
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->addWidget(palette_);
    layout->addStretch(1);
    scroll->setWidget(inside);
    return scroll;
}

QWidget* LabelPanel::makeQueue() {
    auto* page = new QWidget(this);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(4);
    order_->addItems({tr("Most useful first"), tr("Least sure first"), tr("In order of time")});
    order_->setFocusPolicy(Qt::TabFocus);
    order_->setAccessibleName(tr("Order of the queue"));
    order_->setToolTip(
        tr("Most useful: where the machine is torn, spread over different-looking "
           "actions"));
    layout->addWidget(order_);
    connect(order_, &QComboBox::currentIndexChanged, this,
            [this](int index) { labels_.setOrder(static_cast<QueueOrder>(index)); });
    advance_->setChecked(review_.isAdvancing());
    advance_->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(advance_);
    connect(advance_, &QCheckBox::clicked, this, [this](bool on) { review_.setAdvancing(on); });
    queue_->setAccessibleName(tr("Questions"));
    queue_->setFocusPolicy(Qt::NoFocus);
    queue_->setUniformItemSizes(true);
    queue_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(queue_, 1);
    connect(queue_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
        const auto index = static_cast<std::size_t>(item->data(Qt::UserRole).toInt());
        if (index < labels_.actions().size()) review_.show(labels_.actions()[index]);
    });
    return page;
}

void LabelPanel::acceptSure() {
    review_.acceptSure(progress_->threshold());
}

void LabelPanel::moveBar(double by) {
    progress_->moveThreshold(by);
    Q_EMIT labels_.session().hinted(
        tr("Sure from %1 on: %2")
            .arg(probabilityWords(progress_->threshold()),
                 tr("%n action(s)", nullptr, labels_.countSure(progress_->threshold()))));
}

QString LabelPanel::keyOf(const QString& id) const {
    const Command* command = commands_.find(id);
    if (command == nullptr || command->keys.isEmpty()) return {};
    return keySigns(command->keys.front());
}

void LabelPanel::showLabels() {
    progress_->refresh();
    showQueue();
    showChoice();
}

void LabelPanel::showChoice() {
    palette_->refresh();
    const std::vector<int> chosen = labels_.chosen();
    const ShownAction* action = labels_.current();
    best_->setVisible(action != nullptr);
    second_->setVisible(action != nullptr);
    if (action == nullptr) {
        which_->setText(tr("No action"));
        reason_->setText(labels_.actions().empty()
                             ? tr("Actions appear here once a recording is open and cut.")
                             : tr("%1 leads to the first question; or click an action.")
                                   .arg(keyOf(QStringLiteral("label.next"))));
        return;
    }
    which_->setText(chosen.size() > 1 ? tr("%1 actions chosen").arg(chosen.size())
                                      : tr("%1 · action %2 · %3")
                                            .arg(fighterText(action->fighter.player))
                                            .arg(action->index)
                                            .arg(timeText(labels_.timeOf(*action), 0.1)));
    showAnswers(*action);
    QStringList reasons;
    for (int a = 0; a < labels_.vocabulary().size(); ++a) {
        // Where the feet stand the lane says itself.
        if (labels_.vocabulary()[a].classifier == Classifier::MoveRule) continue;
        const QString reason = reasonWords(labels_, *action, a);
        if (reason.isEmpty()) continue;
        const ShownAspect& shown = action->aspects[static_cast<std::size_t>(a)];
        reasons.append(aspectWords(labels_.vocabulary(), a, shown.value.qualifier) +
                       QStringLiteral(": ") + reason);
    }
    reason_->setText(reasons.join(QLatin1Char('\n')));
    reason_->setVisible(!reasons.isEmpty());
}

void LabelPanel::showAnswers(const ShownAction& action) {
    const Vocabulary& vocabulary = labels_.vocabulary();
    const QString accept = keyOf(QStringLiteral("label.accept"));
    const QString reject = keyOf(QStringLiteral("label.reject"));
    // The names of two strikes take two lines of a narrow panel, and never hide how sure it is.
    const auto withKey = [this](const QString& text, const QString& key, const QString& sure = {}) {
        QStringList rest;
        for (const QString& part : {sure, key}) {
            if (!part.isEmpty()) rest.append(part);
        }
        const QString end = rest.join(QStringLiteral("   "));
        return wordsInWidth(text, end, fontMetrics(), std::max(best_->width(), 160) - 18);
    };
    const QString label = labelWords(vocabulary, action.label());
    if (action.anyByHand()) {
        best_->setText(withKey(tr("%1 · by hand").arg(label), QString()));
        best_->setEnabled(false);
        second_->setText(withKey(tr("Take back"), reject));
        second_->setEnabled(true);
        return;
    }
    const bool proposed = anyProposal(vocabulary, action);
    best_->setEnabled(proposed);
    const auto sure = [&](const Label& of) {
        const auto probability = probabilityOf(vocabulary, action, of);
        return probability ? probabilityWords(*probability) : tr("the only class so far");
    };
    best_->setText(proposed ? withKey(label, accept, sure(action.label()))
                            : tr("Nothing is proposed yet"));
    const Label second = secondBest(vocabulary, action);
    const bool other =
        std::any_of(second.begin(), second.end(), [](int q) { return q != kUnknown; });
    second_->setEnabled(other);
    second_->setText(other      ? withKey(labelWords(vocabulary, second), reject, sure(second))
                     : proposed ? tr("Something else: a class key")
                                : tr("Say what it is by a class key"));
}

void LabelPanel::showQueue() {
    if (!pages_->isVisible() && queue_->count() > 0) return;
    const std::vector<int>& queue = labels_.queue();
    queue_->clear();
    for (std::size_t i = 0; i < std::min(queue.size(), kListed); ++i) {
        const ShownAction& action = labels_.actions()[static_cast<std::size_t>(queue[i])];
        QString text = tr("%1  %2  %3")
                           .arg(timeText(labels_.timeOf(action), 0.1))
                           .arg(action.fighter.player + 1)
                           .arg(labelWords(labels_.vocabulary(), action.label()));
        const double confidence =
            probabilityOf(labels_.vocabulary(), action, action.label()).value_or(0);
        if (anyProposal(labels_.vocabulary(), action) && confidence > 0) {
            text += QStringLiteral("  ") + probabilityWords(confidence);
        }
        auto* item = new QListWidgetItem(text, queue_);
        item->setData(Qt::UserRole, queue[i]);
    }
    pages_->setTabText(1, queue.empty() ? tr("Queue") : tr("Queue %1").arg(queue.size()));
}

}  // namespace kumite::studio
