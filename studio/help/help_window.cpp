#include "studio/help/help_window.h"

#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QTextDocument>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/commands.h"
#include "studio/help/help_pages.h"
#include "studio/help/help_view.h"

namespace kumite::studio {

namespace {

constexpr int kPage = Qt::UserRole;

QToolButton* arrowButton(const QString& arrow, const QString& name, const QString& key,
                         QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setText(arrow);
    button->setAccessibleName(name);
    button->setToolTip(QStringLiteral("%1 (%2)").arg(name, key));
    auto* shortcut = new QShortcut(QKeySequence(key), parent);
    QObject::connect(shortcut, &QShortcut::activated, button, [button] { button->click(); });
    return button;
}

}  // namespace

HelpWindow::HelpWindow(const CommandTable& commands, QWidget* parent)
    : QDialog(parent),
      commands_(commands),
      search_(new QLineEdit(this)),
      counts_(new QLabel(this)),
      contents_(new QListWidget(this)),
      view_(new HelpView(this)),
      back_(arrowButton(QStringLiteral("←"), tr("The page before"), QStringLiteral("Alt+Left"),
                        this)),
      on_(arrowButton(QStringLiteral("→"), tr("On again"), QStringLiteral("Alt+Right"), this)) {
    setWindowTitle(tr("Help"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(8);
    auto* top = new QHBoxLayout;
    top->addWidget(back_);
    top->addWidget(on_);
    top->addWidget(search_, 1);
    top->addWidget(counts_);
    layout->addLayout(top);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(8);
    middle->addWidget(contents_);
    middle->addWidget(view_, 1);
    layout->addLayout(middle, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close the help (Esc)"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    for (auto* button : findChildren<QPushButton*>())
        button->setAutoDefault(false);

    search_->setPlaceholderText(tr("Search all pages"));
    search_->setAccessibleName(tr("Search all pages"));
    search_->setToolTip(
        tr("Shows the pages that hold all of these words. Return: the next place; Shift+Return: "
           "the one before. (Ctrl+F)"));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    counts_->setProperty("role", "second");
    counts_->setAccessibleName(tr("How often the words were found"));
    contents_->setAccessibleName(tr("Contents"));
    contents_->setToolTip(tr("The pages of the help"));
    contents_->setFixedWidth(fontMetrics().averageCharWidth() * 32);
    view_->setAccessibleName(tr("The page"));
    view_->setAccessibleDescription(tr("Tab leads from link to link, Return follows one."));

    connect(search_, &QLineEdit::textChanged, this, [this] { search(search_->text()); });
    connect(contents_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item != nullptr && item->data(kPage).toString() != page_)
            showPage(item->data(kPage).toString());
    });
    connect(view_, &HelpView::anchorClicked, this, &HelpWindow::follow);
    connect(back_, &QToolButton::clicked, this, [this] { goBack(-1); });
    connect(on_, &QToolButton::clicked, this, [this] { goBack(1); });
    auto* find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, this, [this] {
        search_->setFocus();
        search_->selectAll();
    });
    connect(&commands_, &CommandTable::renamed, this, [this] {
        plain_.clear();
        if (!page_.isEmpty()) open(page_, {});
    });
    const QSize screen = QGuiApplication::primaryScreen()->availableSize();
    resize(QSize(980, 720).boundedTo(screen - QSize(40, 60)));
    fillContents();
    search_->setFocus();
}

QStringList HelpWindow::words() const {
    return search_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

const QString& HelpWindow::plainText(std::size_t page) {
    if (plain_.empty()) {
        for (const HelpPage& each : helpPages()) {
            QTextDocument document;
            document.setMarkdown(shownText(each, commands_), QTextDocument::MarkdownDialectGitHub);
            plain_.push_back(document.toPlainText());
        }
    }
    return plain_[page];
}

void HelpWindow::fillContents() {
    const QStringList wanted = words();
    const QSignalBlocker quiet(contents_);
    contents_->clear();
    for (std::size_t i = 0; i < helpPages().size(); ++i) {
        const HelpPage& page = helpPages()[i];
        qsizetype places = 0;
        const bool holdsAll = std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
            const qsizetype count = plainText(i).count(word, Qt::CaseInsensitive);
            places += count;
            return count > 0;
        });
        if (!holdsAll) continue;
        auto* item = new QListWidgetItem(
            places > 0 ? tr("%1 (%2)").arg(page.title).arg(places) : page.title, contents_);
        item->setData(kPage, page.id);
        item->setToolTip(places > 0 ? tr("Found %1 times on this page").arg(places)
                                    : tr("Show this page"));
        if (page.id == page_) contents_->setCurrentItem(item);
    }
}

