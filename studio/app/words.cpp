#include "studio/app/words.h"

#include <QCoreApplication>

#include <cmath>

#include "studio/app/project_guard.h"

namespace kumite::studio {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("kumite", text);
}

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

QString reasonText(const SuspectReason& reason) {
    using Kind = SuspectReason::Kind;
    const QString prominence = words("prominence %1").arg(bodyWeightsText(reason.prominence));
    const QString speed = QString::number(reason.footSpeed, 'f', 1);
    switch (reason.kind) {
        case Kind::SlowKick:
            return (reason.left ? words("slow left kick, %1") : words("slow right kick, %1"))
                .arg(prominence);
        case Kind::MovingFoot:
            return (reason.left ? words("left foot moves at %1 m/s, %2")
                                : words("right foot moves at %1 m/s, %2"))
                .arg(speed, prominence);
        case Kind::Shallow:
            return words("shallow, %1").arg(prominence);
        case Kind::Crowded:
            return words("%1 s from the next minimum, %2")
                .arg(QString::number(reason.nearest, 'f', 2), prominence);
        case Kind::High:
            return words("hardly dips (to %1), %2").arg(bodyWeightsText(reason.force), prominence);
        case Kind::Unremarkable:
            break;
    }
    return words("nothing unusual, %1").arg(prominence);
}

QString shortReasonText(const SuspectReason& reason) {
    using Kind = SuspectReason::Kind;
    switch (reason.kind) {
        case Kind::SlowKick:
            return reason.left ? words("left kick") : words("right kick");
        case Kind::MovingFoot:
            return reason.left ? words("left foot") : words("right foot");
        case Kind::Shallow:
            return words("shallow");
        case Kind::Crowded:
            return words("crowded");
        case Kind::High:
            return words("hardly dips");
        case Kind::Unremarkable:
            break;
    }
    return QStringLiteral("–");
}

QString suspicionText(const FighterAnalysis& fighter, const BoundaryMark& mark) {
    return words("%1, suspicion %2")
        .arg(reasonText(suspectReason(fighter, *mark.minimum)), percentText(mark.suspicion));
}

QString correctionWords(const Correction& correction, const Fighter& fighter) {
    const auto at = [&](int frame) { return timeText(timeOfFrame(fighter, frame)); };
    switch (correction.kind) {
        case Correction::Kind::Remove:
            return words("removal at %1").arg(at(correction.frame));
        case Correction::Kind::Add:
            return words("addition at %1").arg(at(correction.frame));
        case Correction::Kind::Move:
            return words("move from %1 to %2").arg(at(correction.frame), at(correction.to));
        case Correction::Kind::Keep:
            return words("acceptance at %1").arg(at(correction.frame));
    }
    return {};
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
