#include "studio/app/findings_page.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "studio/app/core_words.h"
#include "studio/app/icons.h"
#include "studio/app/panel_parts.h"
#include "studio/app/theme.h"

namespace kumite::studio {

void FindingsLog::add(const QString& about, const Findings& findings) {
    // What was found about something before is out of date.
    const auto gone =
        std::erase_if(groups_, [&](const FoundInFiles& group) { return group.about == about; });
    if (findings.empty() && gone == 0) return;
    if (!findings.empty()) groups_.push_back({about, findings});
    Q_EMIT changed();
}

void FindingsLog::clear() {
    if (groups_.empty()) return;
    groups_.clear();
    Q_EMIT changed();
}

int FindingsLog::count() const {
    std::size_t all = 0;
    for (const FoundInFiles& group : groups_)
        all += group.findings.size();
    return static_cast<int>(all);
}

FindingsPage::FindingsPage(const FindingsLog& findings, QWidget* parent)
    : QDialog(parent),
      findings_(findings),
      content_(new QWidget(this)),
      rows_(new QVBoxLayout(content_)) {
    setWindowTitle(tr("Findings in the recordings"));
    resize(600, 360);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setAccessibleName(windowTitle());
    scroll->setWidget(content_);
    layout->addWidget(scroll, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close this page (Esc)"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    rows_->setContentsMargins(0, 0, 8, 0);
    rows_->setSpacing(6);
    connect(&findings_, &FindingsLog::changed, this, &FindingsPage::fill);
    fill();
}

void FindingsPage::fill() {
    while (QLayoutItem* item = rows_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const Colours& c = coloursFor(palette());
    const QColor amber = c.dark ? c.accent : QColor("#b87700");
    for (const FoundInFiles& group : findings_.groups()) {
        auto* heading = headingLabel(group.about, content_);
        heading->setContentsMargins(0, 4, 0, 0);
        rows_->addWidget(heading);
        for (const Finding& finding : group.findings) {
            auto* row = new QWidget(content_);
            auto* box = new QHBoxLayout(row);
            box->setContentsMargins(0, 0, 0, 0);
            box->setSpacing(8);
            auto* icon = new QLabel(row);
            icon->setFixedWidth(16);
            const bool warning = finding.severity == Severity::Warning;
            icon->setPixmap(linePixmap(warning ? QStringLiteral("warning") : QStringLiteral("info"),
                                       warning ? amber : c.secondText, 16, devicePixelRatioF()));
            icon->setAccessibleName(warning ? tr("Warning") : tr("Remark"));
            box->addWidget(icon, 0, Qt::AlignTop);
            auto* text = new QLabel(coreWords(finding.text), row);
            text->setWordWrap(true);
            text->setTextFormat(Qt::PlainText);
            text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
            box->addWidget(text, 1);
            rows_->addWidget(row);
        }
    }
    if (findings_.count() == 0) {
        auto* none = new QLabel(tr("What is odd or worth knowing about the recordings of a project "
                                   "is listed here. There is nothing."),
                                content_);
        none->setProperty("role", "second");
        none->setWordWrap(true);
        rows_->addWidget(none);
    }
    rows_->addStretch(1);
}

}  // namespace kumite::studio
