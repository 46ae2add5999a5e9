#include "studio/app/command_palette.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QSettings>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/fuzzy_match.h"
#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr int kMenuRole = Qt::UserRole + 1;
constexpr int kKeysRole = Qt::UserRole + 2;
constexpr int kMatchRole = Qt::UserRole + 3;
constexpr int kOnRole = Qt::UserRole + 4;
/// Of a row of the list.
int rowHeight() {
    return withTextSize(26);
}
constexpr int kMostRows = 12;
constexpr int kMostRecent = 8;
/// What is found in the command's own name counts most, then what people also call it, then its
/// menu's name.
constexpr int kInName = 20;
constexpr int kInWords = 10;
const QString kRecent = QStringLiteral("palette/recent");

QStringList recentIds() {
    return QSettings().value(kRecent).toStringList();
}

void rememberId(const QString& id) {
    QStringList ids = recentIds();
    ids.removeAll(id);
    ids.prepend(id);
    QSettings().setValue(kRecent, ids.mid(0, kMostRecent));
}

/// A row: name with the typed letters emphasised, menu beside it, keys at the right.
class RowPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {0, rowHeight()};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Colours& c = coloursFor(option.palette);
        painter->save();
        if (option.state & QStyle::State_Selected) {
            painter->fillRect(option.rect, mixed(c.panel, c.accent, c.dark ? 0.28 : 0.32));
        } else if (option.state & QStyle::State_MouseOver) {
            painter->fillRect(option.rect, mixed(c.panel, c.line, 0.55));
        }
        QRect row = option.rect.adjusted(12, 0, -12, 0);
        painter->setFont(option.font);
        painter->setPen(c.secondText);
        const QString keys = index.data(kKeysRole).toString();
        painter->drawText(row, Qt::AlignRight | Qt::AlignVCenter, keys);
        row.setRight(row.right() - option.fontMetrics.horizontalAdvance(keys) - 12);

        const QString name = index.data(Qt::DisplayRole).toString();
        const QVariantList match = index.data(kMatchRole).toList();
        QFont strong = option.font;
        strong.setBold(true);
        int x = row.left();
        for (qsizetype i = 0; i < name.size(); ++i) {
            const bool typed = match.contains(static_cast<int>(i));
            painter->setFont(typed ? strong : option.font);
            painter->setPen(c.text);
            const QString letter = name.mid(i, 1);
            painter->drawText(QRect(x, row.top(), row.right() - x, row.height()),
                              Qt::AlignLeft | Qt::AlignVCenter, letter);
            x += painter->fontMetrics().horizontalAdvance(letter);
        }
        painter->setFont(option.font);
        painter->setPen(c.secondText);
        QString beside = index.data(kMenuRole).toString();
        if (index.data(kOnRole).toBool()) beside += CommandPalette::tr(" · on");
        const QRect rest(x + 12, row.top(), row.right() - x - 12, row.height());
        painter->drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                          option.fontMetrics.elidedText(beside, Qt::ElideRight, rest.width()));
        painter->restore();
    }
};

struct Answer {
    const Command* command = nullptr;
    int score = 0;
    QVariantList inName;
    QString word;  ///< of those that people also use, the one that answers
};

/// Whether `typed` begins a word of `text`.
bool beginsWordOf(const QString& typed, const QString& text) {
    const qsizetype at = text.indexOf(typed, 0, Qt::CaseInsensitive);
    return at == 0 || (at > 0 && !text[at - 1].isLetterOrNumber());
}

/// Words are short and many: scattered letters would be found in nearly all of them.
void tryWords(const QString& typed, Answer& answer) {
    if (typed.isEmpty()) return;
    for (const QString& each : answer.command->words.split(QLatin1Char(','))) {
        const QString word = each.trimmed();
        if (!beginsWordOf(typed, word)) continue;
        const auto match = fuzzyMatch(typed, word);
        if (!match || match->score + kInWords <= answer.score) continue;
        answer.score = match->score + kInWords;
        answer.word = word;
        answer.inName.clear();
    }
}

std::vector<Answer> answersTo(const QString& typed, const CommandTable& commands) {
    std::vector<Answer> answers;
    const QStringList recent = recentIds();
    for (const Command& command : commands.commands()) {
        const QAction* action = commands.action(command.id);
        if (!commands.isEnabled(command) || action->menu() != nullptr) continue;
        Answer answer{&command, -1, {}, {}};
        if (const auto match = fuzzyMatch(typed, command.plainText())) {
            answer.score = match->score + kInName;
            for (const int position : match->positions)
                answer.inName.append(position);
        } else if (const auto wide = fuzzyMatch(
                       typed, command.plainMenu() + QLatin1Char(' ') + command.plainText())) {
            answer.score = wide->score;
        }
        tryWords(typed, answer);
        if (answer.score < 0) continue;
        const auto used = recent.indexOf(command.id);
        if (used >= 0) {
            // Between answers of about the same worth what was used lately wins.
            answer.score += typed.isEmpty() ? 100 - static_cast<int>(used) : 4;
        }
        answers.push_back(std::move(answer));
    }
    std::stable_sort(answers.begin(), answers.end(),
                     [](const Answer& a, const Answer& b) { return a.score > b.score; });
    return answers;
}

}  // namespace

