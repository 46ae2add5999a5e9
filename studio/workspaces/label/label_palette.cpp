#include "studio/workspaces/label/label_palette.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/core_words.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/lane_painter.h"
#include "studio/workspaces/label/label_lanes.h"
#include "studio/workspaces/label/label_review.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

namespace {

int rowHeight() {
    return withTextSize(16);
}
int chipWidth() {
    return withTextSize(18);
}
constexpr int kGap = 4;

bool isIdeograph(QChar c) {
    switch (c.script()) {
        case QChar::Script_Han:
        case QChar::Script_Hiragana:
        case QChar::Script_Katakana:
        case QChar::Script_Hangul:
            return true;
        default:
            return false;
    }
}

/// What a label and its mirror image have in common, "punch forward", and what tells each from the
/// other, "left" and "right": word by word.
struct PairWords {
    QString both, one, other;
};

PairWords pairWords(const QString& one, const QString& other) {
    const QStringList ones = one.split(QLatin1Char(' '));
    const QStringList others = other.split(QLatin1Char(' '));
    if (ones.size() != others.size()) return {one, {}, other};
    QStringList both, first, second;
    for (qsizetype i = 0; i < ones.size(); ++i) {
        if (ones[i] == others[i]) {
            both.append(ones[i]);
        } else {
            first.append(ones[i]);
            second.append(others[i]);
        }
    }
    const QString blank(QLatin1Char(' '));
    PairWords words{both.join(blank), first.join(blank), second.join(blank)};
    // Where words stand without blanks, the sign for the side is part of a word: 左突き, 右突き.
    QString shared;
    while (words.one.size() > 1 && words.other.size() > 1 && isIdeograph(words.one.back()) &&
           words.one.back() == words.other.back()) {
        shared.prepend(words.one.back());
        words.one.chop(1);
        words.other.chop(1);
    }
    if (!shared.isEmpty()) words.both = (shared + blank + words.both).trimmed();
    return words;
}

/// A key as a small cap; gives its width. Nothing without a key.
int paintKey(QPainter& painter, const QPoint& at, const QString& key, const Colours& c) {
    if (key.isEmpty()) return 0;
    const int width = std::max(14, painter.fontMetrics().horizontalAdvance(key) + 8);
    const QRectF cap(at.x() + 0.5, at.y() + 1.5, width - 1, rowHeight() - 4);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(mixed(c.line, c.secondText, 0.4), 1));
    painter.setBrush(mixed(c.panel, c.ground, 0.5));
    painter.drawRoundedRect(cap, 3, 3);
    painter.setPen(c.text);
    painter.drawText(cap, Qt::AlignCenter, key);
    return width;
}

}  // namespace

