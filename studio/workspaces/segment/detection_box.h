#pragma once

#include <QWidget>

#include <optional>

#include "core/project/project.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace kumite::studio {

class Session;
class ValueField;

/// Fields for the settings by which streams are cut.
class SettingsFields : public QWidget {
    Q_OBJECT

public:
    /// `suffix` is added to the fields' names: " B".
    SettingsFields(const QString& suffix, QWidget* parent);

    SegmentationSettings settings() const;
    void show(const SegmentationSettings& settings);
    bool isDragged() const;

Q_SIGNALS:
    void chosen();
    void released();

private:
    ValueField* cutoff_;
    ValueField* prominence_;
    QComboBox* curve_;
};

/// How streams are cut: the project's settings, which act while a slider moves and are one step of
/// the history per drag, and a warning where the cutoff smooths nothing.
class DetectionBox : public QWidget {
    Q_OBJECT

public:
    explicit DetectionBox(Session& session, QWidget* parent);

private:
    void choose();
    void act();
    void showSettings();
    void showFindings();

    Session& session_;
    SettingsFields* fields_;
    QLabel* warning_;
    std::optional<SegmentationSettings> waiting_;  ///< chosen while values are still computed
};

}  // namespace kumite::studio
