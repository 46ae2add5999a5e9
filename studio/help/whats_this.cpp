#include "studio/help/whats_this.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QCoreApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QToolButton>

#include "studio/app/commands.h"
#include "studio/help/topics.h"

namespace kumite::studio {

namespace {

/// "&Keep (Return)" → "Keep": marks and keys have no place in a title.
QString plain(QString text) {
    return text.remove(QLatin1Char('&')).simplified();
}

/// The command that a widget runs; null without one.
const Command* commandOf(const QWidget& widget, const CommandTable& commands) {
    QString id = widget.property("command").toString();
    const auto* tool = qobject_cast<const QToolButton*>(&widget);
    if (tool != nullptr && tool->defaultAction() != nullptr)
        id = tool->defaultAction()->objectName();
    return id.isEmpty() ? nullptr : commands.find(id);
}

QString nameOf(const QWidget& widget) {
    if (!widget.accessibleName().isEmpty()) return plain(widget.accessibleName());
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return button != nullptr ? plain(button->text()) : QString();
}

QString tipOf(const QWidget& widget) {
    QStringList tips = {widget.toolTip(), widget.accessibleDescription()};
    tips.removeAll(QString());
    tips.removeDuplicates();
    if (!tips.isEmpty()) return tips.join(QLatin1Char('\n'));
    // The rows of a list have tips of their own.
    const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
    if (view == nullptr || view->model() == nullptr) return {};
    return view->model()->index(0, 0).data(Qt::ToolTipRole).toString();
}

QString paragraph(const QString& html) {
    return html.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(html);
}

QString escaped(const QString& text) {
    return text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
}

}  // namespace

QString whatsThisOf(const QWidget& widget, const CommandTable& commands) {
    const Command* command = commandOf(widget, commands);
    const QString name =
        command != nullptr && nameOf(widget).isEmpty() ? command->plainText() : nameOf(widget);
    QString tip = tipOf(widget);
    const QString keys = command != nullptr ? command->keysText() : QString();
    // A tip that says the name and the key again says nothing.
    if (command != nullptr &&
        (tip == commands.action(command->id)->toolTip() || tip.startsWith(name + " (")))
        tip = command->plainText() == name ? QString() : command->plainText();
    const QStringList topics = topicsOf(widget);
    if (name.isEmpty() && tip.isEmpty() && topics.isEmpty()) return {};
    // What is only laid out between the numbers of a panel is none of them.
    const bool shows = qobject_cast<const QLabel*>(&widget) != nullptr || !name.isEmpty();
    if (!shows && tip.isEmpty()) return {};

    QString text;
    if (!name.isEmpty()) text += paragraph(QStringLiteral("<b>%1</b>").arg(escaped(name)));
    text += paragraph(escaped(tip));
    if (!keys.isEmpty())
        text += paragraph(QCoreApplication::translate("WhatsThis", "Key: %1").arg(escaped(keys)));
    for (const QString& place : topics) {
        const bool first = place == topics.front();
        const QString link =
            QStringLiteral("<a href=\"help:%1\">%2</a>").arg(place, escaped(topicTitle(place)));
        text += paragraph(first ? link + QStringLiteral("<br>") + topicSummary(place) : link);
    }
    return text;
}

}  // namespace kumite::studio