LabelPalette::LabelPalette(LabelReview& review, std::function<QString(const QString& id)> keyOf,
                           QWidget* parent)
    : QWidget(parent), review_(review), keyOf_(std::move(keyOf)) {
    setAccessibleName(tr("Classes and their keys"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setSizePolicy(policy);
    layOut();
}

void LabelPalette::refresh() {
    layOut();
    update();
}

QSize LabelPalette::sizeHint() const {
    return {200, height_};
}

QSize LabelPalette::minimumSizeHint() const {
    return {120, height_};
}

void LabelPalette::resizeEvent(QResizeEvent*) {
    layOut();
}

void LabelPalette::layOut() {
    const int before = height_;
    spots_.clear();
    const Vocabulary& vocabulary = review_.labels().vocabulary();
    int top = 0;
    for (int a = 0; a < vocabulary.size(); ++a) {
        Spot lane;
        lane.kind = Spot::Lane;
        lane.index = a;
        lane.place = QRect(0, top, width(), rowHeight());
        lane.text = vocabularyWords(vocabulary[a].name);
        spots_.push_back(lane);
        top += rowHeight();
        if (a == review_.labels().aspect()) addClasses(top);
    }
    top += kGap;
    quickTop_ = top;
    addQuick(top);
    Spot besides;
    besides.kind = Spot::Besides;
    besides.key = keyOf_(QStringLiteral("label.composite"));
    besides.place = QRect(0, top + kGap, width(), rowHeight());
    besides.text = tr("first, then two classes: both");
    besides.tip = tr("For two strikes in one action: this, then a class of another lane");
    spots_.push_back(besides);
    top += kGap + rowHeight();
    height_ = top;
    if (height_ != before) updateGeometry();
}

/// The classes of the chosen lane, as chips in lines.
void LabelPalette::addClasses(int& top) {
    const Vocabulary& vocabulary = review_.labels().vocabulary();
    const Aspect& aspect = vocabulary[review_.labels().aspect()];
    int left = 10;
    for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q) {
        const Qualifier& qualifier = aspect.qualifiers[q];
        Spot chip;
        chip.kind = Spot::Class;
        chip.index = static_cast<int>(q);
        chip.key =
            qualifier.key.empty()
                ? QString()
                : keyOf_(
                      QStringLiteral("label.class%1").arg(QString::fromStdString(qualifier.key)));
        chip.text = vocabularyWords(qualifier.name);
        chip.tip = aspectWords(vocabulary, review_.labels().aspect(), chip.index);
        chip.colour = QColor(QString::fromStdString(qualifier.colour));
        const int cap = chip.key.isEmpty()
                            ? 0
                            : std::max(14, fontMetrics().horizontalAdvance(chip.key) + 8) + 3;
        const int wide = cap + 6 + fontMetrics().horizontalAdvance(chip.text) + 8;
        if (left > 10 && left + wide > width()) {
            left = 10;
            top += chipWidth() + 2;
        }
        chip.place = QRect(left, top, wide, chipWidth());
        spots_.push_back(chip);
        left += wide + kGap;
    }
    top += chipWidth() + kGap;
}

/// Quick labels; one and its mirror image share a line, under the words that tell them apart.
void LabelPalette::addQuick(int& top) {
    const Vocabulary& vocabulary = review_.labels().vocabulary();
    const std::vector<QuickLabel> all = quickLabels(vocabulary);
    const auto isPair = [&](std::size_t i) {
        return i + 1 < all.size() && all[i + 1].label != all[i].label &&
               mirroredLabel(vocabulary, all[i].label) == all[i + 1].label;
    };
    const auto wordsOf = [&](std::size_t i) {
        return pairWords(labelWords(vocabulary, all[i].label),
                         labelWords(vocabulary, all[i + 1].label));
    };
    int column = 28;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!isPair(i)) continue;
        const PairWords words = wordsOf(i++);
        for (const QString& side : {words.one, words.other})
            column = std::max(column, fontMetrics().horizontalAdvance(side));
    }
    column = std::min(column + 6, width() / 3);
    QString head;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Spot quick;
        quick.kind = Spot::Quick;
        const auto put = [&](std::size_t label, const QRect& place, const QString& text) {
            quick.index = static_cast<int>(label);
            quick.key = keyOf_(QStringLiteral("label.quick%1").arg(label + 1));
            quick.tip = labelWords(vocabulary, all[label].label);
            quick.place = place;
            quick.text = text;
            spots_.push_back(quick);
        };
        if (!isPair(i)) {
            put(i, QRect(0, top, width(), rowHeight()), labelWords(vocabulary, all[i].label));
            top += rowHeight();
            continue;
        }
        const PairWords words = wordsOf(i);
        if (head != words.one + words.other) {
            head = words.one + words.other;
            Spot caption;
            caption.kind = Spot::Caption;
            caption.place = QRect(0, top, column, rowHeight());
            caption.text = words.one;
            spots_.push_back(caption);
            caption.place.translate(column, 0);
            caption.text = words.other;
            spots_.push_back(caption);
            top += rowHeight();
        }
        put(i, QRect(0, top, column, rowHeight()), {});
        put(i + 1, QRect(column, top, column, rowHeight()), {});
        Spot what;
        what.kind = Spot::Caption;
        what.place = QRect(2 * column, top, width() - 2 * column, rowHeight());
        what.text = words.both;
        spots_.push_back(what);
        ++i;
        top += rowHeight();
    }
}

void LabelPalette::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    for (const Spot& spot : spots_) {
        if (spot.kind == Spot::Lane) paintLane(painter, spot);
        if (spot.kind == Spot::Class) paintClass(painter, spot);
        if (spot.kind == Spot::Quick) paintQuick(painter, spot);
        if (spot.kind == Spot::Besides) paintBesides(painter, spot);
        if (spot.kind == Spot::Caption) {
            painter.setPen(coloursFor(palette()).secondText);
            painter.drawText(
                spot.place, Qt::AlignLeft | Qt::AlignVCenter,
                painter.fontMetrics().elidedText(spot.text, Qt::ElideRight, spot.place.width()));
        }
    }
    const Colours& c = coloursFor(palette());
    painter.fillRect(QRect(0, quickTop_ - kGap / 2, width(), 1), c.line);
}

