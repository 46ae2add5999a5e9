#include "studio/app/theme.h"

#include <QApplication>
#include <QFont>
#include <QStyleFactory>

#include <algorithm>

#include "studio/app/comfort.h"

namespace kumite::studio {

namespace {

std::optional<bool>& desktopDark() {
    static std::optional<bool> dark;
    return dark;
}

QPalette paletteOf(const Colours& c) {
    QPalette palette;
    palette.setColor(QPalette::Window, c.panel);
    palette.setColor(QPalette::WindowText, c.text);
    palette.setColor(QPalette::Base, c.dark ? c.ground : c.panel);
    palette.setColor(QPalette::AlternateBase, c.ground);
    palette.setColor(QPalette::Text, c.text);
    palette.setColor(QPalette::PlaceholderText, c.secondText);
    palette.setColor(QPalette::Button, c.panel);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::BrightText, c.accent);
    palette.setColor(QPalette::ToolTipBase, c.panel);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::Link, c.text);
    palette.setColor(QPalette::Highlight, mixed(c.panel, c.accent, c.dark ? 0.28 : 0.32));
    palette.setColor(QPalette::HighlightedText, c.text);
    palette.setColor(QPalette::Light, c.panel.lighter(110));
    palette.setColor(QPalette::Midlight, c.line);
    palette.setColor(QPalette::Mid, c.line);
    palette.setColor(QPalette::Dark, c.line);
    palette.setColor(QPalette::Shadow, c.line);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, mixed(c.secondText, c.panel, 0.45));
    }
    return palette;
}

