#include "studio/app/message_strip.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/core_words.h"
#include "studio/app/icons.h"
#include "studio/app/theme.h"

namespace kumite::studio {

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent),
      icon_(new QLabel(this)),
      text_(new QLabel(this)),
      more_(new QPushButton(tr("Details"), this)),
      close_(new QToolButton(this)) {
    setProperty("role", "strip");
    setObjectName(QStringLiteral("messageStrip"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 6, 6);
    layout->setSpacing(8);
    layout->addWidget(icon_, 0, Qt::AlignTop);
    layout->addWidget(text_, 1);
    layout->addWidget(more_);
    layout->addWidget(close_);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    close_->setAccessibleName(tr("Dismiss"));
    close_->setToolTip(tr("Dismiss"));
    connect(close_, &QToolButton::clicked, this, &MessageStrip::dismiss);
    connect(more_, &QPushButton::clicked, this, [this] {
        QDialog dialog(window());
        dialog.setWindowTitle(title_);
        dialog.resize(620, 320);
        auto* box = new QVBoxLayout(&dialog);
        auto* list = new QPlainTextEdit(details_.join(QStringLiteral("\n\n")), &dialog);
        list->setReadOnly(true);
        auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
        connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
        box->addWidget(list);
        box->addWidget(buttons);
        dialog.exec();
    });
    parent->installEventFilter(this);
    drawIcons();
    hide();
}

QString MessageStrip::text() const {
    return isHidden() ? QString() : text_->text();
}

void MessageStrip::showError(const QString& sentence) {
    title_ = tr("What happened");
    present(sentence, {});
}

void MessageStrip::showFindings(const QString& about, const Findings& findings) {
    Q_EMIT found(about, findings);
    QStringList warnings;
    QStringList all;
    for (const Finding& finding : findings) {
        const QString text = coreWords(finding.text);
        if (finding.severity == Severity::Warning) warnings.append(text);
        all.append(text);
    }
    if (warnings.isEmpty()) return;
    title_ = about;
    const QString more = warnings.size() > 1
                             ? tr(" And %n more.", nullptr, static_cast<int>(warnings.size()) - 1)
                             : QString();
    present(warnings.front() + more, all);
}

void MessageStrip::present(const QString& text, const QStringList& details) {
    text_->setText(text);
    details_ = details;
    more_->setVisible(details.size() > 1);
    show();
    raise();
    place();
}

void MessageStrip::dismiss() {
    hide();
}

void MessageStrip::place() {
    if (parentWidget() == nullptr) return;
    const int width = std::min(760, parentWidget()->width() - 24);
    // The text wraps: its height follows from the width that is left for it.
    setFixedWidth(std::max(100, width));
    const int height =
        layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height();
    setFixedHeight(height);
    move((parentWidget()->width() - this->width()) / 2, 12);
}

bool MessageStrip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QFrame::eventFilter(watched, event);
}

void MessageStrip::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) drawIcons();
    QFrame::changeEvent(event);
}

void MessageStrip::drawIcons() {
    const Colours& c = coloursFor(palette());
    const QColor amber = c.dark ? c.accent : QColor("#b87700");
    icon_->setPixmap(linePixmap(QStringLiteral("warning"), amber, 16, devicePixelRatioF()));
    close_->setIcon(lineIcon(QStringLiteral("close"), c.secondText));
}

}  // namespace kumite::studio
