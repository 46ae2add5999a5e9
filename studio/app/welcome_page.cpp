#include "studio/app/welcome_page.h"

#include <QAction>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <string_view>

#include "studio/app/commands.h"
#include "studio/app/icons.h"
#include "studio/app/recent_files.h"

namespace kumite::studio {

namespace {

QLabel* label(const QString& text, const char* role, QWidget* parent) {
    auto* made = new QLabel(text, parent);
    made->setProperty("role", role);
    made->setWordWrap(true);
    return made;
}

}  // namespace

WelcomePage::WelcomePage(CommandTable& commands, QWidget* parent)
    : QWidget(parent), recent_(new QWidget(this)), list_(new QVBoxLayout(recent_)) {
    auto* column = new QWidget(this);
    column->setFixedWidth(520);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    auto* picture = new QLabel(column);
    picture->setPixmap(applicationIcon().pixmap(64, 64));
    layout->addWidget(picture);
    layout->addSpacing(8);
    layout->addWidget(label(QStringLiteral("Kumite"), "title", column));
    layout->addWidget(label(tr("Cut a recorded bout into actions: both fighters in 3D over the "
                               "curves of the force that they exert against the ground."),
                            "", column));
    layout->addSpacing(16);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (const char* command : {"file.openRecordings", "file.openProject"}) {
        QAction* action = commands.action(QLatin1String(command));
        QString text = action->text();
        text.remove(QLatin1Char('&'));
        auto* button = new QPushButton(text, column);
        button->setProperty("role",
                            command == std::string_view("file.openRecordings") ? "step" : "");
        button->setMinimumHeight(34);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    layout->addLayout(buttons);
    layout->addSpacing(4);
    layout->addWidget(label(tr("Or drop one or two recordings (BVH, or AMC with its ASF), or a "
                               "project, on this window."),
                            "second", column));
    layout->addSpacing(20);
    list_->setContentsMargins(0, 0, 0, 0);
    list_->setSpacing(2);
    layout->addWidget(recent_);

    auto* across = new QHBoxLayout(this);
    across->addStretch(1);
    auto* down = new QVBoxLayout;
    down->addStretch(2);
    down->addWidget(column);
    down->addStretch(3);
    across->addLayout(down);
    across->addStretch(1);
    refresh();
}

void WelcomePage::refresh() {
    while (QLayoutItem* item = list_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const auto entries = recentFiles();
    recent_->setVisible(!entries.isEmpty());
    if (entries.isEmpty()) return;
    list_->addWidget(label(tr("Opened lately"), "heading", recent_));
    for (const QStringList& files : entries.mid(0, 5)) {
        auto* button = new QPushButton(recentText(files), recent_);
        button->setStyleSheet(QStringLiteral(
            "text-align: left; border: none; background: transparent; padding: 4px 0;"));
        button->setCursor(Qt::PointingHandCursor);
        button->setToolTip(files.join(QLatin1Char('\n')));
        connect(button, &QPushButton::clicked, this, [this, files] { Q_EMIT chosen(files); });
        list_->addWidget(button);
    }
}

}  // namespace kumite::studio
