#include "studio/help/help.h"

#include <QApplication>
#include <QDesktopServices>
#include <QHelpEvent>
#include <QUrl>
#include <QWhatsThis>
#include <QWhatsThisClickedEvent>
#include <QWidget>

#include "studio/app/commands.h"
#include "studio/app/main_window.h"
#include "studio/app/questions.h"
#include "studio/app/workspaces.h"
#include "studio/help/help_pages.h"
#include "studio/help/help_window.h"
#include "studio/help/tour.h"
#include "studio/help/whats_this.h"

namespace kumite::studio {

namespace {

/// The page for a window beside the main one, by its class.
QString pageFor(const QWidget& window) {
    const QString name = QString::fromLatin1(window.metaObject()->className());
    const auto is = [&](const char* kind) { return name.endsWith(QLatin1String(kind)); };
    if (is("ImportDialog") || is("FighterProperties") || is("FindingsPage"))
        return QStringLiteral("importing");
    if (is("KeysPage") || is("PreferencesDialog")) return QStringLiteral("keys");
    if (is("RecoveryDialog") || is("VersionsDialog")) return QStringLiteral("files");
    return {};
}

}  // namespace

Help::Help(MainWindow& window) : QObject(&window), window_(window), tour_(new Tour(window)) {
    qApp->installEventFilter(this);
}

Help::~Help() {
    qApp->removeEventFilter(this);
}

void Help::addCommands(CommandTable& commands, const QString& menu) {
    const QString group = QLatin1Char('-') + menu;
    commands.add({"help.open", menu, tr("&Help on this workspace"), {QKeySequence("F1")}, [this] {
                      openHere();
                  }});
    commands.add({"help.first", menu, tr("&First steps"), {}, [this] { open("first_steps"); }});
    commands.add(
        {"help.method", menu, tr("What the &numbers mean"), {}, [this] { open("method"); }});
    tour_->addCommands(commands, menu);
    commands.add(
        {"help.whatsThis", group, tr("&What is this? Click on it"), {QKeySequence("Shift+F1")}, [] {
             QWhatsThis::enterWhatsThisMode();
         }});
    commands.add(
        {"help.describe", menu, tr("What has the f&ocus?"), {QKeySequence("Alt+F1")}, [this] {
             describeFocus();
         }});
    commands.add({"help.keys", menu, tr("&Keys and mouse"), {QKeySequence("Ctrl+F1")}, [this] {
                      window_.showKeys();
                  }});
    commands.add({"help.changes", group, tr("What is n&ew"), {}, [this] { open("changes"); }});
    commands.add({"help.about", menu, tr("&About Kumite"), {}, [this] {
                      notify(&window_, tr("About Kumite"),
                             tr("Kumite %1\n\nA studio for annotating two-player martial-arts "
                                "motion capture.")
                                 .arg(QApplication::applicationVersion()));
                  }});
}

void Help::open(const QString& place) {
    if (page_.isNull()) {
        page_ = new HelpWindow(window_.commands(), &window_);
        page_->setAttribute(Qt::WA_DeleteOnClose);
        connect(page_, &HelpWindow::followed, this, &Help::follow);
    }
    page_->showPage(place);
    page_->show();
    page_->raise();
    page_->activateWindow();
}

void Help::openHere() {
    const bool any = window_.session().document().isOpen();
    open(any ? window_.workspaces().current() : QStringLiteral("first_steps"));
}

void Help::describeFocus() {
    const QWidget* focused = QApplication::focusWidget();
    for (const QWidget* at = focused; at != nullptr; at = at->parentWidget()) {
        const QString text = whatsThisOf(*at, window_.commands());
        if (text.isEmpty()) continue;
        const QPoint below(0, at->height());
        QWhatsThis::showText(at->mapToGlobal(below), text, const_cast<QWidget*>(at));
        return;
    }
}

void Help::follow(const QUrl& link) {
    if (link.scheme() == QLatin1String("command")) {
        if (window_.commands().find(link.path()) != nullptr) window_.commands().run(link.path());
    } else if (link.scheme() == QLatin1String("help")) {
        open(link.toString().section(QLatin1Char(':'), 1));
    } else {
        QDesktopServices::openUrl(link);
    }
}

bool Help::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr) return false;
    const bool ours = widget->window() == &window_ || widget->window()->parentWidget() == &window_;
    if (!ours) return false;
    switch (event->type()) {
        case QEvent::QueryWhatsThis:
        case QEvent::WhatsThis: {
            const QString text = whatsThisOf(*widget, window_.commands());
            // Its parent may know.
            if (text.isEmpty()) return false;
            event->accept();
            if (event->type() == QEvent::WhatsThis)
                QWhatsThis::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, widget);
            return true;
        }
        case QEvent::WhatsThisClicked:
            follow(QUrl(static_cast<QWhatsThisClickedEvent*>(event)->href()));
            return true;
        case QEvent::KeyPress: {
            const auto* key = static_cast<QKeyEvent*>(event);
            const QString page = pageFor(*widget->window());
            if (key->key() != Qt::Key_F1 || key->modifiers() != Qt::NoModifier || page.isEmpty())
                return false;
            open(page);
            return true;
        }
        default:
            return false;
    }
}

}  // namespace kumite::studio
