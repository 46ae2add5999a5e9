#include "studio/workspaces/segment/compare_box.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/project/edits.h"
#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/workspaces/segment/detection_box.h"

namespace kumite::studio {

namespace {

std::vector<int> innerBoundaries(const FighterAnalysis& fighter) {
    std::vector<int> frames;
    if (!fighter.segmentation) return frames;
    for (const Boundary& boundary : fighter.segmentation->boundaries) {
        if (boundary.source != BoundarySource::End) frames.push_back(boundary.frame);
    }
    return frames;
}

}  // namespace

CompareBox::CompareBox(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      on_(new QCheckBox(tr("Compare with settings B"), this)),
      fields_(new SettingsFields(tr(" B"), this)),
      counts_(new QLabel(this)),
      use_(new QPushButton(tr("Use B"), this)) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(on_);
    layout->addWidget(fields_);
    layout->addWidget(counts_);
    layout->addWidget(use_, 0, Qt::AlignLeft);
    on_->setToolTip(tr("Draw beside the project's boundaries (A) those that other settings give"));
    counts_->setAccessibleName(tr("Boundaries that differ"));
    counts_->setToolTip(tr("On the timeline: ○ only in A, dotted lines only in B"));
    use_->setToolTip(tr("Cut the project by settings B"));
    connect(on_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) fields_->show(session_.document().project().segmentation);
        compute();
        Q_EMIT toggled();
    });
    connect(fields_, &SettingsFields::chosen, this, &CompareBox::compute);
    connect(use_, &QPushButton::clicked, this, &CompareBox::use);
    connect(&session_, &Session::fightersChanged, this, &CompareBox::compute);
    connect(&session_, &Session::takeChanged, this, &CompareBox::compute);
    connect(&session_, &Session::comparisonChanged, this, &CompareBox::showCounts);
    connect(&session_.document(), &Document::opened, this, [this] { setOn(false); });
    compute();
}

bool CompareBox::isOn() const {
    return on_->isChecked();
}

void CompareBox::setOn(bool on) {
    on_->setChecked(on);
}

void CompareBox::compute() {
    for (QWidget* part : std::initializer_list<QWidget*>{fields_, counts_, use_}) {
        part->setVisible(isOn());
    }
    const Document& document = session_.document();
    const auto take = static_cast<std::size_t>(session_.take());
    if (!isOn() || take >= document.project().takes.size()) {
        jobs_.cancel();
        values_ = {};
        if (session_.comparison()) session_.setComparison(std::nullopt);
        return;
    }
    // Only what is shown is cut again, and by the settings alone: positions are taken over.
    Project other = document.project();
    other.takes = {other.takes[take]};
    other.segmentation = fields_->settings();
    const Analysis& previous = values_.takes.empty() ? document.analysis() : values_;
    jobs_.start(
        tr("Comparing settings"),
        [other = std::move(other), previous](const Progress& progress) {
            return analyse(other, previous, progress);
        },
        [this](Analysis values) {
            values_ = std::move(values);
            Comparison comparison{values_.settings, {}};
            for (int player = 0; player < session_.playerCount(); ++player) {
                const auto index = static_cast<std::size_t>(player);
                const FighterAnalysis* own = session_.fighter(player);
                const bool both = own && index < values_.takes.front().size();
                comparison.players.push_back(
                    both ? compareBoundaries(innerBoundaries(*own),
                                             innerBoundaries(values_.takes.front()[index]),
                                             kCorrectionReach * own->input.rate)
                         : BoundaryComparison{});
            }
            session_.setComparison(std::move(comparison));
        });
}

void CompareBox::showCounts() {
    QStringList lines;
    if (const auto& comparison = session_.comparison()) {
        for (std::size_t player = 0; player < comparison->players.size(); ++player) {
            const BoundaryComparison& each = comparison->players[player];
            lines.append(tr("%1: %2 in both, %3 only A, %4 only B")
                             .arg(player + 1)
                             .arg(each.both)
                             .arg(each.onlyA.size())
                             .arg(each.onlyB.size()));
        }
    }
    counts_->setText(lines.join(QLatin1Char('\n')));
}

void CompareBox::use() {
    const SegmentationSettings settings = fields_->settings();
    session_.document().apply(
        [&](const Project& project) { return setSegmentation(project, settings); });
}

}  // namespace kumite::studio