void HelpWindow::search(const QString& text) {
    if (search_->text() != text) {
        search_->setText(text);  // comes back here
        return;
    }
    fillContents();
    view_->mark(words());
    // What is read stays where it holds the words; else the first page that does is shown.
    if (contents_->currentItem() == nullptr && contents_->count() > 0) contents_->setCurrentRow(0);
    showCounts();
}

void HelpWindow::showCounts() {
    QString text;
    if (!words().isEmpty()) {
        text =
            contents_->count() == 0
                ? tr("No page holds these words.")
                : tr("%1 of %2 on this page").arg(view_->currentMark() + 1).arg(view_->markCount());
    }
    counts_->setText(text);
}

void HelpWindow::showPage(const QString& place) {
    const QString page = place.section(QLatin1Char('#'), 0, 0);
    const QString anchor = place.section(QLatin1Char('#'), 1);
    if (helpPage(page) == nullptr) return;
    visited_ = visited_.mid(0, at_ + 1);
    if (visited_.isEmpty() || visited_.back() != place) visited_.append(place);
    at_ = visited_.size() - 1;
    open(page, anchor);
}

void HelpWindow::open(const QString& page, const QString& anchor) {
    page_ = page;
    view_->showText(shownText(*helpPage(page), commands_), helpPage(page)->headingOf(anchor));
    const QSignalBlocker quiet(contents_);
    contents_->setCurrentItem(nullptr);
    for (int row = 0; row < contents_->count(); ++row) {
        if (contents_->item(row)->data(kPage).toString() == page) contents_->setCurrentRow(row);
    }
    back_->setEnabled(at_ > 0);
    on_->setEnabled(at_ + 1 < visited_.size());
    setWindowTitle(tr("%1 — Help").arg(helpPage(page)->title));
    showCounts();
}

void HelpWindow::goBack(int direction) {
    const qsizetype to = at_ + direction;
    if (to < 0 || to >= visited_.size()) return;
    at_ = to;
    open(visited_[at_].section(QLatin1Char('#'), 0, 0), visited_[at_].section(QLatin1Char('#'), 1));
}

void HelpWindow::follow(const QUrl& link) {
    const QString path = link.path();
    if (!link.scheme().isEmpty()) {
        Q_EMIT followed(link);
    } else if (path.isEmpty()) {
        showPage(page_ + QLatin1Char('#') + link.fragment());
    } else {
        const QString page = path.section(QLatin1Char('.'), 0, 0);
        showPage(link.fragment().isEmpty() ? page : page + QLatin1Char('#') + link.fragment());
    }
}

void HelpWindow::stepMark(int direction) {
    if (words().isEmpty() || contents_->count() == 0) return;
    const int next = view_->currentMark() + direction;
    if (next >= 0 && next < view_->markCount()) {
        view_->stepMark(direction);
    } else {
        const int rows = contents_->count();
        contents_->setCurrentRow((contents_->currentRow() + direction + rows) % rows);
        // Round on a single page, and from the end on the way back.
        if (rows == 1 || direction < 0) view_->stepMark(direction);
    }
    showCounts();
}

bool HelpWindow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == search_ && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            stepMark(key->modifiers() & Qt::ShiftModifier ? -1 : 1);
            return true;
        }
        if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
            const int row = contents_->currentRow() + (key->key() == Qt::Key_Down ? 1 : -1);
            if (row >= 0 && row < contents_->count()) contents_->setCurrentRow(row);
            return true;
        }
        if (key->key() == Qt::Key_PageDown || key->key() == Qt::Key_PageUp) {
            QCoreApplication::sendEvent(view_, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace kumite::studio
