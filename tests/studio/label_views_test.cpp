// What looks at labels in the Label workspace: search, confusion matrix, learning curve, similar
// actions, rules, two people, files.

#include <QAbstractItemView>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include <fstream>

#include "studio/app/commands.h"
#include "studio/app/message_strip.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/action_tiles.h"
#include "studio/workspaces/label/compare_labels_box.h"
#include "studio/workspaces/label/confusion_matrix.h"
#include "studio/workspaces/label/find_box.h"
#include "studio/workspaces/label/found_list.h"
#include "studio/workspaces/label/label_exchange.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_views.h"
#include "studio/workspaces/label/learning_plot.h"
#include "studio/workspaces/label/quality_box.h"
#include "studio/workspaces/label/rules_box.h"
#include "studio/workspaces/label/similar_box.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

ConfusionTable tableOf(const Aspect& aspect) {
    ConfusionTable table;
    const std::size_t count = aspect.qualifiers.size();
    for (const Qualifier& qualifier : aspect.qualifiers) {
        table.names.append(QString::fromStdString(qualifier.name));
        table.spelt.append(QString::fromStdString(qualifier.id));
    }
    table.counts.assign(count, std::vector<int>(count + 1, 0));
    for (std::size_t i = 0; i < count; ++i)
        table.counts[i][i] = 10;
    table.counts[0][1] = 3;
    return table;
}

TEST(ConfusionLayout, NothingIsClippedForFewAndForManyQualifiers) {
    const QFont font;
    const QFontMetricsF metrics(font);
    for (const Aspect& aspect : kickboxing().aspects) {
        ConfusionTable table = tableOf(aspect);
        for (const double width : {240.0, 280.0, 420.0}) {
            for (const bool open : {false, true}) {
                table.counts[0].back() = open ? 2 : 0;
                const ConfusionLayout layout = layOut(table, width, metrics);
                const int columns = table.size() + (open ? 1 : 0);
                EXPECT_LE(layout.cells.right(), width) << aspect.id << width;
                EXPECT_GE(layout.cellWidth, 20) << aspect.id << width;
                EXPECT_GE(layout.cellWidth, metrics.horizontalAdvance("99")) << aspect.id;
                for (const QString& name : layout.spelt ? table.spelt : table.names) {
                    EXPECT_LE(metrics.horizontalAdvance(name), layout.cells.left());
                    EXPECT_LE(metrics.horizontalAdvance(name), layout.cells.top());
                }
                const ConfusionCell last{table.size() - 1, columns - 1};
                EXPECT_EQ(layout.at(layout.rect(last).center(), table.size(), columns), last);
                EXPECT_FALSE(layout.at({1, 1}, table.size(), columns));
                EXPECT_LE(layout.rect(last).bottom(), layout.height);
            }
        }
    }
}

TEST(ConfusionMatrix, TellsCountsAndSharesAndMovesByKeys) {
    ConfusionMatrix matrix;
    matrix.show(tableOf(kickboxing()[0]));
    matrix.resize(280, matrix.heightForWidth(280));
    EXPECT_EQ(matrix.cellText({0, 1}).toStdString(),
              "forward by hand, back by machine: 3 actions, 23 % of forward");
    std::vector<ConfusionCell> opened;
    QObject::connect(&matrix, &ConfusionMatrix::opened,
                     [&](const ConfusionCell& cell) { opened.push_back(cell); });
    QTest::keyClick(&matrix, Qt::Key_Right);
    EXPECT_EQ(matrix.current(), (ConfusionCell{0, 0})) << "the first key shows where one is";
    QTest::keyClick(&matrix, Qt::Key_Right);
    QTest::keyClick(&matrix, Qt::Key_Down);
    QTest::keyClick(&matrix, Qt::Key_Return);
    QTest::mouseClick(&matrix, Qt::LeftButton, Qt::NoModifier,
                      matrix.cellRect({0, 1}).center().toPoint());
    EXPECT_EQ(opened, (std::vector<ConfusionCell>{{1, 1}, {0, 1}}));
    for (int i = 0; i < 20; ++i)
        QTest::keyClick(&matrix, Qt::Key_Down);
    EXPECT_EQ(matrix.current()->hand, 4);
}

