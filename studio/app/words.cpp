#include "studio/app/words.h"

#include <QCoreApplication>

#include <cmath>

#include "studio/app/project_guard.h"

namespace kumite::studio {

namespace {

QString clockText(double seconds, int decimals) {
    const double unit = std::pow(10.0, decimals);
    const auto ticks = static_cast<long long>(std::llround(std::abs(seconds) * unit));
    const auto perMinute = static_cast<long long>(60 * unit);
    const int width = decimals > 0 ? 3 + decimals : 2;
    const QString rest =
        QString::number(static_cast<double>(ticks % perMinute) / unit, 'f', decimals)
            .rightJustified(width, QLatin1Char('0'));
    const QString sign = seconds < 0 && ticks != 0 ? QStringLiteral("−") : QString();
    return sign + QString::number(ticks / perMinute) + QLatin1Char(':') + rest;
}

}  // namespace

QString timeText(double seconds) {
    return clockText(seconds, 3);
}

QString timeText(double seconds, double step) {
    int decimals = 0;
    while (decimals < 3 && std::abs(step - std::round(step)) > 1e-9) {
        step *= 10;
        ++decimals;
    }
    return clockText(seconds, decimals);
}

QString bodyWeightsText(double bodyWeights) {
    return QString::number(bodyWeights, 'f', 2) + QStringLiteral(" BW");
}

QString percentText(double share) {
    return QString::number(qRound(share * 100)) + QStringLiteral(" %");
}

QString fighterText(int player) {
    return QCoreApplication::translate("kumite", "fighter %1").arg(player + 1);
}

QString momentText(const QDateTime& moment, bool seconds) {
    const QString time =
        moment.time().toString(seconds ? QStringLiteral("HH:mm:ss") : QStringLiteral("HH:mm"));
    const QDate today = QDate::currentDate();
    if (moment.date() == today) {
        return QCoreApplication::translate("words", "today %1").arg(time);
    }
    if (moment.date() == today.addDays(-1)) {
        return QCoreApplication::translate("words", "yesterday %1").arg(time);
    }
    return moment.date().toString(Qt::ISODate) + QLatin1Char(' ') + time;
}

QString holderText(const LockHolder& holder) {
    return QCoreApplication::translate("words", "Computer %1, process %2, since %3.")
        .arg(holder.host)
        .arg(holder.process)
        .arg(momentText(holder.since));
}

QString editsText(int edits) {
    return edits == 1 ? QCoreApplication::translate("words", "1 edit")
                      : QCoreApplication::translate("words", "%1 edits").arg(edits);
}

}  // namespace kumite::studio