QString styleSheetOf(const Colours& c) {
    QString sheet = QStringLiteral(R"(
QMainWindow, QDialog { background: @panel; }
QMenuBar { background: @panel; border-bottom: 1px solid @line; padding: 1px 4px; }
QMenuBar::item { padding: 5px 8px; background: transparent; border-radius: 3px; }
QMenuBar::item:selected { background: @hover; }
QMenu { background: @panel; border: 1px solid @line; padding: 4px 0; }
QMenu::item { padding: 4px 28px 4px 24px; }
QMenu::item:selected { background: @hover; }
QMenu::item:disabled { color: @faint; }
QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }
QStatusBar { background: @panel; border-top: 1px solid @line; color: @second; }
QStatusBar::item { border: none; }
QToolTip { background: @panel; color: @text; border: 1px solid @line; padding: 3px 6px; }
QSplitter::handle { background: @line; }
QTabBar::tab { background: transparent; border: none; border-bottom: 2px solid transparent;
    padding: 5px 12px; color: @second; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
QTabBar::tab:hover { color: @text; }
QTabBar:focus { border: none; }
QTabWidget::pane { border: none; border-top: 1px solid @line; }
QLabel[role="heading"] { color: @second; font-weight: 600; }
QLabel[role="second"] { color: @second; }
QLabel[role="title"] { font-size: @titlept; font-weight: 300; }
QPushButton { background: @button; border: 1px solid @line; border-radius: 4px;
    padding: 4px 12px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed { background: @line; }
QPushButton:focus { border: 1px solid @accent; }
QPushButton:disabled { color: @faint; background: @panel; }
QPushButton[role="step"] { border: 1px solid @accent; padding: 6px 16px; }
QPushButton[role="recent"] { border: 1px solid transparent; background: transparent;
    text-align: left; padding: 0; }
QPushButton[role="recent"]:hover { background: @hover; }
QPushButton[role="recent"]:focus { border: 1px solid @accent; }
QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 3px; }
QToolButton[role="small"] { padding: 1px; }
QToolButton[role="small"][text] { padding: 1px 6px; color: @second; }
QToolButton:hover { background: @hover; }
QToolButton:checked { background: @hover; border: 1px solid @line; }
QToolButton[role="workspace"] { border-bottom: 2px solid transparent; padding-bottom: 2px; }
QToolButton[role="workspace"]:hover { background: transparent; border-color: @line; }
QToolButton[role="workspace"]:checked { background: @hover; border-bottom: 2px solid @accent; }
QToolButton:focus { border: 1px solid @accent; }
QAbstractItemView { background: @panel; border: 1px solid transparent; outline: none;
    selection-background-color: @chosen; selection-color: @text; }
QAbstractItemView:focus { border: 1px solid @accent; }
QAbstractItemView::item { padding: 2px 3px; border: none; }
QAbstractItemView::item:hover { background: @hover; }
QAbstractItemView::item:selected { background: @chosen; color: @text; }
QHeaderView::section { background: @panel; color: @second; border: none;
    border-bottom: 1px solid @line; padding: 2px 4px; font-weight: normal; }
QLineEdit, QAbstractSpinBox, QComboBox { background: @field; border: 1px solid @line;
    border-radius: 4px; padding: 2px 6px; min-height: 18px; selection-background-color: @select;
    selection-color: @text; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border: 1px solid @accent; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 0; border: none; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid @faint; border-radius: 3px;
    background: @field; }
QCheckBox::indicator:checked { background: @accent; border: 1px solid @accent;
    image: url(:/icons/check.svg); }
QCheckBox::indicator:focus { border: 1px solid @accent; }
QComboBox::drop-down { border: none; width: 18px; }
QComboBox::down-arrow { image: url(:/icons/chevron_down.svg); width: 12px; height: 12px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QComboBox QAbstractItemView { border: 1px solid @line; }
QProgressBar { background: @field; border: 1px solid @line; border-radius: 3px; height: 10px;
    text-align: center; }
QProgressBar::chunk { background: @accent; border-radius: 2px; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 8px; margin: 0; }
QScrollBar::handle { background: @line; border-radius: 3px; min-height: 24px; min-width: 24px; }
QScrollBar::handle:hover { background: @second; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QFrame[role="strip"] { background: @panel; border: 1px solid @line; border-radius: 6px; }
QFrame[role="focus"] { background: transparent; border: 1px solid @accent; }
QFrame[role="tour"] { background: @panel; border: 1px solid @accent; border-radius: 6px; }
QFrame[role="tourMark"] { background: transparent; border: 2px solid @accent;
    border-radius: 3px; }
QFrame[role="separator"] { background: @line; border: none; }
)");
    const auto put = [&sheet](const char* name, const QColor& colour) {
        sheet.replace(QLatin1String(name), colour.name());
    };
    sheet.replace(QLatin1String("@title"), QString::number(withTextSize(20)));
    put("@panel", c.panel);
    put("@line", c.line);
    put("@text", c.text);
    put("@second", c.secondText);
    put("@accent", c.accent);
    put("@field", c.dark ? c.ground : c.panel);
    put("@button", c.dark ? mixed(c.panel, c.line, 0.5) : c.ground);
    put("@hover", mixed(c.panel, c.line, 0.55));
    put("@select", mixed(c.panel, c.accent, c.dark ? 0.28 : 0.32));
    put("@chosen", mixed(c.panel, c.line, 0.9));
    put("@faint", mixed(c.secondText, c.panel, 0.45));
    return sheet;
}

/// The size of text at 100 %, points; gives the style on the way.
double giveStyle() {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const double points = QApplication::font().pointSizeF();
    return points > 0 ? std::clamp(points, 9.0, 10.0) : 10.0;
}

void giveFont(double points) {
    QFont font = QApplication::font();
    if (font.pointSizeF() == points) return;
    font.setPointSizeF(points);
    QApplication::setFont(font);
}

}  // namespace

const Colours& colours(bool dark) {
    static const Colours darkColours{true,
                                     QColor("#1e1f22"),
                                     QColor("#26282c"),
                                     QColor("#34373d"),
                                     QColor("#e8e8e8"),
                                     QColor("#9aa0a8"),
                                     QColor("#ffb000"),
                                     {QColor("#d55e00"), QColor("#56b4e9")},
                                     {QColor("#ee7f2d"), QColor("#56b4e9")}};
    static const Colours lightColours{false,
                                      QColor("#f6f6f7"),
                                      QColor("#ffffff"),
                                      QColor("#d9dbe0"),
                                      QColor("#1e1f22"),
                                      QColor("#5b6068"),
                                      QColor("#ffb000"),
                                      {QColor("#d55e00"), QColor("#56b4e9")},
                                      {QColor("#b85000"), QColor("#1b74a9")}};
    return dark ? darkColours : lightColours;
}

const Colours& coloursFor(const QPalette& palette) {
    return colours(palette.color(QPalette::Window).lightness() < 128);
}

void setSystemDark(std::optional<bool> dark) {
    desktopDark() = dark;
}

void applyTheme(ThemeChoice choice) {
    static const bool platformIsDark =
        QApplication::palette().color(QPalette::Window).lightness() < 128;
    const bool systemIsDark = desktopDark().value_or(platformIsDark);
    const bool dark =
        choice == ThemeChoice::Dark || (choice == ThemeChoice::System && systemIsDark);
    // Each is given to every widget anew: only where it is another one.
    static const double points = giveStyle();
    giveFont(points * textSize() / 100);
    QApplication::setPalette(paletteOf(colours(dark)));
    qApp->setStyleSheet(styleSheetOf(colours(dark)));
}

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int from, int to) {
        return static_cast<int>(from + (to - from) * share + 0.5);
    };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

QColor withAlpha(QColor colour, double alpha) {
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

}  // namespace kumite::studio