void LabelPalette::paintLane(QPainter& painter, const Spot& spot) {
    const Colours& c = coloursFor(palette());
    const LabelSession& labels = review_.labels();
    const bool chosen = spot.index == labels.aspect();
    if (chosen) {
        painter.fillRect(spot.place, mixed(c.panel, c.text, 0.07));
        painter.fillRect(QRect(0, spot.place.top(), 2, spot.place.height()), c.accent);
    }
    painter.setPen(chosen ? c.text : c.secondText);
    const QRect name = spot.place.adjusted(8, 0, -spot.place.width() / 2, 0);
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(spot.text, Qt::ElideRight, name.width() - 4));
    const ShownAction* action = labels.current();
    if (action == nullptr) return;
    const Aspect& aspect = labels.vocabulary()[spot.index];
    const ShownAspect& shown = action->aspects[static_cast<std::size_t>(spot.index)];
    if (!shown.value.known()) return;
    const LaneCell cell = laneCell(aspect, shown);
    const auto& qualifier = aspect.qualifiers[static_cast<std::size_t>(shown.value.qualifier)];
    const QColor colour = classColour(QColor(QString::fromStdString(qualifier.colour)), c);
    const int middle = spot.place.center().y();
    const QRect swatch(spot.place.width() / 2, middle - 4, 9, 9);
    if (cell.look != LaneLook::Nothing) {
        const bool full = cell.look == LaneLook::Hand;
        const bool outlined = cell.look == LaneLook::Rule || cell.uncertain;
        painter.fillRect(swatch, mixed(c.panel, colour, full ? 1.0 : outlined ? 0.15 : 0.5));
        if (cell.uncertain) painter.fillRect(swatch, QBrush(colour, Qt::BDiagPattern));
        painter.setPen(colour);
        painter.setBrush(Qt::NoBrush);
        if (outlined) painter.drawRect(swatch.adjusted(0, 0, -1, -1));
    }
    QString text = vocabularyWords(qualifier.name);
    const bool machine = shown.value.source == LabelSource::Machine;
    if (machine && shown.value.confidence > 0) {
        text += QStringLiteral("  ") + numberText(static_cast<double>(shown.value.confidence), 2);
    }
    painter.setPen(cell.byHand ? c.text : c.secondText);
    const QRect rest = spot.place.adjusted(spot.place.width() / 2 + 14, 0, 0, 0);
    painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, rest.width()));
}

void LabelPalette::paintClass(QPainter& painter, const Spot& spot) {
    const Colours& c = coloursFor(palette());
    const LabelSession& labels = review_.labels();
    const ShownAction* action = labels.current();
    const auto lane = static_cast<std::size_t>(labels.aspect());
    const bool is = action && action->aspects[lane].value.qualifier == spot.index;
    const bool brush = review_.brush() == Brush{labels.aspect(), spot.index};
    const int cap = paintKey(painter, spot.place.topLeft(), spot.key, c);
    const QRectF chip = QRectF(spot.place).adjusted(cap + (cap ? 3 : 0) + 0.5, 1.5, -0.5, -1.5);
    const QColor colour = classColour(spot.colour, c);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(brush ? c.accent : colour, brush ? 2 : 1));
    painter.setBrush(is ? mixed(c.panel, colour, 0.45) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(chip, 3, 3);
    painter.setPen(c.text);
    painter.drawText(chip, Qt::AlignCenter, spot.text);
}

void LabelPalette::paintQuick(QPainter& painter, const Spot& spot) {
    const Colours& c = coloursFor(palette());
    const int cap = paintKey(painter, spot.place.topLeft(), spot.key, c);
    const QRect rest = spot.place.adjusted(cap + 5, 0, 0, 0);
    painter.setPen(c.text);
    painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(spot.text, Qt::ElideRight, rest.width()));
}

void LabelPalette::paintBesides(QPainter& painter, const Spot& spot) {
    if (review_.isComposite()) {
        const Colours& c = coloursFor(palette());
        painter.fillRect(spot.place, mixed(c.panel, c.accent, 0.3));
    }
    paintQuick(painter, spot);
}

const LabelPalette::Spot* LabelPalette::spotAt(const QPoint& position) const {
    const auto found = std::find_if(spots_.begin(), spots_.end(), [&](const Spot& spot) {
        return spot.place.contains(position);
    });
    return found == spots_.end() ? nullptr : &*found;
}

void LabelPalette::mousePressEvent(QMouseEvent* event) {
    const Spot* spot = spotAt(event->pos());
    if (spot == nullptr) return;
    const int index = spot->index;
    LabelSession& labels = review_.labels();
    switch (spot->kind) {
        case Spot::Lane:
            labels.setAspect(index);
            break;
        case Spot::Class:
            if (event->button() == Qt::RightButton) {
                const Brush brush{labels.aspect(), index};
                review_.setBrush(review_.brush() == brush ? std::nullopt : std::optional(brush));
            } else {
                review_.nameQualifier(index);
            }
            break;
        case Spot::Quick:
            review_.quick(index);
            break;
        case Spot::Besides:
            review_.announceBesides();
            break;
        case Spot::Caption:
            break;
    }
}

bool LabelPalette::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const Spot* spot = spotAt(help->pos());
    QString tip = spot ? spot->tip : QString();
    if (spot && spot->kind == Spot::Class) {
        tip += tr("\nRight click: paint with it over actions of the timeline");
    }
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
}

}  // namespace kumite::studio
