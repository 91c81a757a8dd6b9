// What is known of single boards that may not be bundled.
#include <QtTest>

#include "model/formats/registry.h"
#include "render/modelling/board_model.h"
#include "render/standard/standard_triangles.h"
#include "tests/locations.h"

namespace {

std::shared_ptr<const model::Document> read(const char* name, const std::string& step = {}) {
    base::Progress progress;
    const auto board = model::readBoard(locations::boards() / name, {step}, progress);
    return board ? *board : nullptr;
}

}  // namespace

class NamedBoardsTest : public QObject {
    Q_OBJECT

private slots:
    void thePanelHasThreeCards() {
        const auto card = read("ninevoltz_panel.tgz", "pcb1");
        const auto panel = read("ninevoltz_panel.tgz", "panel");
        QVERIFY(card && panel);
        const auto holes = [](const model::Document& d) { return d.layer(d.findLayer("drill")).countsWithCopies[2]; };
        QCOMPARE(panel->instances.size(), std::size_t{3});
        QVERIFY(holes(*panel) - 3 * holes(*card) <= 16);  // the panel's own tooling holes
        QCOMPARE(panel->steps.size(), std::size_t{1});
        QCOMPARE(panel->steps[0]->nets.size(), card->nets.size());
        QCOMPARE(panel->steps[0]->components.size(), card->components.size());
        QCOMPARE(panel->steps[0]->elements.size(), card->elements.size());
    }

    void thePapersModelHasTheNumbersOfTables2And3() {
        const auto document = read("paper_t1.txt");
        QVERIFY(document);
        QCOMPARE(document->elementCounts(), (std::array<std::uint32_t, 5>{539, 0, 1395, 529, 823}));
        base::Progress progress;
        const auto model = render::buildBoardModel(*document, {5000.0, true}, progress);
        QCOMPARE(render::countStandardTriangles(*document, {5000.0, true}), 1'130'956U);
        QCOMPARE(model->repairedAreas, 0U);
    }
};

QTEST_APPLESS_MAIN(NamedBoardsTest)
#include "named_boards_test.moc"
