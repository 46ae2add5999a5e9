#include "studio/app/words.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>
#include <map>

#include "studio/app/project_guard.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::Words)
};

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

/// The language names keys: only their codes tell which is which.
QString withSign(const QKeySequence& key, const std::map<int, QChar>& signs) {
    QString text = key.toString(QKeySequence::NativeText);
    if (key.isEmpty()) return text;
    const auto sign = signs.find(key[0].key());
    if (sign == signs.end()) return text;
    const QString name = QKeySequence(key[0].key()).toString(QKeySequence::NativeText);
    return text.chopped(name.size()) + sign->second;
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
    return numberText(bodyWeights, 2) + QStringLiteral(" BW");
}

QString percentText(double share) {
    return Words::tr("%1 %").arg(qRound(share * 100));
}

QString numberText(double number, int decimals) {
    return QLocale().toString(number, 'f', decimals);
}

QString numberText(double number) {
    return QLocale().toString(number, 'g', 6);
}

QString keyText(const QKeySequence& key) {
    return withSign(key, {{Qt::Key_Left, QChar(u'←')},
                          {Qt::Key_Right, QChar(u'→')},
                          {Qt::Key_Up, QChar(u'↑')},
                          {Qt::Key_Down, QChar(u'↓')}});
}

QString keySigns(const QKeySequence& key) {
    const QString shift =
        QKeySequence(Qt::SHIFT | Qt::Key_A).toString(QKeySequence::NativeText).chopped(1);
    const bool answers =
        !key.isEmpty() && (key[0].key() == Qt::Key_Backspace || key[0].key() == Qt::Key_Return);
    return (answers
                ? withSign(key, {{Qt::Key_Backspace, QChar(u'⌫')}, {Qt::Key_Return, QChar(u'⏎')}})
                : keyText(key))
        .replace(shift, QStringLiteral("⇧"));
}

QString reasonText(const SuspectReason& reason) {
    using Kind = SuspectReason::Kind;
    const QString prominence = Words::tr("prominence %1").arg(bodyWeightsText(reason.prominence));
    const QString speed = numberText(reason.footSpeed, 1);
    switch (reason.kind) {
        case Kind::SlowKick:
            return (reason.left ? Words::tr("slow left kick, %1")
                                : Words::tr("slow right kick, %1"))
                .arg(prominence);
        case Kind::MovingFoot:
            return (reason.left ? Words::tr("left foot moves at %1 m/s, %2")
                                : Words::tr("right foot moves at %1 m/s, %2"))
                .arg(speed, prominence);
        case Kind::Shallow:
            return Words::tr("shallow, %1").arg(prominence);
        case Kind::Crowded:
            return Words::tr("%1 s from the next minimum, %2")
                .arg(numberText(reason.nearest, 2), prominence);
        case Kind::High:
            return Words::tr("hardly dips (to %1), %2")
                .arg(bodyWeightsText(reason.force), prominence);
        case Kind::Unremarkable:
            break;
    }
    return Words::tr("nothing unusual, %1").arg(prominence);
}

QString shortReasonText(const SuspectReason& reason) {
    using Kind = SuspectReason::Kind;
    switch (reason.kind) {
        case Kind::SlowKick:
            return reason.left ? Words::tr("left kick") : Words::tr("right kick");
        case Kind::MovingFoot:
            return reason.left ? Words::tr("left foot") : Words::tr("right foot");
        case Kind::Shallow:
            return Words::tr("shallow");
        case Kind::Crowded:
            return Words::tr("crowded");
        case Kind::High:
            return Words::tr("hardly dips");
        case Kind::Unremarkable:
            break;
    }
    return QStringLiteral("–");
}

QString suspicionText(const FighterAnalysis& fighter, const BoundaryMark& mark) {
    return Words::tr("%1, suspicion %2")
        .arg(reasonText(suspectReason(fighter, *mark.minimum)), percentText(mark.suspicion));
}

QString correctionWords(const Correction& correction, const Fighter& fighter) {
    const auto at = [&](int frame) { return timeText(timeOfFrame(fighter, frame)); };
    switch (correction.kind) {
        case Correction::Kind::Remove:
            return Words::tr("removal at %1").arg(at(correction.frame));
        case Correction::Kind::Add:
            return Words::tr("addition at %1").arg(at(correction.frame));
        case Correction::Kind::Move:
            return Words::tr("move from %1 to %2").arg(at(correction.frame), at(correction.to));
        case Correction::Kind::Keep:
            return Words::tr("acceptance at %1").arg(at(correction.frame));
    }
    return {};
}

QString fighterText(int player) {
    return Words::tr("fighter %1").arg(player + 1);
}

QString momentText(const QDateTime& moment, bool seconds) {
    const QString time =
        moment.time().toString(seconds ? QStringLiteral("HH:mm:ss") : QStringLiteral("HH:mm"));
    const QDate today = QDate::currentDate();
    if (moment.date() == today) {
        return Words::tr("today %1").arg(time);
    }
    if (moment.date() == today.addDays(-1)) {
        return Words::tr("yesterday %1").arg(time);
    }
    return moment.date().toString(Qt::ISODate) + QLatin1Char(' ') + time;
}

QString holderText(const LockHolder& holder) {
    return Words::tr("Computer %1, process %2, since %3.")
        .arg(holder.host)
        .arg(holder.process)
        .arg(momentText(holder.since));
}

QString editsText(int edits) {
    return Words::tr("%n edit(s)", nullptr, edits);
}

}  // namespace kumite::studio
