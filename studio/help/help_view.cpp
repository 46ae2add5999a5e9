#include "studio/help/help_view.h"

#include <QAbstractTextDocumentLayout>
#include <QEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextFrame>
#include <QTextTable>
#include <QTimer>

#include <algorithm>

#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

constexpr int kMargin = 18;

void dressBlock(const QTextBlock& block, const Colours& c, double points) {
    QTextCursor cursor(block);
    QTextBlockFormat format = block.blockFormat();
    const int level = format.headingLevel();
    cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    if (level > 0) {
        QTextCharFormat letters;
        letters.setFontPointSize(points * (level == 1 ? 1.7 : level == 2 ? 1.25 : 1.0));
        letters.setFontWeight(QFont::DemiBold);
        cursor.mergeCharFormat(letters);
        format.setTopMargin(level == 1 ? 4 : 18);
        format.setBottomMargin(6);
    } else if (QTextCursor(block).currentTable() != nullptr) {
        format.setTopMargin(1);
        format.setBottomMargin(1);
    } else if (format.hasProperty(QTextFormat::BlockCodeFence)) {
        format.setTopMargin(0);
        format.setBottomMargin(0);
        format.setBackground(c.ground);
        QTextCharFormat letters;
        letters.setFontPointSize(points * 0.9);
        cursor.mergeCharFormat(letters);
    } else {
        format.setBottomMargin(block.textList() != nullptr ? 3 : 8);
        format.setLineHeight(128, QTextBlockFormat::ProportionalHeight);
    }
    cursor.setBlockFormat(format);
}

/// Keys, names of files and commands stand in a box of their own; links are underlined.
void dressSpans(const QTextBlock& block, const Colours& c) {
    if (block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)) return;
    struct Span {
        int begin;
        int length;
        QTextCharFormat format;
    };
    std::vector<Span> spans;
    for (auto each = block.begin(); !each.atEnd(); ++each) {
        const QTextFragment fragment = each.fragment();
        QTextCharFormat format;
        if (fragment.charFormat().fontFixedPitch())
            format.setBackground(mixed(c.panel, c.line, 0.75));
        if (fragment.charFormat().isAnchor()) {
            format.setForeground(c.text);
            format.setUnderlineStyle(QTextCharFormat::SingleUnderline);
            format.setUnderlineColor(c.accent);
        }
        if (!format.isEmpty()) spans.push_back({fragment.position(), fragment.length(), format});
    }
    for (const Span& span : spans) {
        QTextCursor cursor(block);
        cursor.setPosition(span.begin);
        cursor.setPosition(span.begin + span.length, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(span.format);
    }
}

/// A line of headings without any.
bool beginsEmpty(const QTextTable& table) {
    for (int column = 0; column < table.columns(); ++column) {
        const QTextTableCell cell = table.cellAt(0, column);
        if (cell.lastPosition() > cell.firstPosition()) return false;
    }
    return table.rows() > 1;
}

}  // namespace

HelpView::HelpView(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    // Links can be walked through and followed by keys.
    setTextInteractionFlags(Qt::TextBrowserInteraction | Qt::TextSelectableByKeyboard);
}

void HelpView::showText(const QString& markdown, int heading) {
    marks_.clear();
    current_ = -1;
    setExtraSelections({});
    document()->setMarkdown(markdown, QTextDocument::MarkdownDialectGitHub);
    dress();
    if (!words_.isEmpty()) mark(words_);
    if (heading < 0 && !words_.isEmpty()) return;
    setTextCursor(QTextCursor(document()));
    verticalScrollBar()->setValue(0);
    goToHeading(heading);
    // Before it is shown for the first time nobody knows how wide it will be.
    QTimer::singleShot(0, this, [this, heading] { goToHeading(heading); });
}

void HelpView::dress() {
    const Colours& c = coloursFor(palette());
    document()->setDocumentMargin(kMargin);
    QTextCursor whole(document());
    whole.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        dressBlock(block, c, font().pointSizeF());
        dressSpans(block, c);
    }
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        if (beginsEmpty(*table)) table->removeRows(0, 1);
        QTextTableFormat format = table->format();
        format.setBorder(0);
        format.setCellSpacing(0);
        format.setCellPadding(4);
        format.setTopMargin(4);
        format.setBottomMargin(10);
        table->setFormat(format);
    }
    whole.endEditBlock();
    document()->clearUndoRedoStacks();
}

void HelpView::goToHeading(int heading) {
    if (heading < 0) return;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || heading-- > 0) continue;
        const QRectF place = document()->documentLayout()->blockBoundingRect(block);
        setTextCursor(QTextCursor(block));
        // Whatever the cursor did: the heading stands at the top.
        verticalScrollBar()->setValue(static_cast<int>(place.top()) - 8);
        return;
    }
}

void HelpView::mark(const QStringList& words) {
    words_ = words;
    marks_.clear();
    for (const QString& word : words) {
        for (QTextCursor found = document()->find(word); !found.isNull();
             found = document()->find(word, found))
            marks_.push_back(found);
    }
    std::sort(marks_.begin(), marks_.end());
    current_ = marks_.empty() ? -1 : 0;
    paintMarks();
}

void HelpView::stepMark(int direction) {
    if (marks_.empty()) return;
    const int count = markCount();
    current_ = (current_ + direction + count) % count;
    paintMarks();
}

void HelpView::paintMarks() {
    const Colours& c = coloursFor(palette());
    QList<ExtraSelection> shown;
    for (int i = 0; i < markCount(); ++i) {
        ExtraSelection selection;
        selection.cursor = marks_[static_cast<std::size_t>(i)];
        const double share = i == current_ ? 0.6 : 0.3;
        selection.format.setBackground(mixed(c.panel, c.accent, share));
        selection.format.setForeground(c.text);
        shown.append(selection);
    }
    setExtraSelections(shown);
    if (current_ < 0) return;
    QTextCursor at = marks_[static_cast<std::size_t>(current_)];
    at.clearSelection();
    setTextCursor(at);
    ensureCursorVisible();
}

void HelpView::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    const bool looks =
        event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
    if (!looks || document()->isEmpty()) return;
    dress();
    paintMarks();
}

}  // namespace kumite::studio
