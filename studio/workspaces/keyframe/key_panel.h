#pragma once

#include <QStackedWidget>

#include <functional>

class QHBoxLayout;
class QLabel;
class QTabWidget;

namespace kumite::studio {

class CommandTable;
class HitSession;
class KeySession;

/// The Keyframe workspace's panel: the chosen key's pose and the motion that the keys become, or
/// the hit tool; or
/// what to do where there is nothing to make it of.
class KeyPanel : public QStackedWidget {
    Q_OBJECT

public:
    KeyPanel(KeySession& keys, HitSession& hit, QWidget* parent = nullptr);

    /// Buttons that run commands of the table.
    void addCommands(CommandTable& commands);
    /// Offers a step where there is nothing.
    void addStep(const QString& text, const QString& tip, std::function<void()> run);

private:
    void refresh();

    KeySession& keys_;
    HitSession& hit_;
    QStackedWidget* tools_;  ///< keys, or the hit tool
    QTabWidget* pages_;      ///< of the keys
    QHBoxLayout* buttons_;
    QWidget* empty_;
    QWidget* full_;
    QLabel* why_;
};

}  // namespace kumite::studio