TEST(LearningPlotAxes, AreRoundAndHoldEverything) {
    LearningPlotValues values;
    values.orders.points = {{5, 0.55, 0.5}, {37, 0.93, 0.8}};
    values.expected = {{4, 0.61}, {52, 0.97}};
    const LearningPlotAxes axes = axesOf(values, QRectF(40, 10, 200, 100));
    EXPECT_GE(axes.mostLabels, 52);
    EXPECT_EQ(axes.mostLabels % axes.labelStep, 0);
    EXPECT_LE(axes.leastShare, 0.5);
    EXPECT_GE(axes.leastShare, 0.3);
    EXPECT_EQ(axes.pointOf(0, 1), QPointF(40, 10));
    EXPECT_EQ(axes.pointOf(axes.mostLabels, axes.leastShare), QPointF(240, 110));
    EXPECT_NEAR(axes.labelsAt(axes.pointOf(20, 0.7).x()), 20, 1e-9);
    LearningPlot plot;
    plot.show(values);
    EXPECT_EQ(plot.textAt(40).toStdString(),
              "37 labels: expected 61 %, as asked 93 %, random 80 %");
    EXPECT_EQ(plot.textAt(1), QString());
}

TEST(TileGrid, FillsTheAreaWithTilesOfOneSize) {
    for (const QSizeF area : {QSizeF(280, 500), QSizeF(900, 200), QSizeF(300, 300)}) {
        for (int tiles = 1; tiles <= 6; ++tiles) {
            const TileGrid grid = tileGrid(tiles, area, 0.95);
            EXPECT_GE(grid.columns * grid.rows, tiles);
            for (int i = 0; i < tiles; ++i) {
                EXPECT_TRUE(QRectF(QPointF(), area).contains(grid.rect(i)));
                for (int j = 0; j < i; ++j)
                    EXPECT_FALSE(grid.rect(i).intersects(grid.rect(j)));
            }
        }
    }
    EXPECT_EQ(tileGrid(6, {280, 440}, 0.95).columns, 2);
}

class LabelViewsTest : public WindowTest {
protected:
    LabelSession& labels() { return window_->labels(); }
    LabelViews& views() { return *window_->findChild<LabelViews*>(); }
    const Project& project() { return session().document().project(); }
    std::size_t steps() { return session().document().history().position(); }

    void openLabelling() {
        openBout();
        window_->workspaces().show(QStringLiteral("label"));
        settle();
        ASSERT_GT(labels().actions().size(), 10U);
    }
    void say(std::vector<int> actions, const std::string& label) {
        Label said = parseLabel(labels().vocabulary(), label);
        said[5] = said[6] = kUnknown;  // left to the rules
        ASSERT_TRUE(labels().say(actions, said));
        settle();
    }
    void run(const char* command) {
        ASSERT_NE(window_->commands().find(QLatin1String(command)), nullptr) << command;
        window_->commands().run(QLatin1String(command));
    }
    template <typename Widget>
    Widget* named(QWidget& in, const QString& name) {
        for (auto* widget : in.findChildren<Widget*>()) {
            if (widget->accessibleName() == name) return widget;
        }
        ADD_FAILURE() << "nothing is called " << name.toStdString();
        return nullptr;
    }
    /// Labels of some actions by hand, so that machines have something to learn.
    void sayMany() {
        const int count = static_cast<int>(labels().actions().size());
        std::vector<int> kicks, others;
        for (int i = 0; i < count - 2; ++i)
            (i % 3 == 0 ? kicks : others).push_back(i);
        say(kicks, "left_kick:up");
        say(others, "others");
    }
};

