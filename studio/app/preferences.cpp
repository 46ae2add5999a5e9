#include "studio/app/preferences.h"

#include <QSettings>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

namespace {

PreferenceValues inRange(PreferenceValues values) {
    const PreferenceValues fallback;
    const auto sane = [](double value, double low, double high, double otherwise) {
        return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
    };
    const auto theme = static_cast<int>(values.theme);
    values.theme = static_cast<ThemeChoice>(std::clamp(theme, 0, 2));
    values.textSize = std::clamp(values.textSize, 100, 200);
    values.autosaveSeconds = std::clamp(values.autosaveSeconds, 5, 600);
    values.leapFrames = std::clamp(values.leapFrames, 2, 1000);
    values.playbackSpeed = sane(values.playbackSpeed, 0.1, 4, fallback.playbackSpeed);
    values.mouseSpeed = sane(values.mouseSpeed, 0.25, 4, fallback.mouseSpeed);
    return values;
}

}  // namespace

Preferences::Preferences(QObject* parent) : QObject(parent) {
    const QSettings settings;
    PreferenceValues v;
    v.theme = static_cast<ThemeChoice>(settings.value("theme", static_cast<int>(v.theme)).toInt());
    v.textSize = settings.value("textSize", v.textSize).toInt();
    v.reduceMotion = settings.value("reduceMotion", v.reduceMotion).toBool();
    v.language = settings.value("language").toString();
    v.autosaveSeconds = settings.value("autosaveSeconds", v.autosaveSeconds).toInt();
    v.leapFrames = settings.value("leapFrames", v.leapFrames).toInt();
    v.playbackSpeed = settings.value("playbackSpeed", v.playbackSpeed).toDouble();
    v.looping = settings.value("looping", v.looping).toBool();
    v.mouseSpeed = settings.value("mouseSpeed", v.mouseSpeed).toDouble();
    values_ = inRange(v);
}

void Preferences::set(PreferenceValues values) {
    values = inRange(values);
    if (values == values_) return;
    values_ = values;
    QSettings settings;
    settings.setValue("language", values.language);
    settings.setValue("theme", static_cast<int>(values.theme));
    settings.setValue("textSize", values.textSize);
    settings.setValue("reduceMotion", values.reduceMotion);
    settings.setValue("autosaveSeconds", values.autosaveSeconds);
    settings.setValue("leapFrames", values.leapFrames);
    settings.setValue("playbackSpeed", values.playbackSpeed);
    settings.setValue("looping", values.looping);
    settings.setValue("mouseSpeed", values.mouseSpeed);
    Q_EMIT changed();
}

void Preferences::setTheme(ThemeChoice choice) {
    PreferenceValues values = values_;
    values.theme = choice;
    set(values);
}

}  // namespace kumite::studio
