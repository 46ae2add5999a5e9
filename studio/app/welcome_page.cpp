#include "studio/app/welcome_page.h"

#include <QAction>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/recent_files.h"
#include "studio/app/welcome_picture.h"

namespace kumite::studio {

namespace {

constexpr int kMostRecent = 5;

QLabel* label(const QString& text, const char* role, QWidget* parent) {
    auto* made = new QLabel(text, parent);
    made->setProperty("role", role);
    made->setWordWrap(true);
    return made;
}

/// A bout that was opened lately: its name over its folder, the day at the right.
class RecentButton : public QPushButton {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::RecentButton)

public:
    RecentButton(const RecentBout& bout, QWidget* parent) : QPushButton(parent) {
        setProperty("role", "recent");
        setCursor(Qt::PointingHandCursor);
        const QString name = recentText(bout.files);
        const QString when = whenText(bout.opened);
        setAccessibleName(tr("Open %1, %2").arg(name, when));
        setToolTip(bout.files.join(QLatin1Char('\n')));
        auto* rows = new QVBoxLayout(this);
        rows->setContentsMargins(10, 5, 10, 5);
        rows->setSpacing(0);
        auto* first = new QHBoxLayout;
        auto* title = new QLabel(this);
        title->setText(title->fontMetrics().elidedText(name, Qt::ElideMiddle, 290));
        first->addWidget(title, 1);
        first->addWidget(label(when, "second", this), 0, Qt::AlignRight);
        static_cast<QLabel*>(first->itemAt(1)->widget())->setWordWrap(false);
        rows->addLayout(first);
        auto* folder = new QLabel(this);
        folder->setProperty("role", "second");
        folder->setText(
            folder->fontMetrics().elidedText(folderText(bout.files), Qt::ElideMiddle, 400));
        rows->addWidget(folder);
        for (QLabel* each : findChildren<QLabel*>())
            each->setAttribute(Qt::WA_TransparentForMouseEvents);
        setFixedHeight(rows->sizeHint().height());
    }
};

}  // namespace

WelcomePage::WelcomePage(CommandTable& commands, QWidget* parent)
    : QWidget(parent), recent_(new QWidget(this)), list_(new QVBoxLayout(recent_)) {
    auto* page = new QWidget(this);
    auto* picture = new WelcomePicture(page);
    auto* column = new QWidget(page);
    column->setMinimumWidth(picture->sizeHint().width());
    column->setMaximumWidth(
        std::max(picture->sizeHint().width(), withTextSize(picture->sizeHint().width())));
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 16, 0, 16);
    layout->setSpacing(6);
    layout->addWidget(label(QStringLiteral("Kumite"), "title", column));
    layout->addWidget(label(tr("Cut a recorded bout into actions: both fighters in 3D over the "
                               "force that they exert against the ground. Its minima are the "
                               "boundaries; you correct the few that are wrong. Then say what a "
                               "few actions are, and the machine says it of the rest."),
                            "", column));
    layout->addSpacing(14);
    layout->addWidget(picture);
    layout->addSpacing(18);
    auto* below = new QHBoxLayout;
    below->setSpacing(32);
    auto* steps = new QVBoxLayout;
    steps->setSpacing(8);
    addSteps(commands, steps);
    below->addLayout(steps);
    recent_->setParent(column);
    below->addWidget(recent_, 1);
    layout->addLayout(below);

    list_->setContentsMargins(0, 0, 0, 0);
    list_->setSpacing(2);
    auto* across = new QHBoxLayout(page);
    across->addStretch(1);
    auto* down = new QVBoxLayout;
    down->addStretch(2);
    down->addWidget(column);
    down->addStretch(3);
    across->addLayout(down);
    across->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(page);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    refresh();
}

void WelcomePage::addSteps(CommandTable& commands, QVBoxLayout* column) {
    column->addWidget(label(tr("Begin"), "heading", this));
    bool first = true;
    for (const char* id :
         {"file.openDemo", "file.openRecordings", "file.openProject", "help.tour"}) {
        const Command* command = commands.find(QLatin1String(id));
        if (command == nullptr) continue;
        QAction* action = commands.action(command->id);
        auto* button = new QPushButton(command->plainText(), this);
        button->setProperty("role", first ? "step" : "");
        button->setMinimumHeight(34);
        button->setMinimumWidth(220);
        commands.tellKey(button, command->id);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        column->addWidget(button);
        addChoice(steps_, button);
        first = false;
    }
    column->addSpacing(2);
    auto* drop = label(tr("Or drop recordings (BVH, or AMC with its ASF) or a project on this "
                          "window."),
                       "second", this);
    drop->setMinimumWidth(220);
    column->addWidget(drop);
    column->addStretch(1);
    setFocusProxy(steps_.front());
}

void WelcomePage::addChoice(std::vector<QPushButton*>& column, QPushButton* button) {
    button->installEventFilter(this);
    column.push_back(button);
}

void WelcomePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    setFocus();
}

bool WelcomePage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return false;
    return pressKey(static_cast<QPushButton*>(watched), static_cast<QKeyEvent*>(event)->key());
}

/// Whether the key meant something.
bool WelcomePage::pressKey(QPushButton* button, int key) {
    const auto isIn = [button](const std::vector<QPushButton*>& column) {
        return std::find(column.begin(), column.end(), button) != column.end();
    };
    const bool inRecents = isIn(recents_);
    const std::vector<QPushButton*>& own = inRecents ? recents_ : steps_;
    const std::vector<QPushButton*>& other = inRecents ? steps_ : recents_;
    const auto count = static_cast<std::ptrdiff_t>(own.size());
    const auto row = std::find(own.begin(), own.end(), button) - own.begin();
    const auto go = [](QPushButton* to) { to->setFocus(Qt::TabFocusReason); };
    switch (key) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            button->click();
            return true;
        case Qt::Key_Up:
        case Qt::Key_Down: {
            const auto next = row + (key == Qt::Key_Down ? 1 : count - 1);
            go(own[static_cast<std::size_t>(next % count)]);
            return true;
        }
        case Qt::Key_Left:
        case Qt::Key_Right:
            if (inRecents != (key == Qt::Key_Left) || other.empty()) return true;
            go(other[std::min(static_cast<std::size_t>(row), other.size() - 1)]);
            return true;
        case Qt::Key_Home:
            go(own.front());
            return true;
        case Qt::Key_End:
            go(own.back());
            return true;
        default:
            return false;
    }
}

void WelcomePage::refresh() {
    recents_.clear();
    while (QLayoutItem* item = list_->takeAt(0)) {
        // One of the buttons may be on its way back from a click.
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    list_->addWidget(label(tr("Opened lately"), "heading", recent_));
    const auto bouts = recentBouts();
    for (const RecentBout& bout : bouts.mid(0, kMostRecent)) {
        auto* button = new RecentButton(bout, recent_);
        connect(button, &QPushButton::clicked, this,
                [this, files = bout.files] { Q_EMIT chosen(files); });
        list_->addWidget(button);
        addChoice(recents_, button);
    }
    if (bouts.isEmpty()) {
        list_->addWidget(label(tr("Projects and recordings that you open appear here, with the "
                                  "day and the folder."),
                               "second", recent_));
    }
    list_->addStretch(1);
}

}  // namespace kumite::studio