TEST_F(LabelViewsTest, FindsActionsAsOneTypesAndLabelsThemAllAtOnce) {
    openLabelling();
    say({1, 4, 6}, "right_kick:up");
    QTest::keyClick(&timeline(), Qt::Key_F, Qt::ControlModifier);
    EXPECT_EQ(views().page(), LabelViews::FindPage);
    FindBox& find = views().find();
    EXPECT_TRUE(find.field()->hasFocus());
    QTest::keyClicks(find.field(), "right kick, by hand");
    const FoundModel& found = find.list().model();
    ASSERT_EQ(found.rowCount(), 3);
    EXPECT_EQ(found.data(found.index(0, FoundModel::LabelColumn), Qt::DisplayRole).toString(),
              "right kick up");
    // A narrow list leaves its room to the labels, and still says who spoke.
    find.list().resize(220, 300);
    EXPECT_TRUE(find.list().table()->isColumnHidden(FoundModel::SourceColumn));
    EXPECT_EQ(found.data(found.index(0, FoundModel::ConfidenceColumn), Qt::DisplayRole).toString(),
              "hand");
    find.list().resize(400, 300);
    EXPECT_FALSE(find.list().table()->isColumnHidden(FoundModel::SourceColumn));
    EXPECT_EQ(found.data(found.index(0, FoundModel::ConfidenceColumn), Qt::DisplayRole).toString(),
              "1.00");
    // Enter leads from one to the next and loops it.
    QTest::keyClick(find.field(), Qt::Key_Return);
    EXPECT_EQ(labels().current()->peak, found.rows()[0].peak);
    EXPECT_TRUE(session().transport().isLooping());
    QTest::keyClick(find.field(), Qt::Key_Return);
    EXPECT_EQ(labels().current()->peak, found.rows()[1].peak);
    run("label.find.previous");
    EXPECT_EQ(labels().current()->peak, found.rows()[0].peak);
    // All at once, one step.
    run("label.find.all");
    EXPECT_EQ(labels().chosen(), (std::vector<int>{1, 4, 6}));
    const std::size_t before = steps();
    ASSERT_TRUE(labels().name(labels().chosen(), 4, 0));
    EXPECT_EQ(steps(), before + 1);
    settle();
    // What is not understood is said, with what may have been meant.
    find.setText(QStringLiteral("right kik"));
    EXPECT_EQ(found.rowCount(), 0);
    EXPECT_TRUE(named<QLabel>(find, QStringLiteral("What was understood"))
                    ->text()
                    .contains(QStringLiteral("did you mean \"kick\"?")));
    find.setText(QStringLiteral("unlabelled"));
    EXPECT_EQ(found.rowCount(), static_cast<int>(labels().actions().size()) - 3);
}

TEST_F(LabelViewsTest, NoPageIsCutOffInASmallWindow) {
    openLabelling();
    window_->resize(1280, 800);
    say({2}, "left_punch:fwd");
    for (int page = 0; page < LabelViews::PageCount; ++page) {
        views().setPage(static_cast<LabelViews::Page>(page));
        settle();
        for (auto* scroll : views().findChildren<QScrollArea*>()) {
            if (!scroll->isVisible()) continue;
            EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width()) << "page " << page;
        }
    }
}

