// An element by itself measures as it did on its board: kind, area, box and heights, of every element of a real job.
#include "model/board/single_element.h"

#include <QtTest>

#include "model/formats/registry.h"
#include "model/statistics/element_sizes.h"
#include "tests/locations.h"

using namespace model;

class SingleElementTest : public QObject {
    Q_OBJECT

private slots:
    void everyElementStaysAsItIs() {
        base::Progress progress;
        const auto board = readBoard(locations::kSample, {}, progress);
        QVERIFY(bool(board));
        const Document& d = **board;
        std::array<int, kElementKindCount> seen{};
        for (std::size_t row = 0; row < d.elements.size(); ++row) {
            const ElementId element{row};
            const auto alone = elementAlone(d, element);
            const ElementId copy{0};
            QCOMPARE(alone->elements.size(), std::size_t{1});
            QCOMPARE(alone->elements.kind[0], d.elements.kind[row]);
            QCOMPARE(alone->elements.flags[0], d.elements.flags[row]);
            QCOMPARE(areaOf(*alone, copy), areaOf(d, element));
            QVERIFY(alone->boxOf(copy) == d.boxOf(element));
            QVERIFY(alone->board == d.boxOf(element));
            QCOMPARE(alone->heightsOf(copy).bottom, d.heightsOf(element).bottom);
            QCOMPARE(alone->heightsOf(copy).top, d.heightsOf(element).top);
            QCOMPARE(nodeCountOf(*alone, copy), nodeCountOf(d, element));
            ++seen[static_cast<std::size_t>(d.elements.kind[row])];
        }
        for (const ElementKind kind : {ElementKind::Line, ElementKind::Circle, ElementKind::Area}) {
            QVERIFY(seen[static_cast<std::size_t>(kind)] > 0);
        }
    }
};

QTEST_GUILESS_MAIN(SingleElementTest)
#include "single_element_test.moc"