CommandPalette::CommandPalette(CommandTable& commands, QWidget* over)
    : QFrame(over),
      commands_(commands),
      field_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      nothing_(new QLabel(this)) {
    setObjectName(QStringLiteral("commandPalette"));
    setProperty("role", "strip");
    setAutoFillBackground(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    field_->setPlaceholderText(tr("Type what you want to do"));
    field_->setAccessibleName(tr("Command"));
    field_->setToolTip(tr("A name, a menu or a word for it: ↑ ↓ choose, Return runs, Esc leaves"));
    field_->setClearButtonEnabled(false);
    field_->setMinimumHeight(28);
    layout->addWidget(field_);
    list_->setAccessibleName(tr("Commands"));
    list_->setItemDelegate(new RowPainter(list_));
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setMouseTracking(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    layout->addWidget(list_);
    nothing_->setProperty("role", "second");
    nothing_->setContentsMargins(12, 4, 12, 6);
    nothing_->setWordWrap(true);
    layout->addWidget(nothing_);
    connect(field_, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
    field_->installEventFilter(this);
    over->installEventFilter(this);
    hide();
}

void CommandPalette::open() {
    commands_.refresh();
    if (isHidden()) focusBefore_ = QApplication::focusWidget();
    field_->clear();
    fill();
    show();
    raise();
    field_->setFocus(Qt::ShortcutFocusReason);
}

void CommandPalette::dismiss() {
    if (isHidden()) return;
    hide();
    if (focusBefore_) focusBefore_->setFocus(Qt::OtherFocusReason);
}

QStringList CommandPalette::shownCommands() const {
    QStringList ids;
    for (int row = 0; row < list_->count(); ++row)
        ids.append(list_->item(row)->data(kIdRole).toString());
    return ids;
}

void CommandPalette::fill() {
    list_->clear();
    const QString typed = field_->text().trimmed();
    for (const Answer& answer : answersTo(typed, commands_)) {
        const Command& command = *answer.command;
        auto* item = new QListWidgetItem(command.plainText(), list_);
        item->setData(kIdRole, command.id);
        item->setData(kMenuRole, answer.word.isEmpty()
                                     ? command.plainMenu()
                                     : tr("%1 · “%2”").arg(command.plainMenu(), answer.word));
        item->setData(kKeysRole, command.keysText());
        item->setData(kMatchRole, answer.inName);
        item->setData(kOnRole, command.checked && command.checked());
        item->setData(Qt::AccessibleTextRole,
                      QStringLiteral("%1, %2, %3")
                          .arg(command.plainText(), command.plainMenu(), command.keysText()));
    }
    list_->setCurrentRow(0);
    list_->setVisible(list_->count() > 0);
    nothing_->setVisible(list_->count() == 0);
    nothing_->setText(tr("No command that can be run now is called “%1”.").arg(typed));
    place();
}

void CommandPalette::place() {
    const QWidget* over = parentWidget();
    const int rows = std::min(list_->count(), kMostRows);
    list_->setFixedHeight(rows * rowHeight() + 2);
    setFixedWidth(std::min(withTextSize(620), over->width() - 24));
    adjustSize();
    move((over->width() - width()) / 2, std::max(8, over->height() / 10));
}

void CommandPalette::step(int rows) {
    const int count = list_->count();
    if (count == 0) return;
    const int now = list_->currentRow();
    const bool single = std::abs(rows) == 1;
    const int next = single ? (now + rows + count) % count : std::clamp(now + rows, 0, count - 1);
    list_->setCurrentRow(next);
}

void CommandPalette::runCurrent() {
    const QListWidgetItem* item = list_->currentItem();
    if (item == nullptr) return;
    const QString id = item->data(kIdRole).toString();
    dismiss();
    rememberId(id);
    commands_.run(id);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget()) {
        if (event->type() == QEvent::Resize && isVisible()) place();
        return false;
    }
    if (event->type() == QEvent::FocusOut) {
        // Where the focus went by itself, it stays there.
        QTimer::singleShot(0, this, [this] {
            if (!field_->hasFocus() && isVisible() && QApplication::activePopupWidget() == nullptr)
                hide();
        });
        return false;
    }
    const bool typing = event->type() == QEvent::KeyPress;
    if (!typing && event->type() != QEvent::ShortcutOverride) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const auto page = kMostRows - 1;
    switch (key->key()) {
        case Qt::Key_Up:
        case Qt::Key_Backtab:
            if (typing) step(-1);
            break;
        case Qt::Key_Down:
        case Qt::Key_Tab:
            if (typing) step(1);
            break;
        case Qt::Key_PageUp:
            if (typing) step(-page);
            break;
        case Qt::Key_PageDown:
            if (typing) step(page);
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (typing) runCurrent();
            break;
        case Qt::Key_Escape:
            if (typing) dismiss();
            break;
        default:
            return false;
    }
    event->accept();
    return true;
}

}  // namespace kumite::studio
