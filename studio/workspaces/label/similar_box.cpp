#include "studio/workspaces/label/similar_box.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "studio/app/words.h"
#include "studio/view3d/action_tiles.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

namespace {

constexpr int kTiles = 6;

ActionTile tileOf(const Document& document, const Vocabulary& vocabulary, const ShownAction& action,
                  const ActionDistances::Neighbour* neighbour) {
    ActionTile tile;
    const auto& fighters = document.analysis().takes[static_cast<std::size_t>(action.fighter.take)];
    for (std::size_t player = 0; player < fighters.size() && player < 2; ++player) {
        if (fighters[player].available()) tile.fighters[player] = fighters[player];
    }
    tile.player = action.fighter.player;
    const Fighter& fighter = fighterAt(document.project(), action.fighter);
    const auto& actions = document.analysis().at(action.fighter).segmentation->actions;
    const Action& stretch = actions[static_cast<std::size_t>(action.index)];
    tile.begin = timeOfFrame(fighter, stretch.begin);
    tile.end = timeOfFrame(fighter, stretch.end);
    tile.title = labelWords(vocabulary, action.label());
    const QString time = timeText(tile.begin, 0.1);
    if (neighbour == nullptr) {
        tile.detail = SimilarBox::tr("this one, %1").arg(time);
        return tile;
    }
    tile.mirrored = neighbour->mirrored;
    const QString source = action.anyByHand() ? sourceWords(LabelSource::Hand)
                           : action.anyAccepted()
                               ? SimilarBox::tr("accepted")
                               : QStringLiteral("p ") + numberText(action.confidence(), 2);
    tile.detail = SimilarBox::tr("%1, %2%3")
                      .arg(source, time, tile.mirrored ? SimilarBox::tr(" ⇄") : QString());
    return tile;
}

}  // namespace

SimilarBox::SimilarBox(LabelSession& labels, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      tiles_(new ActionTiles(this)),
      said_(new QLabel(this)),
      give_(new QPushButton(this)),
      opponent_(new QCheckBox(tr("Both"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(said_);
    layout->addWidget(tiles_, 1);
    auto* row = new QHBoxLayout;
    row->addWidget(give_, 1);
    row->addWidget(opponent_);
    layout->addLayout(row);
    said_->setWordWrap(true);
    said_->setProperty("role", "second");
    said_->setToolTip(
        tr("Nearest by the numbers from which the machine learns; ⇄: its mirror image is near, and "
           "it is seen from the other side. All begin and end together."));
    give_->setToolTip(
        tr("The chosen ones get the label of the first one, said by a hand, as one step of the "
           "history. A click or Space chooses, a double click or Enter goes there."));
    opponent_->setToolTip(tr("Show both fighters: the opponent, too"));
    opponent_->setChecked(true);
    connect(opponent_, &QCheckBox::toggled, tiles_, &ActionTiles::setWithOpponent);
    connect(give_, &QPushButton::clicked, this, &SimilarBox::giveLabel);
    connect(tiles_, &ActionTiles::chosenChanged, this, &SimilarBox::showChoice);
    connect(tiles_, &ActionTiles::opened, this, &SimilarBox::open);
    connect(&labels_, &LabelSession::changed, this, &SimilarBox::follow);
    connect(&labels_, &LabelSession::choiceChanged, this, &SimilarBox::follow);
    connect(&jobs_, &JobRunner::failed, &labels_.session(), &Session::hinted);
    showChoice();
}

void SimilarBox::showEvent(QShowEvent*) {
    follow();
}

void SimilarBox::follow() {
    if (!isVisible() || !labels_.session().document().isCurrent()) return;
    const auto& learnt = labels_.learnt();
    const bool mirrored = labels_.session().document().project().labelling.learning.mirrored;
    if (learnt && (learnt->ground != ground_ || mirrored != mirrored_)) {
        measure();
    } else {
        showNearest();
    }
}

void SimilarBox::measure() {
    ground_ = labels_.learnt()->ground;
    mirrored_ = labels_.session().document().project().labelling.learning.mirrored;
    jobs_.start(
        tr("Comparing actions"),
        [ground = ground_, mirrored = mirrored_](const Progress&) {
            return std::make_shared<const ActionDistances>(ground->table.features, mirrored);
        },
        [this](std::shared_ptr<const ActionDistances> distances) {
            distances_ = std::move(distances);
            showNearest();
        });
}

void SimilarBox::showNearest() {
    const ShownAction* current = labels_.current();
    actions_.clear();
    nearest_.clear();
    std::vector<int> rows;
    if (current && current->row >= 0 && distances_ &&
        current->row < static_cast<int>(distances_->rows().rows())) {
        actions_.push_back(labels_.indexOf(current->fighter, current->peak));
        nearest_.emplace_back();
        rows.push_back(current->row);
        for (const auto& each : distances_->nearest(current->row, kTiles - 1)) {
            const auto& row = ground_->table.rows[static_cast<std::size_t>(each.row)];
            const int index =
                labels_.indexOf(row.fighter, ground_->peaks[static_cast<std::size_t>(each.row)]);
            if (index < 0) continue;
            actions_.push_back(index);
            nearest_.push_back(each);
            rows.push_back(each.row);
        }
    }
    const std::vector<int> chosen = rows == rows_ ? tiles_->chosen() : std::vector<int>();
    rows_ = rows;
    showTiles();
    tiles_->setChosen(chosen);
}

void SimilarBox::showTiles() {
    std::vector<ActionTile> tiles;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        tiles.push_back(tileOf(labels_.session().document(), labels_.vocabulary(),
                               labels_.actions()[static_cast<std::size_t>(actions_[i])],
                               i == 0 ? nullptr : &nearest_[i]));
    }
    tiles_->show(std::move(tiles));
    showChoice();
    Q_EMIT shown();
}

void SimilarBox::showChoice() {
    const bool any = actions_.size() > 1;
    tiles_->setVisible(any);
    said_->setText(any ? tr("The actions most like the current one.")
                       : tr("The actions most like the current one appear here, once there is an "
                            "action at the playhead."));
    const auto chosen = static_cast<int>(tiles_->chosen().size());
    give_->setEnabled(any);
    give_->setText(chosen == 0 ? tr("Same label for all") : tr("Same label for %1").arg(chosen));
}

void SimilarBox::giveLabel() {
    if (actions_.size() < 2) return;
    std::vector<int> given = tiles_->chosen();
    if (given.empty()) {
        for (int tile = 1; tile < tiles_->count(); ++tile)
            given.push_back(tile);
    }
    // What rules decide is not handed on, and a neighbour in the mirror gets the mirrored label.
    const Vocabulary& vocabulary = labels_.vocabulary();
    Label label = labels_.actions()[static_cast<std::size_t>(actions_.front())].label();
    for (int a = 0; a < vocabulary.size(); ++a) {
        if (vocabulary[a].classifier != Classifier::Msvm)
            label[static_cast<std::size_t>(a)] = kUnknown;
    }
    std::vector<std::pair<int, Label>> answers = {{actions_.front(), label}};
    for (const int tile : given) {
        const auto at = static_cast<std::size_t>(tile);
        answers.emplace_back(actions_[at],
                             nearest_[at].mirrored ? mirroredLabel(vocabulary, label) : label);
    }
    labels_.sayEach(answers);
}

void SimilarBox::open(int tile) {
    labels_.goTo(
        labels_.actions()[static_cast<std::size_t>(actions_[static_cast<std::size_t>(tile)])]);
    labels_.session().transport().setPlaying(true);
}

}  // namespace kumite::studio
