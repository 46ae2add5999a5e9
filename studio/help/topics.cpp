#include "studio/help/topics.h"

#include <QRegularExpression>
#include <QWidget>

#include <algorithm>

#include "studio/help/help_pages.h"

namespace kumite::studio {

namespace {

/// Which widgets show numbers, by their class, and which sections of method.md explain these.
struct Topics {
    const char* widget;
    const char* anchors;
};

constexpr Topics kTopics[] = {
    {"SegmentPanel", "suspicion prominence"},
    {"DetectionBox", "cutoff prominence"},
    {"StatisticsBox", "counts-of-a-take"},
    {"CompareBox", "counts-of-a-take"},
    {"TimelineView", "contact-force centre-of-mass prominence"},
    {"StageView", "measured-distances-and-speeds"},
    {"FighterProperties", "floor-and-foot-contact centre-of-mass"},
    {"ImportDialog", "floor-and-foot-contact"},
    {"LabelPanel", "probability-p-of-a-label margin"},
    {"ProgressBox", "expected-accuracy probability-p-of-a-label"},
    {"FindBox", "probability-p-of-a-label"},
    {"SimilarBox", "features"},
    {"QualityBox", "confusion-and-f1"},
    {"LearningPlot", "expected-accuracy"},
    {"RulesBox", "rules"},
    {"CompareLabelsBox", "cohens-kappa"},
    {"GraphCentre", "probability-of-a-transition estimators"},
    {"SurpriseStrip", "surprise"},
    {"TraceBox", "surprise"},
    {"WhatIfBox", "what-may-follow geometry-term"},
    {"BoutPanel", "a-choice-in-a-bout quality-of-a-motion"},
    {"TransitionBox", "cost-of-a-transition"},
    {"ClusterMap", "cost-of-a-transition"},
    {"MotionBox", "likeness-of-key-poses"},
    {"HitBox", "hit-error"},
};

QStringList placesOf(const Topics& topics) {
    QStringList places;
    for (const QString& anchor : QString::fromLatin1(topics.anchors).split(QLatin1Char(' ')))
        places.append(QStringLiteral("method#") + anchor);
    return places;
}

/// The lines from the heading of a place to the next one.
QStringList sectionOf(const QString& place) {
    const HelpPage* page = helpPage(place.section(QLatin1Char('#'), 0, 0));
    QStringList section;
    if (page == nullptr) return section;
    int before = page->headingOf(place.section(QLatin1Char('#'), 1));
    for (const QString& line : page->source.split(QLatin1Char('\n'))) {
        const bool heading = line.startsWith(QLatin1Char('#'));
        if (heading && !section.isEmpty()) break;
        const QString text = line.mid(line.indexOf(QLatin1Char(' ')) + 1);
        if (!section.isEmpty() || (heading && before-- == 0)) section.append(heading ? text : line);
    }
    return section;
}

}  // namespace

QStringList topicsOf(const QWidget& widget) {
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget()) {
        const QString name = QString::fromLatin1(at->metaObject()->className());
        for (const Topics& each : kTopics) {
            if (name.section(QStringLiteral("::"), -1) == QLatin1String(each.widget))
                return placesOf(each);
        }
    }
    return {};
}

QStringList allTopics() {
    QStringList all;
    for (const Topics& each : kTopics)
        all += placesOf(each);
    all.removeDuplicates();
    return all;
}

QString topicTitle(const QString& place) {
    return sectionOf(place).value(0);
}

QString topicSummary(const QString& place) {
    QString text;
    for (const QString& line : sectionOf(place).mid(1)) {
        if (line.startsWith(QLatin1Char('|'))) break;
        if (line.trimmed().isEmpty()) {
            // A formula alone says too little.
            if (text.endsWith(QLatin1Char('.')) || text.endsWith(QLatin1Char(':'))) break;
            if (!text.isEmpty()) text += QStringLiteral("\n");
            continue;
        }
        text +=
            (text.isEmpty() || text.endsWith(QLatin1Char('\n')) ? QString() : QStringLiteral(" ")) +
            line.trimmed();
    }
    static const QRegularExpression link(QStringLiteral("\\[([^\\]]+)\\]\\([^)]*\\)"));
    static const QRegularExpression code(QStringLiteral("`([^`]+)`"));
    static const QRegularExpression strong(QStringLiteral("\\*\\*?([^*\n]+)\\*\\*?"));
    text = text.trimmed().toHtmlEscaped();
    text.replace(link, QStringLiteral("\\1"));
    text.replace(code, QStringLiteral("<tt>\\1</tt>"));
    text.replace(strong, QStringLiteral("<i>\\1</i>"));
    return text.replace(QLatin1Char('\n'), QStringLiteral("<br>"));
}

}  // namespace kumite::studio
