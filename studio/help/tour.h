#pragma once

#include <QObject>
#include <QTimer>

#include <functional>
#include <vector>

#include "core/segmentation/corrections.h"

class QFrame;
class QWidget;

namespace kumite::studio {

class CommandTable;
class MainWindow;
class TourBox;

/// A step of the tour.
struct TourStep {
    QString title;
    std::function<QString()> text;  ///< rich text; names the keys in force
    QString workspace;
    std::function<QWidget*()> target;  ///< what the box points at
    std::function<void()> begin;       ///< remembers how things are
    std::function<bool()> isDone;
    QString helpText = {};  ///< of a button that does the dull part; none: there is none
    std::function<void()> help = {};
};

/// Five steps of the real job on the demo bout, in a box that lets the window go on: a suspect, a
/// label, what the machine proposes, the graph, a bout. Each step notes when it was done; nobody
/// has to.
class Tour : public QObject {
    Q_OBJECT

public:
    explicit Tour(MainWindow& window);

    /// The entries of the menu.
    void addCommands(CommandTable& commands, const QString& menu);

    /// From the first step; opens the demo bout if it is not open.
    void start();
    void leave();
    bool isRunning() const { return at_ >= 0; }

    const std::vector<TourStep>& steps() const { return steps_; }
    /// -1 while it does not run.
    int step() const { return at_; }
    bool isDone(int step) const { return done_[static_cast<std::size_t>(step)]; }
    /// Forward (+1) or back (-1); forward from the last step leaves.
    void go(int direction);
    TourBox& box() { return *box_; }

private:
    void addSteps();
    void listen();
    bool showsDemo() const;
    void begin();
    void show(int step);
    void check();
    void place();
    void labelSome();
    QString key(const char* command) const;
    std::vector<Correction> corrections() const;

    MainWindow& window_;
    std::vector<TourStep> steps_;
    std::vector<bool> done_;
    int at_ = -1;
    bool wanted_ = false;     ///< the demo bout is being opened for it
    TourBox* box_ = nullptr;  ///< of the window, as the mark is; made when it is first needed
    QFrame* mark_ = nullptr;
    QTimer placing_;
    // How things were when the step began.
    std::vector<Correction> corrected_;
    int byHand_ = 0;
    int accepted_ = 0;
    bool looked_ = false;
};

}  // namespace kumite::studio
