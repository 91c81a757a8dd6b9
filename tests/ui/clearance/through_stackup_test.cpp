// Distances through the stackup, from the search to the location on the screen, and what ends them.
#include <QtTest>

#include "model/session/session.h"
#include "tests/patience.h"
#include "tests/ui/clearance/clearance_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/shell/message_bar.h"

using ui::ActionId;
using ui::ClearanceModel;
using ui::ClearancePanel;

class ThroughStackupTest : public QObject, protected ClearanceFixture {
    Q_OBJECT

private slots:
    void initTestCase() { open(); }
    void init() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::ThroughStackup));
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::Board));
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void distancesAreListedAndShown() {
        measure();
        const ClearanceModel& locations = window().find<ClearanceModel>();
        QVERIFY(locations.rowCount() > 1);
        const auto throughDielectric = [&] {
            for (int row = 0; row < locations.rowCount(); ++row) {
                if (locations.location(row).throughStackup->height > 0.0) {
                    return row;
                }
            }
            return -1;
        }();
        QVERIFY(throughDielectric >= 0);
        const model::StackupClearance found = *locations.location(throughDielectric).throughStackup;
        std::optional<ui::ShownSpacing> drawn;
        const auto drawing = connect(&window().workspace(), &ui::Workspace::spacingWanted, this,
                                     [&drawn](const std::optional<ui::ShownSpacing>& spacing) { drawn = spacing; });
        panel().setCurrentRow(throughDielectric);
        disconnect(drawing);
        QVERIFY(drawn);
        const model::Measurement label = ui::spacingOn(*window().workspace().board()->index, *drawn);
        QVERIFY(std::abs(label.value() - found.spacing.distance) < 1.0);
        QCOMPARE(label.from.layer, window().document()->layer(found.layerA).name);
        QCOMPARE(label.to.layer, window().document()->layer(found.layerB).name);
        std::vector<model::BoardElement> sides{found.a, found.b};
        std::ranges::sort(sides);
        QTRY_COMPARE(window().selection().selected(), sides);
        const QString layers = locations.index(throughDielectric, ClearanceModel::Layer).data().toString();
        QVERIFY2(layers.contains(", "), qPrintable(layers));  // both sides' layers
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::Layer));
        window().messageBar().hide();
        window().actions()[ActionId::SearchClearances].trigger();
        QVERIFY(window().messageBar().isVisible());  // not of a layer
        window().messageBar().hide();
    }

    void otherThicknessesEndThem() {
        bool isDrawn = false;
        const auto drawing = connect(&window().workspace(), &ui::Workspace::spacingWanted, this,
                                     [&isDrawn](const auto& spacing) { isDrawn = spacing.has_value(); });
        measure();
        const ClearanceModel& locations = window().find<ClearanceModel>();
        QVERIFY(locations.rowCount() > 1);
        QVERIFY(notes().isEmpty());
        panel().setCurrentRow(0);
        QVERIFY(isDrawn);
        setThickness(70'000);
        QCOMPARE(locations.rowCount(), 0);
        QVERIFY(!isDrawn);
        disconnect(drawing);
        QVERIFY2(notes().startsWith("Thicknesses have changed"), qPrintable(notes()));
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
        QVERIFY2(notes().isEmpty(), "these lie on one layer");
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::ThroughStackup));
        QVERIFY(!notes().isEmpty());
        measure();
        QVERIFY(locations.rowCount() > 1);
        QVERIFY(notes().isEmpty());
    }

    void otherThicknessesEndTheSearch() {
        window().actions()[ActionId::SearchClearances].trigger();
        QVERIFY(window().workspace().isWorking());
        setThickness(80'000);
        QVERIFY(!window().workspace().isWorking());
        QCOMPARE(window().find<ClearanceModel>().rowCount(), 0);
        QVERIFY(!notes().isEmpty());
    }

private:
    QString notes() { return label("notes"); }
    void setThickness(model::Nm nm) {
        const model::SetThicknesses set{{{"L02-INNER_LAYER", nm}}, {}};
        window().workspace().restack(
            model::session::applyThicknesses(window().workspace().board()->document, set.all()), set, true);
    }
};

QTEST_MAIN(ThroughStackupTest)
#include "through_stackup_test.moc"
