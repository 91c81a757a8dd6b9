// Labels beside each other, on canvases of any size.
#include "ui/views/label_placing.h"

#include <QRandomGenerator>
#include <QtTest>

using ui::LabelPlacing;

namespace {

constexpr QSizeF kCanvas(800, 600);

}  // namespace

class LabelPlacingTest : public QObject {
    Q_OBJECT

private slots:
    void labelsOfOnePlaceLieBesideEachOther() {
        LabelPlacing placing(kCanvas);
        std::vector<QRectF> boxes;
        for (int i = 0; i < 12; ++i) {
            boxes.push_back(placing.place({400, 300}, {120, 40}));
            for (int k = 0; k < i; ++k) {
                QVERIFY2(!boxes[size_t(k)].intersects(boxes[size_t(i)]), qPrintable(QString("%1 %2").arg(k).arg(i)));
            }
        }
    }

    void labelsStayOnTheCanvas() {
        QRandomGenerator random(7);
        LabelPlacing placing(kCanvas);
        for (int i = 0; i < 60; ++i) {
            const QRectF box = placing.place({random.bounded(800.0), random.bounded(600.0)}, {90, 30});
            QVERIFY(QRectF(QPointF(), kCanvas).contains(box));
        }
    }

    void labelsKeepOffLines() {
        LabelPlacing placing(kCanvas);
        const QLineF aslant(300, 200, 500, 400);  // through the place that is wanted most
        placing.avoid(aslant);
        QVERIFY(!ui::partWithin(aslant, placing.place({400, 300}, {60, 20})));
    }

    void labelsKeepOffWhatIsToBeSeen() {
        LabelPlacing placing(kCanvas);
        const QRectF corner(650, 0, 150, 150);
        placing.keepFree(corner);
        for (int i = 0; i < 6; ++i) {
            QVERIFY(!placing.place({660.0 + 20.0 * i, 100}, {120, 40}).intersects(corner));
        }
    }

    void equalCallsGiveEqualPlaces() {
        const auto run = [] {
            QRandomGenerator random(3);
            LabelPlacing placing(kCanvas);
            std::vector<QRectF> boxes;
            for (int i = 0; i < 40; ++i) {
                placing.avoid({random.bounded(800.0), 0, random.bounded(800.0), 600});
                boxes.push_back(placing.place({random.bounded(800.0), random.bounded(600.0)}, {100, 50}));
            }
            return boxes;
        };
        QVERIFY(run() == run());
    }

    void whatMeetsAnEarlierLabelHasNoRoom() {
        ui::LabelRoom room;
        QVERIFY(room.take({{100, 100}, {60, 20}, 0.0}));
        QVERIFY(!room.take({{100, 100}, {60, 20}, 0.0}));
        QVERIFY(!room.take({{155, 100}, {60, 20}, 0.0}));
        QVERIFY(room.take({{161, 100}, {60, 20}, 0.0}));  // beside it
        QVERIFY(!room.take({{130, 110}, {40, 6}, 90.0}));
        QVERIFY(room.take({{100, 131}, {40, 20}, 90.0}));  // upright below it
        // Across a corner: the boxes around them meet, they do not.
        QVERIFY(room.take({{300, 300}, {100, 10}, 45.0}));
        QVERIFY(room.take({{320, 280}, {100, 10}, 45.0}));
        QVERIFY(!room.take({{305, 295}, {100, 10}, 45.0}));
        QVERIFY(room.take({{-50, -50}, {500, 10}, 0.0}));  // many cells, left of and above the canvas
        QVERIFY(!room.take({{-280, -52}, {20, 10}, 0.0}));
    }

    void roomIsAsWithoutAGrid() {
        QRandomGenerator random(11);
        ui::LabelRoom room;
        std::vector<ui::RotatedBox> taken;
        int refused = 0;
        for (int i = 0; i < 1500; ++i) {
            const ui::RotatedBox box{{random.bounded(1600.0), random.bounded(1000.0)},
                                     {10.0 + random.bounded(80.0), 6.0 + random.bounded(30.0)},
                                     random.bounded(180.0) - 90.0};
            const bool isFree = std::ranges::none_of(taken, [&](const auto& other) { return other.meets(box); });
            QCOMPARE(room.take(box), isFree);
            if (isFree) {
                taken.push_back(box);
            }
            refused += isFree ? 0 : 1;
        }
        QVERIFY(refused > 300 && taken.size() > 100);
    }

    void labelsLargerThanTheCanvasBeginOnIt() {
        LabelPlacing placing({100, 50});
        QCOMPARE(placing.place({50, 25}, {300, 200}).topLeft(), QPointF(0, 0));
    }

    void whatOfALineIsSeenIsFound() {
        const QRectF box(0, 0, 100, 100);
        QCOMPARE(*ui::partWithin({-50, 50, 150, 50}, box), QLineF(0, 50, 100, 50));
        QVERIFY(!ui::partWithin({-50, 120, 150, 120}, box));
        QVERIFY(!ui::partWithin({-50, 80, 20, 180}, box));
        QCOMPARE(ui::partsWithin({{-300, 50}, {40, 50}, {40, 300}, {60, 300}, {60, 90}, {70, 90}}, box),
                 QList<QPolygonF>({{{0, 50}, {40, 50}, {40, 100}}, {{60, 100}, {60, 90}, {70, 90}}}));
        QCOMPARE(ui::partsWithin({{5, 5}, {5, 5}}, box), QList<QPolygonF>({{{5, 5}, {5, 5}}}));
        QCOMPARE(*ui::middleWithin({{-300, 50}, {40, 50}, {40, 100}}, box), QPointF(40, 55));
        QVERIFY(!ui::middleWithin({{-300, 50}, {-40, 50}}, box));
        QCOMPARE(*ui::middleWithin({{5, 5}, {5, 5}}, box), QPointF(5, 5));
    }
};

QTEST_APPLESS_MAIN(LabelPlacingTest)
#include "label_placing_test.moc"
