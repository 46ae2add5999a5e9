#pragma once

#include <QObject>

#include "studio/app/theme.h"

namespace kumite::studio {

/// What a user wants of every project.
struct PreferenceValues {
    ThemeChoice theme = ThemeChoice::System;
    int textSize = 100;          ///< percent of the platform's; 100 … 200
    bool reduceMotion = false;   ///< nothing begins to move by itself
    int autosaveSeconds = 30;    ///< 5 … 600
    int leapFrames = 10;         ///< frames that Shift+arrow goes; 2 … 1000
    double playbackSpeed = 1.0;  ///< of a bout that is opened; 0.1 … 4
    bool looping = false;        ///< whether a bout that is opened loops
    double mouseSpeed = 1.0;     ///< turning and zooming in the 3D view; 0.25 … 4
    QString language = {};       ///< as useLanguage takes it; empty: the system's

    bool operator==(const PreferenceValues&) const = default;
};

/// The preferences in force, kept in the user's settings.
class Preferences : public QObject {
    Q_OBJECT

public:
    /// As the last run left them; values out of range are brought into it.
    explicit Preferences(QObject* parent = nullptr);

    const PreferenceValues& values() const { return values_; }
    /// In force and kept at once.
    void set(PreferenceValues values);
    void setTheme(ThemeChoice choice);

Q_SIGNALS:
    void changed();

private:
    PreferenceValues values_;
};

}  // namespace kumite::studio
