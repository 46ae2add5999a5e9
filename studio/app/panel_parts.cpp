#include "studio/app/panel_parts.h"

#include <QAction>
#include <QLabel>
#include <QToolButton>

#include "studio/app/commands.h"

namespace kumite::studio {

QLabel* headingLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "heading");
    return label;
}

QToolButton* iconButton(CommandTable& commands, const char* command, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(commands.action(QLatin1String(command)));
    button->setAccessibleName(button->defaultAction()->text());
    button->setFocusPolicy(Qt::TabFocus);
    button->setIconSize({16, 16});
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    return button;
}

void showAsClock(QLabel* label, const QString& name) {
    QFont large = label->font();
    large.setPointSizeF(large.pointSizeF() + 2);
    label->setFont(large);
    label->setMinimumWidth(QFontMetrics(large).horizontalAdvance(QStringLiteral("00:00.000")));
    label->setAccessibleName(name);
}

}  // namespace kumite::studio