TEST_F(LabelViewsTest, ACellOfTheMatrixOpensItsActions) {
    openLabelling();
    sayMany();
    run("label.page.quality");
    QualityBox& quality = views().quality();
    quality.setAspect(2);
    for (int i = 0; i < 200 && quality.isBusy(); ++i)
        QTest::qWait(20);
    settle();
    ConfusionMatrix& matrix = quality.matrix();
    ASSERT_TRUE(matrix.isVisible());
    int all = 0;
    for (int hand = 0; hand < matrix.table().size(); ++hand)
        all += matrix.table().row(hand);
    EXPECT_EQ(all, static_cast<int>(labels().actions().size()) - 2);
    // Some cell has actions: Enter on it goes to the first of them.
    ConfusionCell cell;
    for (int hand = 0; hand < matrix.table().size(); ++hand) {
        for (int answer = 0; answer < matrix.table().size(); ++answer) {
            if (matrix.table().at(hand, answer) > 1) cell = {hand, answer};
        }
    }
    QTest::mouseClick(&matrix, Qt::LeftButton, Qt::NoModifier,
                      matrix.cellRect(cell).center().toPoint());
    const FoundModel& list = quality.list().model();
    ASSERT_EQ(list.rowCount(), matrix.table().at(cell.hand, cell.answer));
    EXPECT_EQ(labels().current()->peak, list.rows()[0].peak);
    QTest::keyClick(quality.list().table(), Qt::Key_Down);
    EXPECT_EQ(labels().current()->peak, list.rows()[1].peak);
    QTest::keyClick(quality.list().table(), Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(labels().chosen().size(), 2U) << "arrows belong to the list that has the focus";
}

TEST_F(LabelViewsTest, SimilarActionsLoopInStepAndGetTheSameLabel) {
    openLabelling();
    say({2}, "left_punch:fwd");
    run("label.page.similar");
    labels().goTo(labels().actions()[2]);
    settle();
    SimilarBox& similar = views().similar();
    ActionTiles& tiles = similar.tiles();
    ASSERT_EQ(tiles.count(), 6);
    EXPECT_EQ(similar.actions().front(), 2);
    EXPECT_TRUE(tiles.isPlaying());
    // Every tile shows something: its picture is not of one colour.
    const QImage picture = tiles.picture();
    const double ratio = picture.devicePixelRatio();
    for (int i = 0; i < tiles.count(); ++i) {
        const QRect part = tiles.tileRect(i).adjusted(4, 4, -4, -40).toRect();
        const QImage cut = picture.copy(QRect(part.topLeft() * ratio, part.size() * ratio));
        std::set<QRgb> colours;
        for (int y = 0; y < cut.height(); y += 2) {
            for (int x = 0; x < cut.width(); x += 2)
                colours.insert(cut.pixel(x, y));
        }
        EXPECT_GT(colours.size(), 20U) << "tile " << i;
    }
    QTest::mouseClick(&tiles, Qt::LeftButton, Qt::NoModifier, tiles.tileRect(1).center().toPoint());
    QTest::mouseClick(&tiles, Qt::LeftButton, Qt::NoModifier, tiles.tileRect(3).center().toPoint());
    EXPECT_EQ(tiles.chosen(), (std::vector<int>{1, 3}));
    const std::vector<int> given = {similar.actions()[1], similar.actions()[3]};
    const std::size_t before = steps();
    run("label.similar.give");
    EXPECT_EQ(steps(), before + 1);
    settle();
    for (const int index : given) {
        const Label hand = labels().actions()[static_cast<std::size_t>(index)].byHand();
        EXPECT_TRUE(hand[0] == 0 || hand[1] == 0) << "the punch, or its mirror image";
        EXPECT_EQ(hand[6], kUnknown) << "what rules decide is not handed on";
    }
    // Not drawn while it is not seen.
    run("label.page.label");
    EXPECT_FALSE(tiles.isPlaying());
}

TEST_F(LabelViewsTest, ADragOfAThresholdIsOneStepAndCountsWhatChanges) {
    openLabelling();
    say({2}, "left_punch:fwd");
    run("label.page.rules");
    RulesBox& rules = views().rules();
    auto* slider = named<QSlider>(rules, QStringLiteral("Speed below which a foot lands"));
    ASSERT_NE(slider, nullptr);
    const std::size_t before = steps();
    const double was = project().labelling.rules.contacts.speed;
    slider->setSliderDown(true);
    slider->setSliderPosition(slider->minimum() + 1);
    settle();
    slider->setSliderPosition(slider->minimum());
    settle();
    slider->setSliderDown(false);
    settle();
    EXPECT_EQ(steps(), before + 1) << "one gesture";
    EXPECT_DOUBLE_EQ(project().labelling.rules.contacts.speed, 0.05);
    EXPECT_NE(rules.changesText(), QString());
    EXPECT_TRUE(rules.changesText().contains(QStringLiteral("move")));
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(project().labelling.rules.contacts.speed, was);
    EXPECT_EQ(steps(), before);
}

TEST_F(LabelViewsTest, TwoPeopleAreComparedAndTheirsTakenByKey) {
    openLabelling();
    say({1, 4, 6, 8}, "right_kick:up");
    LabelExchange& exchange = *window_->findChild<LabelExchange*>();
    exchange.exportTo(file("theirs.csv"));
    ASSERT_TRUE(QFile::exists(file("theirs.csv")));
    say({4, 6, 8}, "left_kick:up");
    const std::size_t before = steps();
    exchange.compareWith(file("theirs.csv"));
    settle();
    CompareLabelsBox& box = views().comparison();
    EXPECT_EQ(views().page(), LabelViews::ComparePage);
    ASSERT_TRUE(box.isComparing());
    EXPECT_EQ(box.agreement()->both, 4);
    EXPECT_EQ(box.agreement()->same, 1);
    ASSERT_EQ(box.model().rowCount(), 6) << "left and right kick of three actions";
    EXPECT_EQ(labels().current()->peak, box.model().rows()[0].peak);
    QTest::keyClick(box.list(), Qt::Key_Return);
    settle();
    EXPECT_EQ(steps(), before + 1);
    QTest::keyClick(box.list(), Qt::Key_Backspace);
    EXPECT_EQ(steps(), before + 1) << "mine stays";
    EXPECT_EQ(box.model().rows()[1].decision, DifferencesModel::Decision::Mine);
    run("label.compare.all");
    settle();
    EXPECT_EQ(steps(), before + 2) << "all the others are one step";
    EXPECT_EQ(box.agreement()->differences.size(), 1U);
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(box.agreement()->differences.size(), 5U);
    EXPECT_FALSE(window_->commands().isEnabled(*window_->commands().find("label.compare.add")));
    // What only they labelled comes in as one step.
    ASSERT_TRUE(labels().clear(std::vector<int>{1}));
    settle();
    EXPECT_EQ(box.agreement()->onlySecond, 1);
    const std::size_t without = steps();
    run("label.compare.add");
    settle();
    EXPECT_EQ(steps(), without + 1);
    EXPECT_EQ(box.agreement()->onlySecond, 0);
    EXPECT_EQ(box.agreement()->both, 4);
    box.close();
    EXPECT_FALSE(box.isComparing());
}

TEST_F(LabelViewsTest, LabelsComeInWithAReportAndAVocabularyTellsWhatItDrops) {
    openLabelling();
    say({1, 4}, "right_kick:up");
    LabelExchange& exchange = *window_->findChild<LabelExchange*>();
    for (const char* name : {"labels.json", "labels.csv", "labels.eaf"}) {
        exchange.exportTo(file(QLatin1String(name)));
        EXPECT_TRUE(QFile::exists(file(QLatin1String(name)))) << name;
    }
    ASSERT_TRUE(labels().clear(std::vector<int>{1, 4}));
    settle();
    std::ofstream(file("labels.csv").toStdString(), std::ios::app)
        << "left,1,900,901,900.5,right_kick:up,hand,1\n";
    const std::size_t before = steps();
    QString said;
    const auto hinted = QObject::connect(&session(), &Session::hinted, [&](const QString& text) {
        if (!text.isEmpty()) said = text;
    });
    exchange.importFrom(file("labels.csv"));
    settle();
    QObject::disconnect(hinted);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_TRUE(labels().actions()[1].anyByHand());
    EXPECT_TRUE(labels().actions()[4].anyByHand());
    // The status line counts, the strip says what found nothing.
    EXPECT_EQ(said.toStdString(), "labels.csv: 2 of 3 labels found their action.");
    EXPECT_TRUE(window_->messages().text().contains(QStringLiteral("no action there")))
        << window_->messages().text().toStdString();
    const qint64 size = QFile(file("left.bvh")).size();
    exchange.exportTo(file("left.bvh"));
    EXPECT_EQ(QFile(file("left.bvh")).size(), size) << "a recording is never written over";
    EXPECT_TRUE(window_->messages().text().contains(QStringLiteral("left.bvh")));

    Vocabulary tennis;
    tennis.name = "Tennis";
    Aspect stroke;
    stroke.id = "stroke";
    stroke.name = "Stroke";
    stroke.colour = "#3a86d8";
    stroke.key = "Q";
    stroke.qualifiers = {{"fh", "forehand", "#3a86d8", "1", false, 0},
                         {"none", "none", "#8a8f98", "0", false, 1}};
    stroke.fallback = 1;
    tennis.aspects = {stroke};
    std::ofstream(file("tennis.json").toStdString()) << vocabularyText(tennis);
    exchange.useVocabulary(file("tennis.json"));
    auto* question = window_->findChild<QMessageBox*>(QStringLiteral("vocabularyQuestion"));
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(
        question->informativeText().contains(QStringLiteral("Right kick: 2 labels by hand")))
        << question->informativeText().toStdString();
    EXPECT_EQ(project().labelling.vocabulary->name, "Kickboxing") << "nothing before the answer";
    for (QAbstractButton* button : question->buttons()) {
        if (question->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    }
    settle();
    EXPECT_EQ(project().labelling.vocabulary->name, "Tennis");
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(project().labelling.vocabulary->name, "Kickboxing");
    EXPECT_TRUE(labels().actions()[1].anyByHand());
}

}  // namespace
}  // namespace kumite::studio
